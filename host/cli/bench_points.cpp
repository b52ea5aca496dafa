// SPDX-License-Identifier: Apache-2.0
#include "bench_points.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "scene/view.hpp"

namespace cdsm::cli {
namespace {

constexpr std::size_t kCandidates = 2;  ///< for each point asked for, of which a spot light may not reach some

/// Points of a grid of lines along x, one line after the other.
std::vector<glm::vec3> onLines(const scene::Bounds& box, std::size_t count) {
  const auto lines = std::size_t(std::ceil(std::cbrt(double(count)))), each = count / (lines * lines) + 1;
  std::vector<glm::vec3> points;
  points.reserve(lines * lines * each);
  const auto middle = [](std::size_t i, std::size_t of) { return (float(i) + 0.5f) / float(of); };
  for (std::size_t z = 0; z < lines; ++z)
    for (std::size_t y = 0; y < lines; ++y)
      for (std::size_t x = 0; x < each; ++x)
        points.push_back(glm::mix(box.low, box.high, glm::vec3(middle(x, each), middle(y, lines), middle(z, lines))));
  return points;
}

std::vector<glm::vec3> atRandom(const scene::Bounds& box, std::size_t count) {
  std::mt19937 random(1);
  const auto part = [&random] { return float(random() >> 8) / 16777216.0f; };
  std::vector<glm::vec3> points(count);
  for (glm::vec3& point : points) {
    const float x = part(), y = part(), z = part();
    point = glm::mix(box.low, box.high, glm::vec3(x, y, z));
  }
  return points;
}

/// `count` of the points that the light reaches, again from the first one when there are no more.
std::vector<glm::vec3> reached(Engine& engine, const Scene& scene, const std::string& light,
                               const std::vector<glm::vec3>& points, std::size_t count) {
  const std::vector<Transmittance> light_at = engine.transmittance(scene, light, points);
  std::vector<glm::vec3> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (light_at[i].lit) kept.push_back(points[i]);
  if (kept.empty())
    throw Error("light '" + light + "' reaches no point of the objects' box, must shine on the objects");
  const std::size_t known = kept.size();
  while (kept.size() < count) kept.push_back(kept[kept.size() - known]);
  kept.resize(count);
  return kept;
}

}  // namespace

LookupPoints lookupPoints(Engine& engine, const Scene& scene, const std::string& light, std::size_t count) {
  Scene plain = scene;
  plain.shadows.technique = "none";
  const scene::Bounds box = scene::worldBounds(scene);
  return {reached(engine, plain, light, onLines(box, kCandidates * count), count),
          reached(engine, plain, light, atRandom(box, kCandidates * count), count)};
}

}  // namespace cdsm::cli
