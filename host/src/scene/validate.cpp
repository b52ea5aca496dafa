// SPDX-License-Identifier: Apache-2.0
// Checks of whole scenes, cameras, lights and objects; the grids, triangles and curves are in validate_data.cpp.
#include "scene/validate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <cdsm/error.hpp>

#include "scene/data_checks.hpp"
#include "scene/range.hpp"
#include "scene/transform.hpp"

namespace cdsm {
namespace scene {
namespace {

/// World units; the square of anything longer is still a normal float.
constexpr double kShortestView = 1e-12;
/// Sine of the angle between up and view direction, below which the image's sides are mostly rounding error.
constexpr double kSmallestSine = 1e-4;

std::string quoted(const char* kind, const std::string& name) { return std::string(kind) + " '" + name + "'"; }

void requireVector(const glm::vec3& value, const Range& range, const std::string& what) {
  for (int axis = 0; axis < 3; ++axis) requireRange(value[axis], range, what);
}

void requireDistinct(const glm::vec3& position, const glm::vec3& target, const std::string& what) {
  if (glm::distance(glm::dvec3(position), glm::dvec3(target)) < kShortestView) {
    throw Error(what + ": position and target are the same point, must differ");
  }
}

void requireDirection(const glm::vec3& direction, const std::string& what) {
  requireVector(direction, kCoordinate, what);
  if (glm::length(glm::dvec3(direction)) < kShortestView) throw Error(what + " has no length, must be a direction");
}

void requireEither(const std::string& value, const char* one, const char* other, const std::string& what) {
  if (value != one && value != other) throw Error(what + " is '" + value + "', must be " + one + " or " + other);
}

void requireTransform(const glm::mat4& worldFromObject, const std::string& what) {
  if (!isInvertibleAffine(worldFromObject)) {
    throw Error(what + ": the transform cannot be inverted, must be finite, without a scale of 0 and with the last " +
                "row 0 0 0 1");
  }
  requireVector(glm::vec3(worldFromObject[3]), kCoordinate, what + ": the transform's position");
}

/// Of a volume's box, in voxel coordinates.
std::vector<glm::vec3> boxCorners(const VolumeData& data) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(glm::vec3(i & 1, i >> 1 & 1, i >> 2) * glm::vec3(data.size) - 0.5f);
  return corners;
}

/// Points beyond the range of coordinates would overflow on the way to the screen; in double they do not here.
/// `reach`: of what is around each point, in the world.
void requireReach(const Array<glm::vec3>& points, const glm::dmat4& worldFromPoints, const std::string& what,
                  double reach = 0.0) {
  glm::dvec3 low(0.0), high(0.0);
  for (const glm::vec3& point : points) {
    const glm::dvec3 world(worldFromPoints * glm::dvec4(point, 1.0));
    low = glm::min(low, world - reach);
    high = glm::max(high, world + reach);
  }
  for (int axis = 0; axis < 3; ++axis) {
    requireRange(low[axis], kCoordinate, what + ": its lowest coordinate in the world");
    requireRange(high[axis], kCoordinate, what + ": its highest coordinate in the world");
  }
}

void requireMaterial(int material, std::size_t materialCount, const std::string& what) {
  if (material >= 0 && static_cast<std::size_t>(material) < materialCount) return;
  throw Error(what + ": material index is " + std::to_string(material) + ", must be below the number of materials, " +
              std::to_string(materialCount));
}

void requireClosed(const Mesh& mesh, DataChecks& checks, const std::string& why) {
  const std::size_t open = checks.openEdges(mesh.data);
  if (open == 0) return;
  throw Error(quoted("mesh", mesh.name) + " has " + std::to_string(open) + " open edge" + (open == 1 ? "" : "s") +
              ", must be closed " + why);
}

}  // namespace

void validateCamera(const Camera& camera) {
  requireVector(camera.position, kCoordinate, "camera position");
  requireVector(camera.target, kCoordinate, "camera target");
  requireDirection(camera.up, "camera up");
  requireRange(camera.fov, kFov, "camera fov");
  requireDistinct(camera.position, camera.target, "camera");
  const glm::dvec3 up = glm::normalize(glm::dvec3(camera.up));
  const glm::dvec3 view = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position));
  if (glm::length(glm::cross(view, up)) < kSmallestSine) {
    throw Error("camera up is parallel to the view direction, must point to another side");
  }
}

void validateImage(const ImageSettings& image) {
  requireRange(image.width, kImageSide, "image width");
  requireRange(image.height, kImageSide, "image height");
  requireRange(image.supersampling, kSupersampling, "image supersampling");
  requireVector(image.background, kNotNegative, "image background");
  requireVector(image.ambient, kNotNegative, "image ambient");
}

