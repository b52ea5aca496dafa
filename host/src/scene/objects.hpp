// SPDX-License-Identifier: Apache-2.0
// The numbers of a scene's objects: meshes first, then volumes, then spheres.
#pragma once

#include <cstddef>
#include <string>

#include <cdsm/scene.hpp>

namespace cdsm::scene {

enum class ObjectKind { Mesh, Volume, Spheres };

/// Where an object is found: in the scene's list of its kind.
struct ObjectPlace {
  ObjectKind kind;
  std::size_t index;
};

std::size_t objectCount(const Scene& scene);
ObjectPlace placeOf(const Scene& scene, std::size_t object);
const std::string& objectName(const Scene& scene, std::size_t object);

/// Number of the first spheres.
std::size_t firstSpheres(const Scene& scene);

}  // namespace cdsm::scene
