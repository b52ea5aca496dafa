// SPDX-License-Identifier: Apache-2.0
#include "build/sphere_walls.hpp"

#include <cmath>
#include <cstring>

#include "device/program.hpp"

namespace cdsm::build {

namespace {

/// Fewer spheres are drawn sooner than looked for behind each other.
constexpr std::size_t kFewestSpheres = 4096;
/// Spheres are drawn in rounds of every kStride-th one. What earlier rounds hide is passed over, so that later ones
/// close the gaps that those have left.
constexpr unsigned kStride = 16, kRounds = 8;

const cl::Program& programOf(device::Device& device) { return device.programs().get({"build/draw_walls.cl", {}, {}}); }

std::uint32_t bitsOf(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

SphereWalls::SphereWalls(device::Device& device)
    : depths_(device, 0, "depths of walls"),
      walls_(device, 0, "walls of tiles"),
      hidden_(device, 0, "hidden spheres"),
      drawWalls_(device, programOf(device), "drawWalls"),
      raiseWalls_(device, programOf(device), "raiseWalls"),
      hideSpheres_(device, programOf(device), "hideSpheres") {}

void SphereWalls::run(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view,
                      float leastRadius) {
  const std::size_t tiles = std::size_t(view.tilesX) * view.tilesY;
  walls_.reserve(tiles);
  walls_.fill(INFINITY);
  depths_.reserve(std::size_t(view.width) * view.height);
  depths_.fill(bitsOf(INFINITY));
  std::size_t count = 0;
  for (const PrimitiveRange& range : objects.spheres) count += range.count;
  hidden_.reserve(scene.spheres().size());
  if (count < kFewestSpheres) return hidden_.fill(0);
  for (unsigned round = 0; round < kRounds; ++round) {
    const unsigned offset = round * kStride / kRounds;
    for (const PrimitiveRange& range : objects.spheres) {
      if (range.count <= offset) continue;
      const std::size_t drawn = (range.count - offset + kStride - 1) / kStride;
      drawWalls_({"draw walls of spheres", {drawn}, {64}},
                 {shared::uint(range.first + offset), shared::uint(drawn), kStride, 0}, view, scene.spheres(),
                 objects.objects, walls_, depths_);
    }
    raiseWalls_({"raise walls of tiles", {tiles}, {64}}, view, depths_, walls_);
  }
  for (const PrimitiveRange& range : objects.spheres)
    hideSpheres_({"hide spheres behind walls", {range.count}, {64}},
                 {shared::uint(range.first), shared::uint(range.count), 0, leastRadius}, view, scene.spheres(),
                 objects.objects, walls_, hidden_);
}

}  // namespace cdsm::build
