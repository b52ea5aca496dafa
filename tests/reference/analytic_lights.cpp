// SPDX-License-Identifier: Apache-2.0
// Closed forms under omni and directional lights: boxes, in all six directions and across the borders between maps.
#include <algorithm>
#include <cmath>

#include "analytic_parts.hpp"
#include "test_scenes.hpp"

namespace cdsm::reference {
namespace {

// --- Omni lights ---

/// World length of the way from a to b inside of a box.
double lengthInBox(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& low, const glm::dvec3& high) {
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = b[axis] - a[axis];
    if (way == 0.0 && (a[axis] < low[axis] || a[axis] > high[axis])) return 0.0;
    if (way == 0.0) continue;
    begin = std::max(begin, ((way > 0.0 ? low : high)[axis] - a[axis]) / way);
    end = std::min(end, ((way > 0.0 ? high : low)[axis] - a[axis]) / way);
  }
  return std::max(0.0, end - begin) * glm::length(b - a);
}

/// Around the light at these distances along its longest axis: in the six directions, at the edges and corners between
/// the maps and on both sides of them.
std::vector<glm::vec3> pointsAround(const glm::vec3& light, const std::vector<float>& distances) {
  std::vector<glm::vec3> points;
  const float steps[] = {-1.0f, -0.9999f, -0.98f, -0.4f, 0.13f, 0.99f, 1.0f};
  for (const float distance : distances)
    for (int face = 0; face < 6; ++face)
      for (const float u : steps)
        for (const float v : {-0.7f, 0.2f, 0.9999f}) {
          glm::vec3 way;
          way[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
          way[(face / 2 + 1) % 3] = u;
          way[(face / 2 + 2) % 3] = v;
          points.push_back(light + distance * way);
        }
  return points;
}

const glm::vec3 kLamp{0.25f, -0.125f, 0.5f};

Scene omniScene() {
  Scene scene = emptyScene();
  scene.lights.front().type = LightType::Omni;
  scene.lights.front().position = kLamp;
  return scene;
}

AnalyticCase omniEmpty() {
  return {"OmniEmpty", omniScene(), [](const glm::dvec3&) { return 1.0; }, pointsAround(kLamp, {0.1f, 3.0f}),
          1e-5,        0.0};
}

/// Boxes of translucent sheets around the light, one in another: each edge is at a border between two maps.
AnalyticCase omniInBoxes() {
  AnalyticCase result{"OmniInBoxes", omniScene(), {}, pointsAround(kLamp, {0.25f, 0.75f, 1.25f, 1.75f, 4.0f}),
                      1e-5,          1e-5};
  const int glass = addMaterial(result.scene, glm::vec3(1.0f), 0.25f);
  for (const float half : {0.5f, 1.0f, 1.5f}) addMesh(result.scene, boxMesh(kLamp - half, kLamp + half), glass);
  result.exact = [](const glm::dvec3& p) {
    const glm::dvec3 way = glm::abs(p - glm::dvec3(kLamp));
    const double most = std::max({way.x, way.y, way.z});
    return std::pow(0.75, (most > 0.5 ? 1 : 0) + (most > 1.0 ? 1 : 0) + (most > 1.5 ? 1 : 0));
  };
  return result;
}

AnalyticCase omniInMedium() {
  AnalyticCase result{"OmniInMedium", omniScene(), {}, pointsAround(kLamp, {0.1f, 0.3f, 0.6f, 0.9f, 2.5f}),
                      1e-5,           0.015};
  const glm::vec3 low(-1.0f, -0.75f, -0.5f), high(0.75f, 1.25f, 1.0f);
  const int mesh = addMesh(result.scene, boxMesh(low, high), addMaterial(result.scene, glm::vec3(1.0f), 0.0f));
  result.scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction = 0.75f;
  result.exact = [=](const glm::dvec3& p) {
    return std::exp(-0.75 * lengthInBox(glm::dvec3(kLamp), p, glm::dvec3(low), glm::dvec3(high)));
  };
  return result;
}

AnalyticCase omniInVolume() {
  AnalyticCase result{"OmniInVolume", omniScene(), {}, pointsAround(kLamp, {0.1f, 0.3f, 0.6f, 0.9f, 2.5f}),
                      1e-5,           0.015};
  const glm::vec3 low(-1.0f, -0.75f, -0.5f), high(0.75f, 1.25f, 1.0f);
  addVolume(result.scene, makeVolume(VoxelType::UInt8, {7, 8, 6}, low, high, filled), constantOpacity(0.5f, 1.0f));
  result.exact = [=](const glm::dvec3& p) {
    return std::exp(-sigmaOf(0.5f, 1.0f) * lengthInBox(glm::dvec3(kLamp), p, glm::dvec3(low), glm::dvec3(high)));
  };
  return result;
}

/// The slab under a light at the key light's place, which sees nothing on five of its maps.
AnalyticCase omniOverSlab() {
  AnalyticCase result = slabCase("OmniOverSlab", VoxelType::UInt8, {6, 8, 6}, 0.5f, 0.5f);
  result.scene.lights.front().type = LightType::Omni;
  for (const glm::vec3& p : {glm::vec3(0.0f, 6.0f, 0.0f), glm::vec3(3.0f, 4.5f, -2.0f), glm::vec3(-2.0f, 3.0f, 2.0f)})
    result.points.push_back(p);
  return result;
}

// --- Directional lights ---

Scene directionalScene(const glm::vec3& direction) {
  Scene scene = emptyScene();
  scene.lights.front().type = LightType::Directional;
  scene.lights.front().direction = direction;
  return scene;
}

/// A filled box with a translucent surface in the volume's box, along one direction: points in front, inside, behind,
/// and far beside, where no map reaches.
AnalyticCase directionalBox(const std::string& name, const glm::vec3& direction) {
  AnalyticCase result{"Directional" + name, directionalScene(direction), {}, {}, 1e-5, 0.02};
  const glm::vec3 low(1.5f, -0.5f, -0.75f), high(2.5f, 0.5f, 0.75f);
  const int mesh = addMesh(result.scene, boxMesh(low, high), addMaterial(result.scene, glm::vec3(1.0f), 0.25f));
  result.scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction = 0.75f;
  addVolume(result.scene, makeVolume(VoxelType::Int16, {5, 6, 4}, low, high, filled), constantOpacity(0.25f, 1.0f));
  const glm::dvec3 along = glm::normalize(glm::dvec3(direction));
  const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0.3, 0.5, 0.8)));
  const glm::dvec3 up = glm::cross(along, side);
  for (const double depth : {-1e4, -3.0, -0.2, 0.05, 0.3, 2.5, 1e4}) {
    for (const glm::dvec2& at : {glm::dvec2(0.0, 0.0), glm::dvec2(0.11, -0.17), glm::dvec2(-0.23, 0.05)})
      result.points.emplace_back(glm::dvec3(2.0, 0.0, 0.0) + depth * along + at.x * side + at.y * up);
    for (const glm::dvec2& at : {glm::dvec2(4.0, 0.0), glm::dvec2(0.3, -5.0), glm::dvec2(-1e4, 1e5)})
      result.points.emplace_back(glm::dvec3(2.0, 0.0, 0.0) + depth * along + at.x * side + at.y * up);
  }
  result.exact = [=](const glm::dvec3& p) {
    const glm::dvec3 boxLow(low), boxHigh(high);
    const double length = lengthInBox(p - 1e6 * along, p, boxLow, boxHigh);
    const bool inside = glm::all(glm::greaterThan(p, boxLow)) && glm::all(glm::lessThan(p, boxHigh));
    const double surfaces = length > 1e-6 ? (inside ? 0.75 : 0.75 * 0.75) : 1.0;
    return surfaces * std::exp(-(0.75 + sigmaOf(0.25f, 1.0f)) * length);
  };
  return result;
}