void validateSamples(int samples) {
  if (samples != 7 && samples != 13 && samples != 21)
    throw Error("shadows samples is " + std::to_string(samples) + ", must be 7, 13 or 21");
}

void validateShadows(const ShadowSettings& shadows) {
  requireRange(shadows.mapSize, kMapSize, "shadows map_size");
  requireRange(shadows.maxNodes, kMaxNodes, "shadows max_nodes");
  requireRange(shadows.tolerance, kTolerance, "shadows tolerance");
  if (shadows.toleranceMode == "everywhere")
    requireRange(shadows.tolerance, kToleranceEverywhere, "shadows tolerance with tolerance_mode everywhere");
  if (shadows.nodeFormat == "unorm16")
    requireRange(shadows.tolerance, kToleranceUnorm16, "shadows tolerance with node_format unorm16");
  requireRange(shadows.memoryLimitMb, kNotNegative, "shadows memory_limit_mb");
  requireRange(shadows.threshold, kThreshold, "shadows threshold");
  requireRange(shadows.pcf, kPcf, "shadows pcf");
  validateSamples(shadows.samples);
  requireRange(shadows.seed, kSeed, "shadows seed");
  if (shadows.patch != ShadowSettings::kPatchAuto) requireRange(shadows.patch, kPatch, "shadows patch");
  requireRange(shadows.softness, kNotNegative, "shadows softness");
  requireRange(shadows.softnessDistance, kPositive, "shadows softness_distance");
  requireRange(shadows.softnessExponent, kPositive, "shadows softness_exponent");
  requireRange(shadows.clusters, kClusters, "shadows clusters");
  requireRange(shadows.clusterDistance, kClusterDistance, "shadows cluster_distance");
  requireRange(shadows.step, kNotNegative, "shadows step");
  requireRange(shadows.bias, kNotNegative, "shadows bias");
  requireEither(shadows.filter, "bilinear", "nearest", "shadows filter");
  requireEither(shadows.rays, "exact", "opaque", "shadows rays");
  requireEither(shadows.transmittance, "grey", "rgb", "shadows transmittance");
  requireEither(shadows.toleranceMode, "samples", "everywhere", "shadows tolerance_mode");
  requireEither(shadows.nodeFormat, "float32", "unorm16", "shadows node_format");
  requireEither(shadows.onOverflow, "error", "coarsen", "shadows on_overflow");
  requireEither(shadows.cache, "none", "volume", "shadows cache");
}

void validateTechnique(const Scene& scene) {
  if (scene.shadows.technique == "implicit-sphere" && scene.spheres.empty())
    throw Error("the technique implicit-sphere needs [[spheres]] to cast shadows, of which the scene has none");
  const ShadowSettings& shadows = scene.shadows;
  const bool opaque = shadows.technique == "shadow-map" || shadows.technique == "implicit-sphere";
  const bool opaqueRays = shadows.technique == "shadow-rays" && shadows.rays == "opaque";
  if (shadows.transmittance == "rgb" && (opaque || opaqueRays))
    throw Error("the technique " + shadows.technique + (opaqueRays ? " with opaque rays" : "") +
                " knows all of the light or none, but shadows.transmittance is 'rgb', must be 'grey'");
}

void validateOcclusion(const Scene& scene) {
  if (!scene.ambientOcclusion) return;
  const AmbientOcclusion& occlusion = *scene.ambientOcclusion;
  requireRange(occlusion.directions, kDirections, "ambient_occlusion directions");
  requireRange(occlusion.distance, kOcclusionDistance, "ambient_occlusion distance");
  if (occlusion.resolution != 0)
    requireRange(occlusion.resolution, kOcclusionResolution, "ambient_occlusion resolution");
  requireRange(occlusion.strength, kNotNegative, "ambient_occlusion strength");
  if (scene.spheres.empty())
    throw Error("ambient_occlusion needs [[spheres]] whose ambient light it weakens, of which the scene has none");
}

void validateLight(const Light& light) {
  const std::string what = quoted("light", light.name);
  requireVector(light.color, kNotNegative, what + ": color");
  if (light.type == LightType::Directional) return requireDirection(light.direction, what + ": direction");
  requireVector(light.position, kCoordinate, what + ": position");
  if (light.type == LightType::Omni) return;
  requireVector(light.target, kCoordinate, what + ": target");
  requireRange(light.cutoff, kCutoff, what + ": cutoff");
  requireDistinct(light.position, light.target, what);
}

void validateMaterial(const Material& material) {
  const std::string what = quoted("material", material.name);
  requireVector(material.diffuse, kNotNegative, what + ": diffuse");
  requireVector(material.specular, kNotNegative, what + ": specular");
  requireRange(material.shininess, kNotNegative, what + ": shininess");
  requireRange(material.opacity, kUnitInterval, what + ": opacity");
  requireVector(material.transmission, kUnitInterval, what + ": transmission");
}

