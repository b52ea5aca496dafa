// SPDX-License-Identifier: Apache-2.0
// The table of closed forms. Those under omni and directional lights are in analytic_lights.cpp.
#include "analytic_cases.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analytic_parts.hpp"
#include "test_scenes.hpp"

namespace cdsm::reference {
namespace {

AnalyticCase slab() { return slabCase("Slab", VoxelType::UInt8, {6, 8, 6}, 0.5f, 0.5f); }
AnalyticCase singleVoxel() { return slabCase("SingleVoxel", VoxelType::Float32, {1, 1, 1}, 0.4f, 1.0f); }
AnalyticCase cappedOpacity() { return slabCase("CappedOpacity", VoxelType::Int16, {6, 8, 6}, 1.0f, 2.0f); }

/// Sheared along the slab, mirrored and turned about the axis: what the light sees stays the same.
AnalyticCase shearedSlab() {
  AnalyticCase result = slabCase("ShearedSlab", VoxelType::UInt16, {8, 8, 8}, 0.5f, 0.5f);
  glm::mat4 shear(1.0f);
  shear[0] = {-0.8f, 0.0f, 0.6f, 0.0f};
  shear[1] = {0.4f, 1.0f, 0.1f, 0.0f};
  shear[2] = {0.6f, 0.0f, 0.8f, 0.0f};
  result.scene.volumes.front().worldFromObject = shear;
  return result;
}

AnalyticCase empty() {
  return {"Empty", emptyScene(), [](const glm::dvec3&) { return 1.0; }, pointsAt(kHeights, 0.25f), 1e-5, 0.0};
}

AnalyticCase overlappingSlabs() {
  AnalyticCase result = slabCase("OverlappingSlabs", VoxelType::UInt8, {6, 8, 6}, 0.3f, 0.5f);
  addVolume(result.scene, slabVolume(VoxelType::Float32, {5, 7, 3}, 0.0f, 1.0f, filled), constantOpacity(0.6f, 1.0f));
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    return std::exp(-sigmaOf(0.3f, 0.5f) * lengthInSlab(scene, p, -0.5, 0.5) -
                    sigmaOf(0.6f, 1.0f) * lengthInSlab(scene, p, 0.0, 1.0));
  };
  return result;
}

/// A linear ramp from 0 at the lower voxel centres to 1 at the upper ones, opacity 0.8 of the value: the integral of
/// -ln(1 - a) over a is (1 - a) ln(1 - a) + a.
AnalyticCase ramp() {
  AnalyticCase result{"Ramp", emptyScene(), {}, pointsAt(kHeights, 0.25f), 1e-3, 5e-3};
  const auto value = [](const glm::dvec3& p) { return p.y / 0.9 + 0.5; };  // ten voxels of 0.1: centres at +-0.45
  addVolume(result.scene, slabVolume(VoxelType::Float32, {4, 10, 4}, -0.5f, 0.5f, value),
            linearOpacity(1.0, 0.8f, 0.5f));
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    const auto primitive = [](double a) { return (1.0 - a) * std::log(1.0 - a) + a; };
    const double low = std::clamp(p.y, -0.45, 0.45);
    const double from = 0.8 * (low / 0.9 + 0.5);
    const double ramped = (primitive(0.8) - primitive(from)) / (0.8 / 0.9);
    const double above = -std::log(1.0 - 0.8) * std::clamp(0.5 - p.y, 0.0, 0.05);
    return std::exp(-(ramped + above) / 0.5 * slant(scene, p));
  };
  return result;
}

AnalyticCase opaqueSheetInSlab() {
  AnalyticCase result = slabCase("OpaqueSheetInSlab", VoxelType::UInt8, {6, 8, 6}, 0.3f, 0.5f);
  addMesh(result.scene, stackMesh(1, 0.0f, 1.0f, kWide), addMaterial(result.scene, glm::vec3(1.0f), 1.0f));
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    return p.y < 0.0 ? 0.0 : std::exp(-sigmaOf(0.3f, 0.5f) * lengthInSlab(scene, p, -0.5, 0.5));
  };
  return result;
}

/// Adds a box of that height, as wide as the slabs, filled with a medium, each face of the given opacity.
void addMediumBox(Scene& scene, float low, float high, float extinction, float opacity) {
  const glm::mat4 mirror(glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
  const int mesh = addMesh(scene, boxMesh({-kWide, low, -kWide}, {kWide, high, kWide}),
                           addMaterial(scene, glm::vec3(1.0f), opacity), mirror);
  scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction = extinction;
}

AnalyticCase mediumBox() {
  AnalyticCase result{"MediumBox", emptyScene(), {}, pointsAt(kHeights, 0.25f), 1e-5, 5e-3};
  addMediumBox(result.scene, -0.5f, 0.5f, 1.25f, 0.25f);
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    const int faces = (p.y < 0.5 ? 1 : 0) + (p.y < -0.5 ? 1 : 0);
    return std::pow(0.75, faces) * std::exp(-1.25 * lengthInSlab(scene, p, -0.5, 0.5));
  };
  return result;
}

