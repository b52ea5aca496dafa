// SPDX-License-Identifier: Apache-2.0
// Tiny scenes built in code: parts (meshes, volumes) and whole random scenes. Most have one spot light "key" straight
// above the origin at (0, 4, 0) that looks down.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

#include "parts.hpp"

namespace cdsm::reference {

/// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
  int integer(int low, int high) { return low + static_cast<int>(uniform(0.0, high - low + 1.0)); }  ///< both inclusive
  glm::vec3 direction();

 private:
  std::mt19937 engine_;
};

// --- Meshes, object space, outward normals where closed
// -----------------------------------------------------------------
MeshData boxMesh(const glm::vec3& low, const glm::vec3& high);
MeshData quadMesh(const glm::vec3& center, const glm::vec3& halfU, const glm::vec3& halfV);
/// Closed latitude-longitude sphere around the origin, with smooth normals if asked for.
MeshData sphereMesh(float radius, int slices, int stacks, bool smooth);
/// Quads across y, the first at `top`, each `spacing` below the one before, of half width `half`.
MeshData stackMesh(int count, float top, float spacing, float half);

// --- Volumes
// ------------------------------------------------------------------------------------------------------------
using Field = std::function<double(const glm::dvec3&)>;  ///< value at a point of the object-space box

/// A grid that fills the box from `low` to `high` (its voxels' outer faces), values taken from the field at the voxel
/// centres. Integer types hold round(value * largest of the type), clamped; floats the value itself.
VolumeData makeVolume(VoxelType type, const glm::uvec3& size, const glm::vec3& low, const glm::vec3& high,
                      const Field& field);
/// What a field value of 1 becomes in the file's own values: 255 for UInt8, 32767 for Int16, 1 for Float32 and so on.
double largestValue(VoxelType type);

double gaussianBlob(const glm::dvec3& p);  ///< around the origin, 1 in its middle, 0.018 at distance 1
double noise(const glm::dvec3& p);         ///< smooth, one bump per unit, about 0 to 1
double smoke(const glm::dvec3& p);         ///< three octaves of noise that fade to 0 at distance 1 from the origin

// --- Scenes
// -------------------------------------------------------------------------------------------------------------
Light keyLight();
/// A scene with the key light, a camera at (0, 1, 6), no objects.
Scene emptyScene();
/// Return the index of what they add.
int addMaterial(Scene& scene, const glm::vec3& diffuse, float opacity);
int addMesh(Scene& scene, MeshData data, int material, const glm::mat4& worldFromObject = glm::mat4(1.0f));
int addVolume(Scene& scene, VolumeData data, const TransferFunction& transfer,
              const glm::mat4& worldFromObject = glm::mat4(1.0f));

int addSpheres(Scene& scene, SphereData data, int material, const glm::mat4& worldFromObject = glm::mat4(1.0f));

/// The same opacity for every value.
TransferFunction constantOpacity(float opacity, float unitDistance);
/// Opacity 0 at value 0, `opacity` at `value`, linear between.
TransferFunction linearOpacity(double value, float opacity, float unitDistance);

/// 1-3 volumes in random affine frames with random transfer functions, 1-4 meshes (opaque, translucent, filled with a
/// medium, cutting a volume), 1-2 spot lights outside of everything. The same for the same seed.
Scene randomScene(std::uint32_t seed);

/// Two sets of spheres of many sizes in random similarities, opaque ones and translucent ones with their own colours,
/// among a random scene's objects. The same for the same seed.
void addRandomSpheres(Scene& scene, std::uint32_t seed);

/// Lets each object cast or not and receive or not, by chance. The same for the same seed.
void giveRandomRoles(Scene& scene, std::uint32_t seed);

/// Lets surfaces, interiors and volumes colour the light that gets through, and sets shadows.transmittance to "rgb".
/// The same for the same seed.
void giveRandomTransmissions(Scene& scene, std::uint32_t seed);

/// An omni light "key" among a random scene's objects and a directional light "fill". The same for the same seed.
std::vector<Light> otherLights(std::uint32_t seed);

}  // namespace cdsm::reference
