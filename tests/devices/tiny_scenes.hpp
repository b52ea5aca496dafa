// SPDX-License-Identifier: Apache-2.0
// Scenes of 16 x 16 pixels and texels at most, small enough for an interpreter of kernels, and what must hold for any
// of them.
#pragma once

#include <string>

#include <cdsm/cdsm.hpp>

namespace cdsm::devices {

/// A shaded volume, an interior medium, a translucent sheet, an opaque floor; the eye and the light are outside.
Scene everythingScene();
/// One smooth volume alone: the paths that skip empty cells and shade in batches.
Scene volumeScene(VoxelType type);
/// A volume that a mesh cuts, seen from inside of the mesh.
Scene cutScene();
/// Many sheets: more nodes than the first chunks and layers have room for.
Scene stackScene();

/// Spheres of many sizes over a floor, smaller than a texel, too.
Scene spheresScene();

Scene along(Scene scene, const std::string& technique, const std::string& memory, const std::string& filter);

/// An engine on the device at hand that fetches as "buffer" or "image".
Engine engineFor(const std::string& fetch);

/// Renders the scene and asks for light "key" at some points; all must be numbers in their range. Returns the bytes of
/// both.
std::string expectSound(Engine& engine, const Scene& scene);

}  // namespace cdsm::devices