void validateMesh(const Mesh& mesh, std::size_t materialCount, DataChecks& checks) {
  const std::string what = quoted("mesh", mesh.name);
  if (!mesh.data) throw Error(what + " has no data, must point to a MeshData");
  requireTransform(mesh.worldFromObject, what);
  checks.requireValid(mesh.data, what, mesh.revision);
  requireReach(mesh.data->positions, mesh.worldFromObject, what);
  requireMaterial(mesh.material, materialCount, what);
  requireRange(mesh.interiorExtinction, kNotNegative, what + ": interior_extinction");
  requireVector(mesh.interiorColor, kNotNegative, what + ": interior_color");
  requireVector(mesh.interiorTransmission, kUnitInterval, what + ": interior_transmission");
  requireRange(mesh.shadow.weight, kClusterWeight, what + ": cluster_weight");
  if (mesh.interiorExtinction > 0.0f) requireClosed(mesh, checks, "to have an interior_extinction");
}

void validateVolume(const Volume& volume, const std::vector<Mesh>& meshes, DataChecks& checks) {
  const std::string what = quoted("volume", volume.name);
  if (!volume.data) throw Error(what + " has no data, must point to a VolumeData");
  requireTransform(volume.worldFromObject, what);
  checks.requireValid(volume.data, what, volume.revision);
  requireReach(boxCorners(*volume.data), glm::dmat4(volume.worldFromObject) * glm::dmat4(volume.data->objectFromIndex),
               what);
  validateTransferFunction(volume.transfer, what);
  requireVector(volume.specular, kNotNegative, what + ": specular");
  requireRange(volume.shininess, kNotNegative, what + ": shininess");
  requireRange(volume.shadow.weight, kClusterWeight, what + ": cluster_weight");
  if (volume.boundary < -1 || volume.boundary >= static_cast<int>(meshes.size())) {
    throw Error(what + ": boundary index is " + std::to_string(volume.boundary) + ", must be -1 or below the number " +
                "of meshes, " + std::to_string(meshes.size()));
  }
  if (volume.boundary >= 0) requireClosed(meshes[volume.boundary], checks, "to be the boundary of " + what);
}

void validateSpheres(const Spheres& spheres, std::size_t materialCount, DataChecks& checks) {
  const std::string what = quoted("spheres", spheres.name);
  if (!spheres.data) throw Error(what + " have no data, must point to a SphereData");
  requireTransform(spheres.worldFromObject, what);
  if (!isSimilarity(spheres.worldFromObject)) {
    throw Error(what + ": the transform would make ellipsoids of spheres, must scale all axes alike");
  }
  checks.requireValid(spheres.data, what, spheres.revision);
  float greatest = 0.0f;
  for (const float radius : spheres.data->radii) greatest = std::max(greatest, radius);
  requireReach(spheres.data->centers, spheres.worldFromObject, what,
               double(greatest) * glm::length(glm::dvec3(spheres.worldFromObject[0])));
  requireMaterial(spheres.material, materialCount, what);
  requireRange(spheres.shadow.weight, kClusterWeight, what + ": cluster_weight");
}

namespace {

/// What is known of data is known of one revision.
template <class Object>
void requireOneRevision(const std::vector<Object>& objects, const char* kind) {
  std::map<const void*, const Object*> firsts;
  for (const Object& object : objects) {
    const Object& first = *firsts.emplace(object.data.get(), &object).first->second;
    if (first.revision == object.revision) continue;
    throw Error(quoted(kind, first.name) + " has the revision " + std::to_string(first.revision) + ", " +
                quoted(kind, object.name) + " with the same data the revision " + std::to_string(object.revision) +
                ", must be the same");
  }
}

}  // namespace

void validateScene(const Scene& scene, DataChecks& checks) {
  validateCamera(scene.camera);
  validateImage(scene.image);
  validateShadows(scene.shadows);
  validateTechnique(scene);
  validateOcclusion(scene);
  for (const Light& light : scene.lights) validateLight(light);
  for (const Material& material : scene.materials) validateMaterial(material);
  requireOneRevision(scene.meshes, "mesh");
  requireOneRevision(scene.volumes, "volume");
  requireOneRevision(scene.spheres, "spheres");
  for (const Mesh& mesh : scene.meshes) validateMesh(mesh, scene.materials.size(), checks);
  for (const Volume& volume : scene.volumes) validateVolume(volume, scene.meshes, checks);
  for (const Spheres& spheres : scene.spheres) validateSpheres(spheres, scene.materials.size(), checks);
}

}  // namespace scene

void validate(const Scene& scene) {
  scene::DataChecks checks;
  scene::validateScene(scene, checks);
}

}  // namespace cdsm
