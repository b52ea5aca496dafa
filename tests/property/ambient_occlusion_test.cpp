// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of spheres against rays through the whole hemisphere, and its laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine_paths.hpp"
#include "frames.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kSide = 64;

/// White spheres in ambient light alone: a pixel is what its point sees.
Scene whiteScene(SphereData data) {
  Scene scene = reference::emptyScene();
  scene.lights.clear();
  scene.shadows.technique = "none";
  scene.image.width = scene.image.height = kSide;
  scene.image.ambient = glm::vec3(1.0f);
  scene.camera.position = {0.3f, 0.8f, 5.0f};
  scene.camera.target = glm::vec3(0.0f);
  reference::addSpheres(scene, std::move(data), reference::addMaterial(scene, glm::vec3(1.0f), 1.0f));
  scene.ambientOcclusion.emplace();
  return scene;
}

/// A ball of spheres packed like the atoms of a molecule.
SphereData clump(int count, float radius, std::uint32_t seed) {
  reference::Random random(seed);
  SphereData data;
  for (int i = 0; i < count; ++i) {
    data.centers.push_back(float(std::cbrt(random.uniform(0.0, 1.0))) * random.direction());
    data.radii.push_back(radius * float(random.uniform(0.8, 1.2)));
  }
  return data;
}

struct SeenPoint {
  glm::dvec3 point, normal;
  double factor;  ///< in the picture
};

/// The nearest points of spheres in the picture, every so many pixels.
std::vector<SeenPoint> seenPoints(const Scene& scene, const reference::World& world, int every) {
  const Image image = engineOf("buffer").render(scene);
  std::vector<SeenPoint> points;
  for (int i = every / 2; i < kSide * kSide; i += every) {
    const reference::Ray ray = reference::cameraRay(scene, i % kSide + 0.5, i / kSide + 0.5);
    std::vector<reference::Crossing> crossings;
    world.balls.front().addCrossings(ray, 0, crossings);
    if (crossings.empty()) continue;
    const auto nearest = *std::min_element(crossings.begin(), crossings.end(),
                                           [](const auto& a, const auto& b) { return a.t < b.t; });
    const glm::dvec3 point = ray.at(nearest.t);
    points.push_back({point, world.balls.front().normal(nearest, point), double(image.pixels[std::size_t(i)].x)});
  }
  return points;
}

TEST(AmbientOcclusion, isWhatRaysSay) {
  for (const int count : {1, 30, 300, 3000}) {
    const float radius = count == 1 ? 1.0f : 0.75f / float(std::cbrt(count));
    Scene scene = whiteScene(clump(count, radius, 3));
    scene.ambientOcclusion->distance = 2.0f;
    const reference::World world(scene);
    double sum = 0, squares = 0, sumRef = 0; int n = 0; double worst = 0;
    for (const SeenPoint& p : seenPoints(scene, world, 11)) {
      const double exact = reference::ambientSeen(world, p.point, p.normal, 10.0, 300);
      sum += p.factor - exact; sumRef += exact; squares += (p.factor - exact) * (p.factor - exact); ++n;
      worst = std::max(worst, std::abs(p.factor - exact));
    }
    std::printf("%d spheres: mean exact %.3f, bias %.3f, rms %.3f, worst %.3f, %d points\n", count, sumRef / n, sum / n, std::sqrt(squares / n), worst, n);
  }
}

}  // namespace
}  // namespace cdsm::property
