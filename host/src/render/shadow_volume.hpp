// SPDX-License-Identifier: Apache-2.0
// What lies between a technique and those who shade or ask: nothing, or the cache "volume", which keeps the
// transmittance at every voxel of every volume [Ropinski 2008, §3.1] (kernels/cache).
#pragma once

#include <functional>
#include <optional>

#include "build/device_scene.hpp"
#include "build/variant.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::render {

class ShadowVolume {
 public:
  using Progress = std::function<void(const char* step, float done)>;

  explicit ShadowVolume(device::Device& device) : device_(device) {}

  /// Fills the cache anew if lights, casters or the way shadows are made have changed; frees it if the scene has none.
  /// Throws DeviceError with the bytes needed if it does not fit.
  void prepare(const Scene& scene, const build::DeviceScene& deviceScene,
               const device::Buffer<shared::LightData>& lights, const technique::ShadowTechnique& technique,
               const Progress& progress);

  /// Forgets what it was filled with.
  void drop() {
    voxels_ = {};
    filled_.reset();
  }

  /// Those of the technique, and CDSM_CACHE.
  build::Defines kernelFiles(const technique::ShadowTechnique& technique) const;
  /// Arguments of CDSM_LIGHT_PARAMS behind TechniqueParams.
  device::ArgumentList arguments(const technique::ShadowTechnique& technique) const;

  /// Nothing without a cache.
  std::optional<CacheStats> stats() const;

 private:
  void fill(const build::DeviceScene& deviceScene, std::size_t lightCount,
            const device::Buffer<shared::LightData>& lights, const technique::ShadowTechnique& technique,
            const shared::TechniqueParams& params, const Progress& progress);

  device::Device& device_;
  device::Buffer<std::uint16_t> voxels_;  ///< all volumes of the first light, of the second ...
  std::optional<Scene> filled_;           ///< what it was filled for
  bool fresh_ = false;                    ///< filled in the last prepare()
};

}  // namespace cdsm::render
