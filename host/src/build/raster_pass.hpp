// SPDX-License-Identifier: Apache-2.0
// Triangles and spheres -> fragments of every pixel of a view, sorted from near to far [Knecht 2011, §3.1.1, §3.1.2].
#pragma once

#include <functional>
#include <string>

#include "build/device_scene.hpp"
#include "build/screen_list.hpp"
#include "build/sphere_walls.hpp"
#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "device/scan.hpp"
#include "shared/layer_data.h"
#include "shared/view_data.h"

namespace cdsm::build {

/// Fragments of a view, without those that lie behind an opaque sphere; valid until the next run of the pass that made
/// them. The passes that walk them use them up.
struct Layers {
  shared::ViewData view;
  device::Buffer<std::uint64_t> fragments;
  device::Buffer<shared::uint2> ranges;          ///< per pixel, tile after tile
  device::Buffer<std::uint32_t> initialObjects;  ///< that contain the eye
};

/// Keeps its buffers and lets them grow.
class RasterPass {
 public:
  using Report = std::function<void(const std::string&)>;

  explicit RasterPass(device::Device& device);

  /// Rasterizes these objects of the scene as seen from `view`. Tells `report` what had to be repeated for lack of
  /// room. `leastRadius`: pixels around its centre that a sphere covers at least.
  Layers& run(const DeviceScene& scene, const ObjectSet& objects, shared::ViewData view, const Report& report,
              float leastRadius = 0.0f);

 private:
  using Uints = device::Buffer<std::uint32_t>;
  using Counters = device::Buffer<shared::RasterCounters>;

  void setUpTriangles(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view,
                      const Report& report);
  void setUpSpheres(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view,
                    const Report& report, float leastRadius);
  /// Pairs of all tiles; returns the number of their fragments.
  std::size_t fillTiles(const shared::ViewData& view, std::size_t tiles);

  device::Device& device_;
  device::Scan scan_;
  Layers layers_;
  ScreenList<shared::ScreenTriangle> triangles_;
  ScreenList<shared::ScreenSphere> spheres_;
  TileBuffers tiles_;
  SphereWalls walls_;

  device::Kernel<shared::SetupParams, shared::ViewData, device::Buffer<shared::uint4>, device::Buffer<float>,
                 device::Buffer<shared::ObjectData>, device::Buffer<shared::ScreenTriangle>, Counters, Uints>
      setupTriangles_;
  device::Kernel<shared::SetupParams, shared::ViewData, device::Buffer<shared::SceneSphere>,
                 device::Buffer<shared::ObjectData>, device::Buffer<std::uint8_t>, Uints,
                 device::Buffer<shared::ScreenSphere>, Counters, Uints>
      setupSpheres_;
  using SortKernel = device::Kernel<shared::ViewData, device::Buffer<shared::ScreenTriangle>,
                                    device::Buffer<shared::ScreenSphere>, Uints, Uints, device::Buffer<std::uint64_t>,
                                    Uints, device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>>;
  SortKernel sortFragments_, sortTriangles_;  ///< the latter where no sphere is on the screen
};

}  // namespace cdsm::build
