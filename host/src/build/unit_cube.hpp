// SPDX-License-Identifier: Apache-2.0
// The box of a volume as a mesh.
#pragma once

#include <memory>

#include <cdsm/scene.hpp>

namespace cdsm::build {

/// From (0, 0, 0) to (1, 1, 1), counter-clockwise seen from outside.
std::shared_ptr<const MeshData> unitCube();

/// Puts it around the outer faces of the volume's voxels.
glm::mat4 worldFromUnitCube(const Volume& volume);

}  // namespace cdsm::build
