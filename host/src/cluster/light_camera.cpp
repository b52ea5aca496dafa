// SPDX-License-Identifier: Apache-2.0
#include "cluster/light_camera.hpp"

#include <cmath>

#include "scene/view.hpp"

namespace cdsm::cluster {

namespace {

glm::vec3 lightAxis(const Light& light) { return glm::normalize(light.target - light.position); }

/// Half width of the map at distance 1.
float mapTangent(const Light& light, int mapSize) {
  return std::tan(glm::radians(light.cutoff)) * float(mapSize) / float(mapSize - 2);
}

}  // namespace

shared::ViewData spotView(const Light& light, int mapSize, float nearDepth) {
  const glm::vec3 axis = lightAxis(light);
  const glm::vec3 up = std::abs(axis.y) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const float tangent = mapTangent(light, mapSize);
  return scene::perspectiveView(light.position, axis, up, tangent, tangent, mapSize, mapSize, nearDepth);
}

shared::LightData lightData(const Light& light, unsigned firstMap, unsigned mapCount) {
  shared::LightData data{};
  data.position = {light.position, 0.0f};
  data.axis = {lightAxis(light), std::cos(glm::radians(light.cutoff))};
  data.color = {light.color, 0.0f};
  data.firstMap = firstMap;
  data.mapCount = mapCount;
  return data;
}

shared::MapData mapData(const shared::ViewData& view) {
  shared::MapData map{};
  map.texelU = view.pixelU;
  map.texelV = view.pixelV;
  map.texelW = view.pixelW;
  map.depth = view.depth;
  map.dir = view.dir;
  map.dirU = view.dirU;
  map.dirV = view.dirV;
  map.width = view.width;
  map.height = view.height;
  return map;
}

double mapFov(const Light& light, int mapSize) {
  return glm::degrees(2.0 * std::atan(double(mapTangent(light, mapSize))));
}

}  // namespace cdsm::cluster
