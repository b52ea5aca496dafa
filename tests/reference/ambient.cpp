// SPDX-License-Identifier: Apache-2.0
// What of its surroundings a point sees: rays through the hemisphere, each against every sphere.
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "reference.hpp"

namespace cdsm::reference {

namespace {

/// Relative to the distance: crossings nearer than that are those of the point's own sphere.
constexpr double kOwn = 1e-9;

bool isBlocked(const World& world, const Ray& ray, double distance) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < world.balls.size(); ++i) world.balls[i].addCrossings(ray, int(i), crossings);
  return std::any_of(crossings.begin(), crossings.end(),
                     [&](const Crossing& c) { return c.t > kOwn * distance && c.t < distance; });
}

}  // namespace

double ambientSeen(const World& world, const glm::dvec3& point, const glm::dvec3& normal, double distance, int rays) {
  const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, other)), v = glm::cross(normal, u);
  int free = 0;
  for (int i = 0; i < rays; ++i) {  // even on the disk below the hemisphere: cosine-weighted [Malley]
    const double across = std::sqrt((i + 0.5) / rays),
                 angle = 2.0 * glm::pi<double>() * i / glm::golden_ratio<double>();
    const glm::dvec3 way =
        across * (std::cos(angle) * u + std::sin(angle) * v) + std::sqrt(1.0 - across * across) * normal;
    free += !isBlocked(world, {point, way}, distance);
  }
  return double(free) / rays;
}

}  // namespace cdsm::reference
