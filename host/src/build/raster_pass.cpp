// SPDX-License-Identifier: Apache-2.0
#include "build/raster_pass.hpp"

#include "device/program.hpp"

namespace cdsm::build {

namespace {

constexpr ScreenListNames kTriangleNames{"set up triangles",
                                         "count tile pairs",
                                         "count tile pairs of large triangles",
                                         "fill tile pairs",
                                         "fill tile pairs of large triangles",
                                         "screen triangles"};
constexpr ScreenListNames kSphereNames{"set up spheres",
                                       "count tile pairs of spheres",
                                       "count tile pairs of large spheres",
                                       "fill tile pairs of spheres",
                                       "fill tile pairs of large spheres",
                                       "screen spheres"};

const cl::Program& programOf(device::Device& device, const char* file) { return device.programs().get({file, {}, {}}); }

const cl::Program& sortProgram(device::Device& device, const char* spheres) {
  return device.programs().get({"build/sort_fragments.cl", {{"CDSM_SPHERES", spheres}}, {}});
}

}  // namespace

RasterPass::RasterPass(device::Device& device)
    : device_(device),
      scan_(device),
      triangles_(device, "\"build/screen_triangle.clh\"", kTriangleNames),
      spheres_(device, "\"build/screen_sphere.clh\"", kSphereNames),
      walls_(device),
      setupTriangles_(device, programOf(device, "build/setup_triangles.cl"), "setupTriangles"),
      setupSpheres_(device, programOf(device, "build/setup_spheres.cl"), "setupSpheres"),
      sortFragments_(device, sortProgram(device, "1"), "sortFragments"),
      sortTriangles_(device, sortProgram(device, "0"), "sortFragments") {
  const auto name = [&](auto& buffer, const char* text) { buffer = std::decay_t<decltype(buffer)>(device, 0, text); };
  name(tiles_.pairs, "pairs per tile");
  name(tiles_.fragments, "fragments per tile");
  name(tiles_.start, "first pairs of tiles");
  name(tiles_.fragmentStart, "first fragments of tiles");
  name(tiles_.cursor, "cursors of tiles");
  name(tiles_.masks, "coverage masks");
  name(tiles_.owners, "owners of coverage masks");
  name(layers_.fragments, "fragments");
  name(layers_.ranges, "fragment ranges");
}

void RasterPass::setUpTriangles(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view,
                                const Report& report) {
  using List = ScreenList<shared::ScreenTriangle>;
  const auto setUp = [&](const shared::SetupParams& params, List& list) {
    setupTriangles_({list.names().setUp, {params.count}, {List::kGroup}}, params, view, scene.geometry().triangles(),
                    scene.geometry().positions(), objects.objects, list.screen(), list.counters(), list.large());
  };
  triangles_.setUp(objects.triangles, setUp, report);
}

void RasterPass::setUpSpheres(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view,
                              const Report& report, float leastRadius) {
  using List = ScreenList<shared::ScreenSphere>;
  if (objects.spheres.empty()) return spheres_.setUp({}, {}, report);
  walls_.run(scene, objects, view, leastRadius);
  const auto setUp = [&](shared::SetupParams params, List& list) {
    params.leastRadius = leastRadius;
    setupSpheres_({list.names().setUp, {params.count}, {List::kGroup}}, params, view, scene.spheres(), objects.objects,
                  walls_.hidden(), walls_.pixels(), list.screen(), list.counters(), list.large());
  };
  spheres_.setUp(objects.spheres, setUp, report);
}

std::size_t RasterPass::fillTiles(const shared::ViewData& view, std::size_t tiles) {
  tiles_.pairs.reserve(tiles);
  tiles_.fragments.reserve(tiles);
  tiles_.cursor.reserve(tiles);
  tiles_.start.reserve(tiles + 1);
  tiles_.fragmentStart.reserve(tiles + 1);
  tiles_.pairs.fill(0);
  tiles_.fragments.fill(0);
  tiles_.cursor.fill(0);
  triangles_.count(view, tiles_);
  spheres_.count(view, tiles_);
  const std::size_t pairs = scan_(tiles, tiles_.pairs, tiles_.start);
  tiles_.masks.reserve(pairs);
  tiles_.owners.reserve(pairs);
  triangles_.fill(view, tiles_);
  spheres_.fill(view, tiles_);
  return scan_(tiles, tiles_.fragments, tiles_.fragmentStart);
}

Layers& RasterPass::run(const DeviceScene& scene, const ObjectSet& objects, shared::ViewData view, const Report& report,
                        float leastRadius) {
  // asked where rays begin to see: what lies between the eye and the near plane has been passed by then
  const glm::vec3 eye(view.origin.x, view.origin.y, view.origin.z), axis(view.depth.x, view.depth.y, view.depth.z);
  const auto around = scene.objectsAround(objects.enclosing, eye + view.nearDepth * axis);
  view.initialCount = shared::uint(around.size());
  layers_.view = view;
  layers_.initialObjects = Uints::fromHost(device_, around, "objects around the eye");

  const std::size_t tiles = std::size_t(view.tilesX) * view.tilesY;
  layers_.ranges.reserve(tiles * CDSM_TILE_PIXELS);
  setUpTriangles(scene, objects, view, report);
  setUpSpheres(scene, objects, view, report, leastRadius);
  const std::size_t slots = fillTiles(view, tiles) + tiles * CDSM_TILE_PIXELS * around.size();
  if (slots > 0xffffffffu)
    throw DeviceError("a view of " + std::to_string(view.width) + " x " + std::to_string(view.height) +
                      " pixels needs room for " + std::to_string(slots) +
                      " fragments, must be below 2^32; take a smaller image or map");
  layers_.fragments.reserve(slots);
  SortKernel& sort = spheres_.empty() ? sortTriangles_ : sortFragments_;
  sort({"sort fragments", {tiles * CDSM_TILE_PIXELS}, {CDSM_TILE_PIXELS}}, view, triangles_.screen(), spheres_.screen(),
       tiles_.start, tiles_.fragmentStart, tiles_.masks, tiles_.owners, layers_.fragments, layers_.ranges);
  return layers_;
}

}  // namespace cdsm::build
