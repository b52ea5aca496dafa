// SPDX-License-Identifier: Apache-2.0
// The maps of a scene's light in any memory strategy, and their nodes read back as lookups read them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "build/map_pass.hpp"
#include "build/variant.hpp"
#include "kernel_test.hpp"

namespace cdsm::kernels {

using Nodes = std::vector<shared::float2>;
using Texels = std::vector<Nodes>;  ///< row after row

struct Strategy {
  std::string name;
  std::function<std::unique_ptr<memory::MemoryStrategy>(device::Device&, const memory::NodeFormat&)> make;
};

/// Those that keep every node, the example strategy of the tests among them; `fixed` with so many nodes per texel.
const std::vector<Strategy>& exactStrategies();
Strategy fixedStrategy(int nodesPerTexel);
Strategy strategyNamed(const std::string& name);

/// Map after map of one strategy on one device.
class MapBuilder {
 public:
  MapBuilder(const Strategy& strategy, const std::string& fetch = "buffer", const std::string& format = "float32");

  /// One map of the first light for each scene, all built anew but those whose number among the maps before is in
  /// `kept`. The scenes share their objects. `size`: texels per side.
  void build(const std::vector<Scene>& scenes, int size, std::vector<int> kept = {});

  /// The nodes of every texel of a map, depths as they are stored; repetitions of the last one are left out.
  Texels read(std::size_t map);

  /// Of a format with depths of tiles: their scales, tile after tile.
  std::vector<std::pair<float, float>> tileDepths(std::size_t map) const;

  memory::MemoryStrategy& memory() { return *memory_; }
  const std::vector<shared::MapData>& maps() const { return maps_; }
  const std::vector<std::string>& reports() const { return reports_; }

 private:
  device::Device& device_;
  std::unique_ptr<memory::MemoryStrategy> memory_;
  build::RasterPass raster_;
  build::MapPass pass_;
  std::vector<shared::MapData> maps_;
  std::vector<std::string> reports_;
};

}  // namespace cdsm::kernels
