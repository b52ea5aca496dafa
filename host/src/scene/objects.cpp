// SPDX-License-Identifier: Apache-2.0
#include "scene/objects.hpp"

namespace cdsm::scene {

std::size_t firstSpheres(const Scene& scene) { return scene.meshes.size() + scene.volumes.size(); }

std::size_t objectCount(const Scene& scene) { return firstSpheres(scene) + scene.spheres.size(); }

ObjectPlace placeOf(const Scene& scene, std::size_t object) {
  if (object < scene.meshes.size()) return {ObjectKind::Mesh, object};
  if (object < firstSpheres(scene)) return {ObjectKind::Volume, object - scene.meshes.size()};
  return {ObjectKind::Spheres, object - firstSpheres(scene)};
}

const std::string& objectName(const Scene& scene, std::size_t object) {
  const ObjectPlace place = placeOf(scene, object);
  switch (place.kind) {
    case ObjectKind::Mesh:
      return scene.meshes[place.index].name;
    case ObjectKind::Volume:
      return scene.volumes[place.index].name;
    case ObjectKind::Spheres:
      break;
  }
  return scene.spheres[place.index].name;
}

}  // namespace cdsm::scene