/// Farther apart than the depths of neighbouring texels on a slanted sheet.
AnalyticCase directionalSheets() {
  AnalyticCase result = stackedSheets("DirectionalSheets", 10, 0.2f, 0.1f);
  result.scene.lights.front() = directionalScene({0.3f, -1.0f, -0.2f}).lights.front();
  return result;
}

AnalyticCase directionalEmpty() {
  return {"DirectionalEmpty",
          directionalScene({0.0f, 0.0f, 1.0f}),
          [](const glm::dvec3&) { return 1.0; },
          pointsAt(kHeights, 0.25f),
          1e-5,
          0.0};
}

}  // namespace

std::vector<AnalyticCase> casesOfOtherLights() {
  return {omniEmpty(),
          omniInBoxes(),
          omniInMedium(),
          omniInVolume(),
          omniOverSlab(),
          directionalEmpty(),
          directionalSheets(),
          directionalBox("Right", {2.0f, 0.0f, 0.0f}),
          directionalBox("Left", {-1.0f, 0.0f, 0.0f}),
          directionalBox("Up", {0.0f, 1.0f, 0.0f}),
          directionalBox("Down", {0.0f, -1.0f, 0.0f}),
          directionalBox("Front", {0.0f, 0.0f, 0.1f}),
          directionalBox("Back", {0.0f, 0.0f, -1.0f}),
          directionalBox("Slant", {0.3f, -0.8f, 0.4f})};
}

}  // namespace cdsm::reference
