// SPDX-License-Identifier: Apache-2.0
// How much of their surroundings spheres see: a grid around them that is made once and looked up for every point that
// is shaded [Krone 2017, §4, after Staib 2015] (kernels/occlusion).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <cdsm/scene.hpp>
#include <cdsm/stats.hpp>

#include "build/device_scene.hpp"
#include "device/buffer.hpp"
#include "shared/occlusion_data.h"

namespace cdsm::render {

class OcclusionPass {
 public:
  using Progress = std::function<void(const char* step, float done)>;
  /// Per cell what kernels/occlusion/gather.cl says.
  using Seen = device::Buffer<std::uint64_t>;

  explicit OcclusionPass(device::Device& device) : device_(device), seen_(device, 0, "ambient occlusion") {}

  /// Makes the grid anew if the spheres or the settings have changed; frees it if the scene asks for none. Throws
  /// DeviceError with the bytes needed if it does not fit.
  void prepare(const Scene& scene, const build::DeviceScene& deviceScene, const Progress& progress);

  /// Forgets what it was made for.
  void drop();

  const shared::OcclusionGrid& grid() const { return grid_; }
  const Seen& seen() const { return seen_; }

  /// Nothing without one.
  std::optional<OcclusionStats> stats() const;

 private:
  void fill(const Scene& scene, const build::DeviceScene& deviceScene, const Progress& progress);
  device::Buffer<std::uint32_t> addUp(const shared::OcclusionParams& params, const build::DeviceScene& deviceScene,
                                      float greatestRadius);

  device::Device& device_;
  shared::OcclusionGrid grid_{};
  Seen seen_;
  std::optional<Scene> filled_;  ///< what it was made for: spheres, materials and settings alone
  bool fresh_ = false;           ///< made in the last prepare()
};

}  // namespace cdsm::render
