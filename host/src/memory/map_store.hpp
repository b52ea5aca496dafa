// SPDX-License-Identifier: Apache-2.0
// Finished maps of strategies that keep them one after the other: a run of nodes in a pool, a run of a lookup table.
#pragma once

#include <vector>

#include "memory/memory_strategy.hpp"
#include "memory/node_pool.hpp"
#include "memory/run_buffer.hpp"

namespace cdsm::memory {

class MapStore {
 public:
  MapStore(device::Device& device, const NodeFormat& format);

  /// Forgets all maps but the kept ones (as MemoryStrategy::reserve) and says in `maps` where these are.
  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept);

  /// Room for the nodes of the next map, of which the first `written` are there already.
  void makeRoom(std::size_t nodes, std::size_t written = 0) { pool_.makeRoom(nodes, written); }
  std::size_t room() const { return pool_.room(); }
  /// Where the nodes of the next map go.
  std::size_t nextNode() const { return pool_.used(); }

  /// The next map has `stored` nodes in the pool, counted as `counts`, and `words` in the table: says so in `map`, and
  /// makes room for the words.
  void add(std::size_t index, shared::MapData& map, std::size_t stored, const NodeCounts& counts, std::size_t words);

  /// All maps are there: what is not needed is given back.
  void finish();

  NodeBuffer& nodes() { return pool_.buffer(); }
  const NodeBuffer& nodes() const { return pool_.buffer(); }
  device::Buffer<std::uint32_t>& table() { return table_.buffer(); }
  const device::Buffer<std::uint32_t>& table() const { return table_.buffer(); }
  /// What kernels read nodes from.
  cl::Memory readable() const { return readable_.argument(); }

  NodeCounts nodeCounts(std::size_t index) const { return placed_[index].counts; }
  MemoryStats stats(const char* strategy) const;

 private:
  struct Place {
    Run nodes, words;
    NodeCounts counts;
  };

  device::Device& device_;
  const NodeFormat& format_;
  std::vector<Place> placed_;
  RunBuffer<std::uint32_t> pool_;
  RunBuffer<std::uint32_t> table_;
  ReadablePool readable_;
};

}  // namespace cdsm::memory
