// SPDX-License-Identifier: Apache-2.0
// What techniques share that keep the same number of floats for each texel: where light is stopped, and by what.
#pragma once

#include "build/depth_pass.hpp"
#include "technique/map_technique.hpp"

namespace cdsm::technique {

class DepthTechnique : public MapTechnique {
 public:
  /// What a texel holds, and how it is looked up.
  struct Texel {
    const char* kernelFile;  ///< CDSM_TECHNIQUE, in quotes
    const char* strategy;    ///< in the statistics
    std::size_t nodes;
    std::size_t floatsPerNode;
    std::size_t readAtOnce;  ///< floats, also behind the last texel
  };

  DepthTechnique(device::Device& device, const Texel& texel)
      : MapTechnique(device), texel_(texel), pass_(device, texel.nodes * texel.floatsPerNode, texel.readAtOnce) {}

  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", texel_.kernelFile}}; }
  device::ArgumentList arguments() const override { return {maps().cl(), pass_.depths().cl()}; }

 protected:
  /// What stops the light; its buffers stay until the maps are built.
  virtual build::StopRule stopRule(const Preparation& to) = 0;

 private:
  std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                         std::vector<MapCluster>& clusters) override;
  memory::NodeCounts nodeCounts(std::size_t map) const override;
  MemoryStats memoryStats() const override;

  Texel texel_;
  build::DepthPass pass_;
  std::vector<std::size_t> texels_;  ///< per map
};

}  // namespace cdsm::technique
