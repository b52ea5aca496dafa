// SPDX-License-Identifier: Apache-2.0
// The host's side of kernels/memory/tile_writer.clh, which the strategies "exact" and "tiled" share.
#pragma once

#include "memory/map_store.hpp"

namespace cdsm::memory {

/// CDSM_TILE_CHUNKS: chunks of nodes in local memory that the texels of a tile share while they are marched.
int tileChunks(const device::Device& device, const Spectrum& spectrum);

/// Each tile reserves its place in the pool when it has been marched. Maps with tiles that did not fit into scratch
/// memory or pool are built once more, those tiles alone.
class TileStrategy : public MemoryStrategy {
 public:
  /// Fill: one march, and a second one for the tiles that did not fit. Count: a march of all tiles that counts, a
  /// prefix sum over the tiles, a march that fills: what Fill must agree with.
  enum class Mode { Fill, Count };

  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) override;
  void beginMap() override;
  bool finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) override;
  void finish() override;
  shared::MemoryParams params() const override;
  device::ArgumentList writeArguments() const override;
  device::ArgumentList readArguments() const override;
  NodeCounts nodeCounts(std::size_t index) const override { return store_.nodeCounts(index); }

 protected:
  using Uints = device::Buffer<std::uint32_t>;

  /// `recordWords`: CDSM_RECORD_WORDS.
  TileStrategy(device::Device& device, const NodeFormat& format, std::size_t recordWords, Mode mode);

  /// The finished map in `store_`: its table made of that of the build, records_.
  virtual void addMap(std::size_t index, shared::MapData& map, std::size_t stored,
                      const shared::BuildCounters& counters) = 0;
  /// Mode::Count: moves a tile's record to where its nodes start; returns the room that the tile needs.
  virtual std::uint32_t moveRecord(std::uint32_t* record, std::uint32_t first) const = 0;

  device::Device& device_;
  MapStore store_;
  Uints records_;  ///< of the map being built

 private:
  void placeInOrder(std::size_t tiles);

  std::size_t recordWords_;
  Mode mode_;
  bool fill_ = false;         ///< the map's tiles have been counted
  std::size_t tileRoom_ = 0;  ///< nodes per tile that were enough before: an animation does not grow in every frame
  std::size_t mostTiles_ = 0;
  Uints unfilled_;
  device::Buffer<shared::BuildCounters> counters_;
};

}  // namespace cdsm::memory
