// SPDX-License-Identifier: Apache-2.0
// How the nodes of deep shadow maps are kept. A strategy is one kernel file (kernels/memory/NAME.clh: how nodes are
// written and read), one pair of host files and one line in the registry.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <cdsm/stats.hpp>

#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "memory/node_format.hpp"
#include "memory/tile_depths.hpp"
#include "shared/map_data.h"

namespace cdsm::memory {

/// Nodes of one finished map.
struct NodeCounts {
  std::uint64_t total = 0;
  std::uint64_t most = 0;  ///< of a texel
};

/// The nodes of all maps. Use: reserve() once for all maps; then for each map that is not taken over beginMap(), the
/// build kernel with writeArguments(), finishMap(); finish() after the last one; then readArguments().
class MemoryStrategy {
 public:
  MemoryStrategy(device::Device& device, const NodeFormat& format) : format_(format), tileDepths_(device, format) {}
  virtual ~MemoryStrategy() = default;

  /// Path of the kernel file.
  virtual const char* kernelFile() const = 0;

  /// Makes room for these maps and says in each where its part of the bookkeeping is. kept[i]: number, among the maps
  /// before, of the one whose nodes map i takes over, or kBuildAnew. Throws DeviceError if that is too much.
  virtual void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) = 0;
  virtual void beginMap() = 0;
  /// Says in `maps` where the nodes of map `index` are. False: room was made, the map has to be built again; the reason
  /// is in `why`.
  virtual bool finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) = 0;
  virtual void finish() = 0;

  virtual shared::MemoryParams params() const = 0;
  /// Arguments of CDSM_MEMORY_WRITE_PARAMS behind MemoryParams.
  virtual device::ArgumentList writeArguments() const = 0;
  /// Arguments of CDSM_MEMORY_READ_BUFFERS.
  virtual device::ArgumentList readArguments() const = 0;

  virtual NodeCounts nodeCounts(std::size_t index) const = 0;
  virtual MemoryStats stats() const = 0;

  const NodeFormat& format() const { return format_; }
  /// Not a strategy's business: who builds maps reserves them, stats() are without them.
  TileDepths& tileDepths() { return tileDepths_; }
  const TileDepths& tileDepths() const { return tileDepths_; }

 private:
  const NodeFormat& format_;
  TileDepths tileDepths_;
};

}  // namespace cdsm::memory
