// SPDX-License-Identifier: Apache-2.0
// What the tests of clusters share: boxes in any pose, lights of all types, what of a scene the planning needs.
#pragma once

#include <vector>

#include "cluster/casters.hpp"
#include "cluster/cluster_plan.hpp"
#include "cluster/light_space.hpp"
#include "reference/test_scenes.hpp"
#include "scene/view.hpp"

namespace cdsm::cluster {

/// Turned by chance, then stretched, then moved.
inline glm::mat4 randomPose(reference::Random& random, const glm::vec3& size, const glm::vec3& position) {
  const glm::vec3 x = random.direction(), y = glm::normalize(glm::cross(x, random.direction()));
  const glm::vec3 z = glm::cross(x, y);
  return {glm::vec4(size.x * x, 0), glm::vec4(size.y * y, 0), glm::vec4(size.z * z, 0), glm::vec4(position, 1)};
}

inline glm::mat4 moved(const glm::vec3& position) {
  glm::mat4 matrix(1.0f);
  matrix[3] = glm::vec4(position, 1.0f);
  return matrix;
}

/// A cube of that half width; its number.
inline unsigned addCube(Scene& scene, const glm::vec3& position, float half, float opacity = 1.0f) {
  return unsigned(reference::addMesh(scene, reference::boxMesh(glm::vec3(-half), glm::vec3(half)),
                                     reference::addMaterial(scene, glm::vec3(0.7f), opacity), moved(position)));
}

/// A square across y; its number.
inline unsigned addFloor(Scene& scene, float height, float half, float opacity = 1.0f) {
  return unsigned(reference::addMesh(scene, reference::quadMesh(glm::vec3(0), {half, 0, 0}, {0, 0, half}),
                                     reference::addMaterial(scene, glm::vec3(0.7f), opacity), moved({0, height, 0})));
}

inline Light spotAt(const glm::vec3& position, const glm::vec3& target, float cutoff) {
  Light light;
  light.name = "key";
  light.position = position;
  light.target = target;
  light.cutoff = cutoff;
  return light;
}

inline Light omniAt(const glm::vec3& position) {
  Light light = spotAt(position, glm::vec3(0.0f), 30.0f);
  light.type = LightType::Omni;
  return light;
}

inline Light sunAlong(const glm::vec3& direction) {
  Light light = omniAt(glm::vec3(0.0f));
  light.type = LightType::Directional;
  light.direction = direction;
  return light;
}

inline VisibleSpace visibleSpaceOf(const Scene& scene) {
  const scene::Bounds bounds = scene::worldBounds(scene);
  return visibleSpace(scene.camera, double(scene.image.width) / double(scene.image.height),
                      scene::cameraNearDepth(scene.camera, bounds), bounds);
}

inline std::vector<Caster> shapesOf(const Scene& scene) {
  KnownShapes shapes;
  return objectShapes(scene, shapes);
}

inline LightPlan planOf(const Scene& scene, const Light& light, Purpose purpose) {
  return planLight(scene, light, shapesOf(scene), visibleSpaceOf(scene), purpose);
}

}  // namespace cdsm::cluster
