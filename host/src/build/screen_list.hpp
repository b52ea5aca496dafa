// SPDX-License-Identifier: Apache-2.0
// Triangles, or spheres, on the screen of a view, and the pairs of coverage mask and owner that they give its tiles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "build/geometry.hpp"
#include "device/kernel.hpp"
#include "device/program.hpp"
#include "shared/layer_data.h"
#include "shared/view_data.h"

namespace cdsm::build {

/// Buffers of the tiles of a view that all lists add to.
struct TileBuffers {
  using Uints = device::Buffer<std::uint32_t>;
  Uints pairs, fragments, start, fragmentStart, cursor;
  device::Buffer<std::uint64_t> masks;
  Uints owners;
};

/// Names of launches.
struct ScreenListNames {
  const char *setUp, *count, *countLarge, *fill, *fillLarge;
  const char* screen;  ///< of the buffer
};

/// `Primitive`: shared::ScreenTriangle or shared::ScreenSphere; `kernelFile`: CDSM_PRIMITIVE. Keeps its buffers.
template <class Primitive>
class ScreenList {
 public:
  using Screen = device::Buffer<Primitive>;
  using Counters = device::Buffer<shared::RasterCounters>;
  using Uints = TileBuffers::Uints;
  using Report = std::function<void(const std::string&)>;
  /// Sets up the primitives of params.first .. params.first + params.count - 1.
  using SetUp = std::function<void(const shared::SetupParams& params, ScreenList& list)>;

  ScreenList(device::Device& device, const char* kernelFile, const ScreenListNames& names)
      : names_(names),
        counters_(device, 1, "raster counters"),
        countPairs_(device, program(device, kernelFile), "countPairs"),
        countPairsLarge_(device, program(device, kernelFile), "countPairsLarge"),
        fillPairs_(device, program(device, kernelFile), "fillPairs"),
        fillPairsLarge_(device, program(device, kernelFile), "fillPairsLarge"),
        screen_(device, 0, names.screen),
        large_(device, 0, "large primitives") {}

  /// Puts the primitives on the screen; tells `report` when there was too little room.
  void setUp(const std::vector<PrimitiveRange>& ranges, const SetUp& setUpRange, const Report& report) {
    std::size_t count = 0;
    for (const PrimitiveRange& range : ranges) count += range.count;
    wanted_ = 0;
    if (count == 0) return;
    screen_.reserve(count + kSpare);
    large_.reserve(screen_.size());
    for (;;) {
      params_.capacity = shared::uint(screen_.size());
      counters_.fill({});
      for (const PrimitiveRange& range : ranges) {
        params_.first = shared::uint(range.first);
        params_.count = shared::uint(range.count);
        setUpRange(params_, *this);
      }
      wanted_ = counters_.read(0).wanted;
      if (wanted_ <= screen_.size()) return;
      report("room for " + std::string(names_.screen) + " grown from " + std::to_string(screen_.size()) + " to " +
             std::to_string(wanted_) + ", clipping made more of them; set up again");
      screen_.reserve(wanted_);
      large_.reserve(screen_.size());
    }
  }

  /// Adds the pairs of each tile to tiles.pairs.
  void count(const shared::ViewData& view, TileBuffers& tiles) {
    if (wanted_ == 0) return;
    countPairs_({names_.count, {wanted_}, {kGroup}}, params_, view, screen_, counters_, tiles.pairs);
    countPairsLarge_({names_.countLarge, {kLargeGroups * kGroup}, {kGroup}}, params_, view, screen_, counters_, large_,
                     tiles.pairs);
  }

  /// Writes them, and adds their fragments to tiles.fragments.
  void fill(const shared::ViewData& view, TileBuffers& tiles) {
    if (wanted_ == 0) return;
    fillPairs_({names_.fill, {wanted_}, {kGroup}}, params_, view, screen_, counters_, tiles.start, tiles.cursor,
               tiles.fragments, tiles.masks, tiles.owners);
    fillPairsLarge_({names_.fillLarge, {kLargeGroups * kGroup}, {kGroup}}, params_, view, screen_, counters_, large_,
                    tiles.start, tiles.cursor, tiles.fragments, tiles.masks, tiles.owners);
  }

  /// Nothing of them is on the screen.
  bool empty() const { return wanted_ == 0; }

  const ScreenListNames& names() const { return names_; }
  const Screen& screen() const { return screen_; }
  const Counters& counters() const { return counters_; }
  const Uints& large() const { return large_; }

  static constexpr std::size_t kGroup = 64;

 private:
  using Masks = device::Buffer<std::uint64_t>;
  static constexpr std::size_t kLargeGroups = 128;
  static constexpr std::size_t kSpare = 64;  ///< for the first clipped triangles

  static const cl::Program& program(device::Device& device, const char* kernelFile) {
    return device.programs().get({"build/rasterize.cl", {{"CDSM_PRIMITIVE", kernelFile}}, {}});
  }

  ScreenListNames names_;
  shared::SetupParams params_{};
  std::size_t wanted_ = 0;
  Counters counters_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints> countPairs_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints> countPairsLarge_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints, Uints, Masks, Uints> fillPairs_;
  device::Kernel<shared::SetupParams, shared::ViewData, Screen, Counters, Uints, Uints, Uints, Uints, Masks, Uints>
      fillPairsLarge_;
  Screen screen_;
  Uints large_;
};

}  // namespace cdsm::build