AnalyticCase mediumOverSlab() {
  AnalyticCase result = slabCase("MediumOverSlab", VoxelType::UInt8, {6, 8, 6}, 0.3f, 0.5f);
  addMediumBox(result.scene, 0.0f, 1.0f, 0.75f, 0.0f);
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    return std::exp(-sigmaOf(0.3f, 0.5f) * lengthInSlab(scene, p, -0.5, 0.5) - 0.75 * lengthInSlab(scene, p, 0.0, 1.0));
  };
  return result;
}

/// Chord lengths of a sphere around the origin. Its mesh of 96 x 48 is flatter by 1 - cos(pi / 48) = 0.2 % of the
/// radius.
AnalyticCase mediumSphere() {
  AnalyticCase result{"MediumSphere", emptyScene(), {}, {}, 4e-3, 0.02};
  const int mesh =
      addMesh(result.scene, sphereMesh(1.0f, 96, 48, false), addMaterial(result.scene, glm::vec3(1), 0.0f));
  result.scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction = 1.25f;
  result.points = pointsAt({3.0f, 1.5f, 0.6f, 0.1f, -0.3f, -0.6f, -1.5f, -2.5f}, 0.3f);
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    const glm::dvec3 light(scene.lights.front().position);
    const glm::dvec3 direction = glm::normalize(p - light);
    const double nearest = -glm::dot(light, direction);
    const double half = std::sqrt(std::max(0.0, 1.0 - glm::dot(light, light) + nearest * nearest));
    const double end = std::min(glm::length(p - light), nearest + half);
    return std::exp(-1.25 * std::max(0.0, end - (nearest - half)));
  };
  return result;
}

AnalyticCase cutSlab() {
  AnalyticCase result = slabCase("CutSlab", VoxelType::UInt8, {6, 8, 6}, 0.5f, 0.5f);
  result.scene.volumes.front().boundary =
      addMesh(result.scene, boxMesh({-2 * kWide, -0.3f, -2 * kWide}, {2 * kWide, 2.0f, 2 * kWide}),
              addMaterial(result.scene, glm::vec3(1.0f), 0.0f));
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    return std::exp(-sigmaOf(0.5f, 0.5f) * lengthInSlab(scene, p, static_cast<double>(-0.3f), 0.5));
  };
  return result;
}

AnalyticCase lightInSlab() {
  AnalyticCase result = slabCase("LightInSlab", VoxelType::UInt8, {6, 8, 6}, 0.5f, 0.5f);
  Light& light = result.scene.lights.front();
  light.position = {0.0f, 0.25f, 0.0f};
  light.target = {0.0f, -1.0f, 0.0f};
  result.points = pointsAt({0.1f, -0.2f, -0.45f, -0.75f, -2.0f}, 0.03f);
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    return std::exp(-sigmaOf(0.5f, 0.5f) * lengthInSlab(scene, p, -0.5, 0.5));
  };
  return result;
}

AnalyticCase lightInMedium() {
  AnalyticCase result = mediumBox();
  result.name = "LightInMedium";
  Light& light = result.scene.lights.front();
  light.position = {0.0f, 0.25f, 0.0f};
  light.target = {0.0f, -1.0f, 0.0f};
  result.points = pointsAt({0.1f, -0.2f, -0.45f, -0.75f, -2.0f}, 0.03f);
  result.exact = [scene = result.scene](const glm::dvec3& p) {
    return (p.y < -0.5 ? 0.75 : 1.0) * std::exp(-1.25 * lengthInSlab(scene, p, -0.5, 0.5));
  };
  return result;
}

/// Under a spot light.
std::vector<AnalyticCase> spotCases() {
  return {empty(),
          slab(),
          singleVoxel(),
          cappedOpacity(),
          shearedSlab(),
          overlappingSlabs(),
          ramp(),
          stackedSheets("Sheets40", 40, 0.05f, 0.1f),
          stackedSheets("Sheets300", 300, 0.01f, 0.01f),
          opaqueSheetInSlab(),
          mediumBox(),
          mediumOverSlab(),
          mediumSphere(),
          cutSlab(),
          lightInSlab(),
          lightInMedium()};
}

}  // namespace

std::vector<AnalyticCase> analyticCases() {
  std::vector<AnalyticCase> cases = spotCases();
  for (AnalyticCase& analytic : casesOfOtherLights()) cases.push_back(std::move(analytic));
  return cases;
}

std::vector<glm::vec3> unlitPoints(const Light& light) {
  if (light.type != LightType::Spot) return {};
  const glm::vec3 axis = glm::normalize(light.target - light.position);
  const glm::vec3 side = glm::normalize(glm::cross(axis, glm::vec3(0.3f, 0.2f, 0.9f)));
  const float outside = std::tan(glm::radians(light.cutoff + 2.0f));
  return {light.position + 2.0f * axis + 2.0f * outside * side,
          light.position + 4.0f * axis - 4.0f * outside * side,
          light.position + side,
          light.position - 0.001f * side,
          light.position - axis,
          light.position - 3.0f * axis + 0.1f * side};
}

}  // namespace cdsm::reference
