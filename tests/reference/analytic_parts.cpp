// SPDX-License-Identifier: Apache-2.0
// Slabs lie across y and reach beyond the cone, so that a ray's length in a slab is its height over the cosine to the
// axis.
#include "analytic_parts.hpp"

#include <algorithm>
#include <cmath>

#include "test_scenes.hpp"

namespace cdsm::reference {
namespace {

double distanceFromLight(const Scene& scene, const glm::dvec3& p) {
  return glm::length(p - glm::dvec3(scene.lights.front().position));
}

}  // namespace

double slant(const Scene& scene, const glm::dvec3& p) {
  return distanceFromLight(scene, p) / std::abs(p.y - static_cast<double>(scene.lights.front().position.y));
}

double sigmaOf(float opacity, float unitDistance) {
  return -std::log(1.0 - static_cast<double>(opacity)) / static_cast<double>(unitDistance);
}

double lengthInSlab(const Scene& scene, const glm::dvec3& p, double low, double high) {
  const double top = std::min(high, static_cast<double>(scene.lights.front().position.y));
  return std::max(0.0, top - std::max(low, p.y)) * slant(scene, p);
}

std::vector<glm::vec3> pointsAt(const std::vector<float>& heights, float largestRadius) {
  std::vector<glm::vec3> points;
  for (float y : heights) {
    for (int i = 0; i < 6; ++i) {
      const float radius = largestRadius * static_cast<float>(i) / 5.0f;
      const float angle = 0.4f + 2.4f * static_cast<float>(i);
      points.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
    }
  }
  return points;
}

double filled(const glm::dvec3&) { return 1.0; }

VolumeData slabVolume(VoxelType type, const glm::uvec3& size, float low, float high, const Field& field) {
  return makeVolume(type, size, {-kWide, low, -kWide}, {kWide, high, kWide}, field);
}

AnalyticCase slabCase(const std::string& name, VoxelType type, const glm::uvec3& size, float opacity, float unit) {
  AnalyticCase result{name, emptyScene(), {}, pointsAt(kHeights, 0.25f), 1e-5, 5e-3};
  addVolume(result.scene, slabVolume(type, size, -0.5f, 0.5f, filled), constantOpacity(opacity, unit));
  const double sigma = sigmaOf(std::min(opacity, 0.9999f), unit);
  result.exact = [scene = result.scene, sigma](const glm::dvec3& p) {
    return std::exp(-sigma * lengthInSlab(scene, p, -0.5, 0.5));
  };
  return result;
}

AnalyticCase stackedSheets(const std::string& name, int count, float spacing, float opacity) {
  AnalyticCase result{name, emptyScene(), {}, {}, 1e-5, 1e-5};
  const float top = 1.5f;
  addMesh(result.scene, stackMesh(count, top, spacing, kWide), addMaterial(result.scene, glm::vec3(1.0f), opacity));
  std::vector<float> heights{3.0f};
  for (int i = 0; i < count; i += std::max(1, count / 7)) {
    heights.push_back(top - spacing * (static_cast<float>(i) + 0.5f));
  }
  heights.push_back(top - spacing * static_cast<float>(count) - 0.5f);
  result.points = pointsAt(heights, 0.25f);
  result.exact = [=](const glm::dvec3& p) {
    const double above = std::ceil((static_cast<double>(top) - p.y) / static_cast<double>(spacing));
    return std::pow(1.0 - static_cast<double>(opacity), std::clamp(above, 0.0, static_cast<double>(count)));
  };
  return result;
}

}  // namespace cdsm::reference
