// SPDX-License-Identifier: Apache-2.0
#include "build/raster_pass.hpp"

#include "device/program.hpp"

namespace cdsm::build {

namespace {

constexpr std::size_t kGroup = 64;
constexpr std::size_t kLargeGroups = 128;

const cl::Program& rasterProgram(device::Device& device) {
  return device.programs().get({"build/rasterize.cl", {}, {}});
}
const cl::Program& sortProgram(device::Device& device) {
  return device.programs().get({"build/sort_fragments.cl", {}, {}});
}

}  // namespace

RasterPass::RasterPass(device::Device& device)
    : device_(device),
      scan_(device),
      counters_(device, 1, "raster counters"),
      setupTriangles_(device, rasterProgram(device), "setupTriangles"),
      countPairs_(device, rasterProgram(device), "countPairs"),
      countPairsLarge_(device, rasterProgram(device), "countPairsLarge"),
      fillPairs_(device, rasterProgram(device), "fillPairs"),
      fillPairsLarge_(device, rasterProgram(device), "fillPairsLarge"),
      sortFragments_(device, sortProgram(device), "sortFragments") {
  const auto name = [&](auto& buffer, const char* text) { buffer = std::decay_t<decltype(buffer)>(device, 0, text); };
  name(screen_, "screen triangles");
  name(large_, "large triangles");
  name(tilePairs_, "pairs per tile");
  name(tileFragments_, "fragments per tile");
  name(tileStart_, "first pairs of tiles");
  name(tileFragmentStart_, "first fragments of tiles");
  name(tileCursor_, "cursors of tiles");
  name(masks_, "coverage masks");
  name(owners_, "triangles of coverage masks");
  name(layers_.fragments, "fragments");
  name(layers_.ranges, "fragment ranges");
}

void RasterPass::setup(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view,
                       const Report& report) {
  std::size_t triangles = 0;
  for (const TriangleRange& range : objects.triangles) triangles += range.count;
  screen_.reserve(triangles + 64);
  large_.reserve(screen_.size());
  for (;;) {
    params_.capacity = shared::uint(screen_.size());
    counters_.fill({});
    for (const TriangleRange& range : objects.triangles) {
      params_.firstTriangle = shared::uint(range.first);
      params_.triangleCount = shared::uint(range.count);
      setupTriangles_({"set up triangles", {range.count}, {kGroup}}, params_, view, scene.geometry().triangles(),
                      scene.geometry().positions(), objects.objects, screen_, counters_, large_);
    }
    const std::size_t wanted = counters_.read(0).screenTriangles;
    screenTriangles_ = wanted;
    if (wanted <= screen_.size()) return;
    report("room for screen triangles grown from " + std::to_string(screen_.size()) + " to " + std::to_string(wanted) +
           ", clipping made more of them; triangles set up again");
    screen_.reserve(wanted);
    large_.reserve(screen_.size());
  }
}

void RasterPass::countTiles(const shared::ViewData& view) {
  tilePairs_.fill(0);
  tileFragments_.fill(0);
  countPairs_({"count tile pairs", {screenTriangles_}, {kGroup}}, params_, view, screen_, counters_, tilePairs_,
              tileFragments_);
  countPairsLarge_({"count tile pairs of large triangles", {kLargeGroups * kGroup}, {kGroup}}, params_, view, screen_,
                   counters_, large_, tilePairs_, tileFragments_);
}

void RasterPass::fillTiles(const shared::ViewData& view) {
  tileCursor_.fill(0);
  fillPairs_({"fill tile pairs", {screenTriangles_}, {kGroup}}, params_, view, screen_, counters_, tileStart_,
             tileCursor_, masks_, owners_);
  fillPairsLarge_({"fill tile pairs of large triangles", {kLargeGroups * kGroup}, {kGroup}}, params_, view, screen_,
                  counters_, large_, tileStart_, tileCursor_, masks_, owners_);
}

Layers& RasterPass::run(const DeviceScene& scene, const ObjectSet& objects, shared::ViewData view,
                        const Report& report) {
  // asked where rays begin to see: what lies between the eye and the near plane has been passed by then
  const glm::vec3 eye(view.origin.x, view.origin.y, view.origin.z), axis(view.depth.x, view.depth.y, view.depth.z);
  const auto around = scene.objectsAround(objects.enclosing, eye + view.nearDepth * axis);
  view.initialCount = shared::uint(around.size());
  layers_.view = view;
  layers_.initialObjects = Uints::fromHost(device_, around, "objects around the eye");

  const std::size_t tiles = std::size_t(view.tilesX) * view.tilesY;
  tilePairs_.reserve(tiles);
  tileFragments_.reserve(tiles);
  tileCursor_.reserve(tiles);
  tileStart_.reserve(tiles + 1);
  tileFragmentStart_.reserve(tiles + 1);
  layers_.ranges.reserve(tiles * CDSM_TILE_PIXELS);

  setup(scene, objects, view, report);
  countTiles(view);
  const std::size_t pairs = scan_(tiles, tilePairs_, tileStart_);
  const std::size_t fragments = scan_(tiles, tileFragments_, tileFragmentStart_);
  const std::size_t slots = fragments + tiles * CDSM_TILE_PIXELS * around.size();
  if (slots > 0xffffffffu)
    throw DeviceError("a view of " + std::to_string(view.width) + " x " + std::to_string(view.height) +
                      " pixels needs room for " + std::to_string(slots) +
                      " fragments, must be below 2^32; take a smaller image or map");
  masks_.reserve(pairs);
  owners_.reserve(pairs);
  layers_.fragments.reserve(slots);
  fillTiles(view);
  sortFragments_({"sort fragments", {tiles * CDSM_TILE_PIXELS}, {CDSM_TILE_PIXELS}}, view, screen_, tileStart_,
                 tileFragmentStart_, masks_, owners_, layers_.fragments, layers_.ranges);
  return layers_;
}

}  // namespace cdsm::build
