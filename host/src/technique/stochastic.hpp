// SPDX-License-Identifier: Apache-2.0
// Technique "stochastic": per texel the depths at which three photons were stopped, by chance; what gets through is the
// part of the photons of many texels [Weidner & Linsen 2018].
#pragma once

#include "build/depth_pass.hpp"
#include "technique/map_technique.hpp"

namespace cdsm::technique {

class Stochastic : public MapTechnique {
 public:
  static constexpr std::size_t kPhotons = 3;  ///< per texel
  static constexpr std::size_t kReadAtOnce = 8;

  explicit Stochastic(device::Device& device) : MapTechnique(device), pass_(device, kPhotons, kReadAtOnce) {}

  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", "\"technique/stochastic.clh\""}}; }
  /// Differences of neighbouring lookups are noise, up to its standard deviation.
  float lookupTolerance(const Scene& scene) const override;
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override { return {maps().cl(), pass_.depths().cl()}; }

 private:
  std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                         std::vector<MapCluster>& clusters) override;
  memory::NodeCounts nodeCounts(std::size_t map) const override;
  MemoryStats memoryStats() const override;

  build::DepthPass pass_;
  std::vector<std::size_t> texels_;  ///< per map
};

}  // namespace cdsm::technique
