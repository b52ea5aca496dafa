// SPDX-License-Identifier: Apache-2.0
#include "render/occlusion_plan.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace cdsm::render {

namespace {

/// One for each of 2 x 2 x 2 cells.
constexpr int kDirectionSets = 8;
/// Empty cells around the spheres: points are looked up in front of them.
constexpr int kMargin = 3;
/// Resolution that is chosen: a cell is so many mean radii wide, if that makes neither too few nor too many cells.
constexpr double kRadiiPerCell = 0.5;
constexpr int kFewestCells = 16, kMostCells = 128;
/// Cells from a point to where it begins to look: nearer ones are its own.
constexpr double kStart = 0.75;
/// Length of a step as part of the width of its cone, and of the way so far at least: 32 steps reach far enough.
constexpr double kStepPart = 0.5, kLeastGrowth = 0.25;
/// Width of the cells that a step looks at as part of the same: they fade into their neighbours, and those as wide as
/// the cone would be dark beside every wall.
constexpr double kCellPart = 0.0625;

int longestSide(const AmbientOcclusion& settings, const SphereExtent& extent, double side) {
  if (settings.resolution > 0) return settings.resolution;
  const double cells = side / (kRadiiPerCell * extent.meanRadius);
  return int(std::ceil(std::clamp(cells, double(kFewestCells), double(kMostCells))));
}

shared::OcclusionGrid gridOf(const glm::dvec3& low, const glm::dvec3& high, double edge) {
  const glm::dvec3 size = high - low, middle = 0.5 * (low + high);
  const glm::ivec3 cells = glm::ivec3(glm::ceil(size / edge - 1e-6)) + 2 * kMargin;
  const glm::dvec3 corner = middle - 0.5 * edge * glm::dvec3(cells);
  return {{glm::vec3(corner), float(edge)}, {cells.x, cells.y, cells.z, 1}};
}

/// Each level is half the one before, rounded up, and has a border.
void addLevels(shared::OcclusionParams& params) {
  glm::ivec3 cells(params.grid.size.x, params.grid.size.y, params.grid.size.z);
  int first = 0;
  for (shared::int4& level : params.levels) {
    level = {cells.x + 2, cells.y + 2, cells.z + 2, first};
    first += level.x * level.y * level.z;
    cells = (cells + 1) / 2;
  }
}

/// Directions stand for cones that share the sphere: their width over their length.
double wideningOf(int directions) {
  const double cosine = 1.0 - 2.0 / double(directions);
  return 2.0 * std::sqrt(1.0 - cosine * cosine) / cosine;
}

/// Steps get longer and cells larger as cones get wider.
void addSteps(shared::OcclusionParams& params, int directions, double distance, double strength) {
  const double widening = wideningOf(directions);
  double begin = kStart;
  while (begin < distance && params.stepCount < CDSM_OCCLUSION_STEPS) {
    const double width = std::max(1.0, widening * begin);
    const double wanted = std::max(kStepPart * width, kLeastGrowth * begin),
                 length = std::min(wanted, distance - begin);
    const double middle = begin + 0.5 * length;
    const double level = std::round(std::log2(std::max(1.0, kCellPart * widening * middle)));
    params.steps[params.stepCount++] = {float(middle), float(length * strength / double(CDSM_OCCLUSION_ONE)),
                                        float(std::min(level, double(CDSM_OCCLUSION_LEVELS - 1))), 0.0f};
    begin += length;
  }
}

/// Depth of the cells around one from which on a seventh of the light at most gets through two of them, which is called
/// none, if directions reach as far; no cell has as much if they do not.
shared::uint buriedDepth(double distance, double strength) {
  const double depth = 1.0 / std::max(strength, 1e-3);  // exp(-2) is left
  const bool reached = distance >= kStart + 2.0 && depth * double(CDSM_OCCLUSION_ONE) <= double(CDSM_OCCLUSION_MOST);
  return reached ? shared::uint(depth * double(CDSM_OCCLUSION_ONE)) : ~0u;
}

/// Unit vectors over the sphere, as even as a spiral makes them.
std::vector<glm::dvec3> spiral(int count) {
  const double turn = 2.0 * glm::pi<double>() / glm::golden_ratio<double>();
  std::vector<glm::dvec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, across = std::sqrt(1.0 - z * z);
    points.emplace_back(across * std::cos(turn * i), across * std::sin(turn * i), z);
  }
  return points;
}

/// Number `i` of `count` rotations, evenly spread [Alexa 2022, super-Fibonacci spirals].
glm::dquat evenRotation(int i, int count) {
  constexpr double kPhi = 1.41421356237309504880, kPsi = 1.53375116875520428812;
  const double s = i + 0.5, r = std::sqrt(s / count), big = std::sqrt(1.0 - s / count);
  const double alpha = 2.0 * glm::pi<double>() * s / kPhi, beta = 2.0 * glm::pi<double>() * s / kPsi;
  return {r * std::sin(alpha), r * std::cos(alpha), big * std::sin(beta), big * std::cos(beta)};
}

}  // namespace

SphereExtent extentOf(const Scene& scene) {
  SphereExtent extent;
  double sum = 0.0;
  std::size_t count = 0;
  for (const Spheres& spheres : scene.spheres) {
    if (scene.materials[std::size_t(spheres.material)].opacity <= 0.0f) continue;
    extent.bounds.add(scene::boundsOf(*spheres.data, spheres.worldFromObject));
    const double scale = scene::scaleOf(spheres.worldFromObject);
    for (const float radius : spheres.data->radii) {
      sum += scale * double(radius);
      extent.greatestRadius = std::max(extent.greatestRadius, scale * double(radius));
    }
    count += spheres.data->radii.size();
  }
  if (count > 0) extent.meanRadius = sum / double(count);
  return extent;
}

std::vector<shared::float4> evenDirections(int count) {
  std::vector<shared::float4> directions;
  const double growth = 1.0 + kStepPart * wideningOf(count);
  for (int set = 0; set < kDirectionSets; ++set)
    for (const glm::dvec3& direction : spiral(count)) {
      const double part = double(directions.size()) / glm::golden_ratio<double>();
      const double scale = std::pow(growth, part - std::floor(part) - 0.5);
      directions.emplace_back(glm::vec3(evenRotation(set, kDirectionSets) * direction), float(scale));
    }
  return directions;
}

shared::OcclusionParams planOcclusion(const AmbientOcclusion& settings, const SphereExtent& extent) {
  const glm::dvec3 low(extent.bounds.low), high(extent.bounds.high), size = high - low;
  const double side = std::max(size.x, std::max(size.y, size.z)), edge = side / longestSide(settings, extent, side);
  shared::OcclusionParams params{};
  params.grid = gridOf(low, high, edge);
  addLevels(params);
  addSteps(params, settings.directions, double(settings.distance) * side / edge, double(settings.strength));
  params.directionCount = shared::uint(settings.directions);
  params.buried = buriedDepth(double(settings.distance) * side / edge, double(settings.strength));
  return params;
}

std::size_t cellsOf(const shared::OcclusionParams& params) {
  const shared::int4& last = params.levels[CDSM_OCCLUSION_LEVELS - 1];
  return std::size_t(last.w) + std::size_t(last.x) * std::size_t(last.y) * std::size_t(last.z);
}

}  // namespace cdsm::render
