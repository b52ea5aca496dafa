// SPDX-License-Identifier: Apache-2.0
// Triangles -> fragments of every pixel of a view, sorted from near to far [Knecht 2011, §3.1.1, §3.1.2].
#pragma once

#include <functional>
#include <string>

#include "build/device_scene.hpp"
#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "device/scan.hpp"
#include "shared/layer_data.h"
#include "shared/view_data.h"

namespace cdsm::build {

/// Fragments of a view; valid until the next run of the pass that made them. The passes that walk them use them up.
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
  /// room.
  Layers& run(const DeviceScene& scene, const ObjectSet& objects, shared::ViewData view, const Report& report);

 private:
  using Uints = device::Buffer<std::uint32_t>;
  using Screen = device::Buffer<shared::ScreenTriangle>;
  using Counters = device::Buffer<shared::RasterCounters>;

  void setup(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view, const Report& report);
  void countTiles(const shared::ViewData& view);
  void fillTiles(const shared::ViewData& view);

  device::Device& device_;
  device::Scan scan_;
  Layers layers_;
  shared::SetupParams params_{};
  std::size_t screenTriangles_ = 0;
  Screen screen_;
  Counters counters_;
  Uints large_, tilePairs_, tileFragments_, tileStart_, tileFragmentStart_, tileCursor_, owners_;
  device::Buffer<std::uint64_t> masks_;

  device::Kernel<shared::SetupParams, shared::ViewData, device::Buffer<shared::uint4>, device::Buffer<float>,
                 device::Buffer<shared::ObjectData>, Screen, Counters, Uints>
      setupTriangles_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints> countPairs_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints, Uints> countPairsLarge_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints, device::Buffer<std::uint64_t>,
                 Uints>
      fillPairs_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints, Uints,
                 device::Buffer<std::uint64_t>, Uints>
      fillPairsLarge_;
  device::Kernel<shared::ViewData, Screen, Uints, Uints, device::Buffer<std::uint64_t>, Uints,
                 device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>>
      sortFragments_;
};

}  // namespace cdsm::build
