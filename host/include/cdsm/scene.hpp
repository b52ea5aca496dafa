// SPDX-License-Identifier: Apache-2.0
// A scene as plain values: what the scene file says after reading, and what an embedder fills in by hand.
// World space is right-handed; lengths are world units, angles degrees, colours linear RGB.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <cdsm/array.hpp>
#include <cdsm/export.hpp>

namespace cdsm {

struct Camera {
  glm::vec3 position{0.0f, 0.0f, 5.0f};
  glm::vec3 target{0.0f};
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  float fov = 45.0f;  ///< vertical, full angle, in (0, 180)
};

struct ImageSettings {
  int width = 720;
  int height = 480;
  glm::vec3 background{0.0f};
  glm::vec3 ambient{0.1f};  ///< i_a of the Phong model [Knecht 2011, eq. 3.9]
  int supersampling = 1;    ///< rays per pixel side: 2 averages 2 x 2 rays, in [1, 8]
};

/// How shadows are made. Names of techniques and memory strategies are those of the scene file; the registry
/// (host/src/technique/registry.cpp) is the list of what exists.
struct ShadowSettings {
  static constexpr int kPatchAuto = -1;  ///< as many rings as change something

  std::string technique = "deep-shadow-map";
  std::string memory = "exact";
  int maxNodes = 16;                      ///< memory "fixed": nodes per texel, in [2, 256]
  std::string nodeFormat = "float32";     ///< float32 | unorm16: how a node of a deep shadow map is stored
  int mapSize = 512;                      ///< texels per side
  float tolerance = 0.01f;                ///< epsilon of the compression, in opacity, in [0, 1)
  std::string toleranceMode = "samples";  ///< samples | everywhere: where V' is within the tolerance
  std::string filter = "bilinear";        ///< bilinear | nearest
  std::string rays = "exact";             ///< shadow-rays: exact | opaque
  std::string transmittance = "grey";     ///< grey | rgb: whether light is coloured by what it gets through
  float threshold = 0.5f;   ///< techniques of all or nothing: opacity above which all light is stopped, in [0, 1)
  int pcf = 1;              ///< shadow-map: texels of the filter around the one looked up, in [0, 16]
  int samples = 13;         ///< stochastic: texels averaged per lookup, 7, 13 or 21
  int seed = 1;             ///< stochastic: of its random numbers, at least 0
  bool stratified = false;  ///< stochastic: numbers spread evenly over the texels of a lookup
  int patch = 1;            ///< implicit-sphere: rings of texels around the one looked up, in [0, 64], or kPatchAuto
  float softness = 0.0f;    ///< implicit-sphere: world units that penumbras reach past spheres, at least 0
  float softnessDistance = 1.0f;  ///< implicit-sphere: distance from which on they do so in full, > 0
  float softnessExponent = 1.0f;  ///< implicit-sphere: of what a penumbra darkens, > 0
  int clusters = 1;               ///< the most clusters of casters per light; 1: no clustering
  float clusterDistance = 0.25f;  ///< d0, in units of the light-space-perspective [-1, 1] square
  bool stable = false;            ///< hand over smoothly when clusters change; frames depend on those before
  float step = 0.0f;              ///< ray step in world units; 0: half the smallest voxel edge in the segment
  float memoryLimitMb = 0.0f;     ///< MiB of finished maps; 0: as many as the device has
  std::string cache = "none";     ///< none | volume: transmittance at every voxel, kept until light or casters change
  std::string onOverflow = "error";  ///< of that limit: error | coarsen (a larger tolerance)
  float bias = 0.0f;                 ///< world units towards the light for surface points; 0: chosen from the scene
};

/// How much of their surroundings spheres see, which weakens their ambient light [Krone 2017, §4].
struct AmbientOcclusion {
  int directions = 16;    ///< that are looked along, in [4, 256]
  float distance = 0.7f;  ///< up to which spheres occlude, in longest sides of the box around them, in (0, 2]
  int resolution = 0;     ///< cells along that side, in [8, 256]; 0: chosen from the spheres' radii
  float strength = 1.0f;  ///< factor of the optical depth of what occludes, at least 0
};

/// Spot: a cone from a point. Omni: from a point to all sides. Directional: parallel light from infinitely far away.
enum class LightType { Spot, Omni, Directional };

struct Light {
  std::string name;
  LightType type = LightType::Spot;
  glm::vec3 position{0.0f, 1.0f, 0.0f};    ///< spot, omni
  glm::vec3 target{0.0f};                  ///< spot
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< directional: the way the light travels, of any length but 0
  float cutoff = 30.0f;                    ///< spot: half the cone's angle, in (0, 90), a hard edge
  glm::vec3 color{1.0f};
};

struct Material {
  std::string name;
  glm::vec3 diffuse{0.8f};
  glm::vec3 specular{0.0f};
  float shininess = 1.0f;
  float opacity = 1.0f;  ///< of one crossing of the surface, in [0, 1]
  /// What of the light's colour gets through where the surface interacts, in [0, 1]; if shadows.transmittance is rgb.
  glm::vec3 transmission{0.0f};
};

/// What an object and shadows have to do with each other.
struct ShadowRole {
  bool casts = true;     ///< attenuates the light
  bool receives = true;  ///< is lit by what is left of the light; false: as if nothing stood in the way
  float weight = 1.0f;   ///< of its distances to others when casters are clustered, > 0; larger: a sharper shadow
};

/// Triangles in object space. Either no normals or one per position.
struct MeshData {
  Array<glm::vec3> positions;
  Array<glm::vec3> normals;
  Array<glm::uvec3> triangles;
};

struct Mesh {
  std::string name;
  std::shared_ptr<const MeshData> data;
  int material = 0;  ///< index into Scene::materials
  glm::mat4 worldFromObject{1.0f};
  float interiorExtinction = 0.0f;  ///< 1 / world length; > 0 needs a closed mesh
  glm::vec3 interiorColor{1.0f};
  ShadowRole shadow;
  glm::vec3 interiorTransmission{0.0f};  ///< as Material::transmission, of the interior
  std::uint64_t revision = 0;            ///< of the data: another one than before says that its arrays have changed
};

/// Spheres in object space, each with its own radius > 0. Either no colours or one per centre.
struct SphereData {
  Array<glm::vec3> centers;
  Array<float> radii;
  Array<glm::vec3> colors;  ///< diffuse, in place of the material's
};

/// Glyphs or atoms: surfaces that are never tessellated. Light that passes through a sphere crosses it twice.
struct Spheres {
  std::string name;
  std::shared_ptr<const SphereData> data;
  int material = 0;                 ///< index into Scene::materials
  glm::mat4 worldFromObject{1.0f};  ///< scales all axes alike
  ShadowRole shadow;
  std::uint64_t revision = 0;  ///< of the data: another one than before says that its arrays have changed
};

enum class VoxelType { UInt8, Int8, UInt16, Int16, Float32 };

/// Bytes of one voxel.
CDSM_API std::size_t voxelBytes(VoxelType type);

/// Voxels that lie in somebody else's memory. An engine keeps the VolumeData, and with it the owner, from the first
/// call with a scene that has it until a call with one that does not has succeeded, Engine::drop() or its own end.
/// Without an owner the memory must stay where it is for as long. Nobody may write to it during a call, nor while work
/// that a call has left running on the device uses it; after writing to it the next call must give a scene in which all
/// Volumes that have it have another `revision` than before.
struct VoxelView {
  const void* data = nullptr;  ///< host memory: the voxel of index (0, 0, 0)
  /// Bytes from a voxel to the next one along x, y, z; negative ones run backwards. All 0: side by side, x fastest,
  /// which devices that share the host's memory read in place; others are copied.
  std::array<std::ptrdiff_t, 3> strides{0, 0, 0};
  std::shared_ptr<const void> owner;   ///< of `data`; may be empty
  std::shared_ptr<void> deviceMemory;  ///< in place of `data`: made by opencl::volumeData()
};

/// A scalar grid. `objectFromIndex` maps the index of a voxel's centre to object space.
struct VolumeData {
  VoxelType type = VoxelType::UInt8;
  glm::uvec3 size{0u};
  std::vector<std::byte> voxels;  ///< side by side, x fastest; empty if there is a view
  glm::mat4 objectFromIndex{1.0f};
  VoxelView view;
};

/// Opacity and colour by value: linear between the points, constant outside. Values are the file's own, ascending.
struct TransferFunction {
  struct OpacityPoint {
    float value;
    float opacity;  ///< per unitDistance, in [0, 1]; capped at 0.9999 where it becomes an extinction
  };
  struct ColorPoint {
    float value;
    glm::vec3 color;
  };
  std::vector<OpacityPoint> opacity;
  std::vector<OpacityPoint> shadowOpacity;  ///< in place of `opacity` where light is attenuated; empty: the same
  std::vector<ColorPoint> color;
  float unitDistance = 1.0f;               ///< world length for which the opacities hold, > 0
  std::vector<ColorPoint> transmission{};  ///< as Material::transmission, by value; empty: none

  const std::vector<OpacityPoint>& towardsLights() const { return shadowOpacity.empty() ? opacity : shadowOpacity; }
};

struct Volume {
  std::string name;
  std::shared_ptr<const VolumeData> data;
  std::uint64_t revision = 0;  ///< of the data: another one than before says that its voxels have changed
  glm::mat4 worldFromObject{1.0f};
  int boundary = -1;  ///< index into Scene::meshes of a closed mesh that cuts the volume; -1: its own box
  TransferFunction transfer;
  glm::vec3 specular{0.0f};
  float shininess = 1.0f;
  bool shading = true;  ///< Phong with the gradient as normal; false: the colour as it is, times the light
  ShadowRole shadow;
};

struct Scene {
  Camera camera;
  ImageSettings image;
  ShadowSettings shadows;
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Volume> volumes;
  std::vector<Spheres> spheres;
  std::optional<AmbientOcclusion> ambientOcclusion;  ///< of the spheres; needs some
};

/// Throws Error when a value is out of its range, an index points nowhere, a camera or light is degenerate, a
/// transform cannot be inverted or a mesh with an interior is not closed. Names the object and the remedy.
CDSM_API void validate(const Scene& scene);

}  // namespace cdsm
