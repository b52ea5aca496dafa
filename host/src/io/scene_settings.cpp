// SPDX-License-Identifier: Apache-2.0
// [camera], [image], [shadows] and [ambient_occlusion] of a scene file.
#include "io/scene_keys.hpp"
#include "io/scene_parts.hpp"
#include "scene/range.hpp"
#include "scene/validate.hpp"

namespace cdsm::io {
namespace {

const Choices kTechniques{"none", "shadow-rays", "shadow-map", "deep-shadow-map", "stochastic", "implicit-sphere"};
const Choices kMemories{"atlas", "chunked", "exact", "tiled", "fixed"};
const Choices kNodeFormats{"float32", "unorm16"};
const Choices kFilters{"bilinear", "nearest"};
const Choices kToleranceModes{"samples", "everywhere"};
const Choices kOverflows{"error", "coarsen"};
const Choices kRays{"exact", "opaque"};
const Choices kTransmittances{"grey", "rgb"};
const Choices kCaches{"none", "volume"};

}  // namespace

Camera readCamera(const toml::table& table) {
  const TableReader reader(table, "[camera]", keyNamesOf("camera"));
  Camera camera;
  camera.position = reader.vector("position", camera.position, scene::kCoordinate);
  camera.target = reader.vector("target", camera.target, scene::kCoordinate);
  camera.up = reader.vector("up", camera.up, scene::kCoordinate);
  camera.fov = reader.number("fov", camera.fov, scene::kFov);
  reader.locate("", [&] { scene::validateCamera(camera); });
  return camera;
}

ImageSettings readImageSettings(const toml::table& table) {
  const TableReader reader(table, "[image]", keyNamesOf("image"));
  ImageSettings image;
  image.width = reader.integer("width", image.width, scene::kImageSide);
  image.height = reader.integer("height", image.height, scene::kImageSide);
  image.background = reader.vector("background", image.background, scene::kNotNegative);
  image.ambient = reader.vector("ambient", image.ambient, scene::kNotNegative);
  image.supersampling = reader.integer("supersampling", image.supersampling, scene::kSupersampling);
  return image;
}

ShadowSettings readShadows(const toml::table& table) {
  const TableReader reader(table, "[shadows]", keyNamesOf("shadows"));
  ShadowSettings shadows;
  shadows.technique = reader.choice("technique", shadows.technique, kTechniques);
  shadows.memory = reader.choice("memory", shadows.memory, kMemories);
  shadows.maxNodes = reader.integer("max_nodes", shadows.maxNodes, scene::kMaxNodes);
  shadows.nodeFormat = reader.choice("node_format", shadows.nodeFormat, kNodeFormats);
  shadows.mapSize = reader.integer("map_size", shadows.mapSize, scene::kMapSize);
  shadows.tolerance = reader.number("tolerance", shadows.tolerance, scene::kTolerance);
  shadows.toleranceMode = reader.choice("tolerance_mode", shadows.toleranceMode, kToleranceModes);
  shadows.filter = reader.choice("filter", shadows.filter, kFilters);
  shadows.rays = reader.choice("rays", shadows.rays, kRays);
  shadows.transmittance = reader.choice("transmittance", shadows.transmittance, kTransmittances);
  shadows.threshold = reader.number("threshold", shadows.threshold, scene::kThreshold);
  shadows.pcf = reader.integer("pcf", shadows.pcf, scene::kPcf);
  shadows.samples = reader.integer("samples", shadows.samples, scene::kSamples);
  reader.locate("samples", [&] { scene::validateSamples(shadows.samples); });
  shadows.seed = reader.integer("seed", shadows.seed, scene::kSeed);
  shadows.stratified = reader.flag("stratified", shadows.stratified);
  shadows.patch = reader.integerOr("patch", shadows.patch, scene::kPatch, "auto", ShadowSettings::kPatchAuto);
  shadows.softness = reader.number("softness", shadows.softness, scene::kNotNegative);
  shadows.softnessDistance = reader.number("softness_distance", shadows.softnessDistance, scene::kPositive);
  shadows.softnessExponent = reader.number("softness_exponent", shadows.softnessExponent, scene::kPositive);
  shadows.clusters = reader.integer("clusters", shadows.clusters, scene::kClusters);
  shadows.clusterDistance = reader.number("cluster_distance", shadows.clusterDistance, scene::kClusterDistance);
  shadows.stable = reader.flag("stable", shadows.stable);
  shadows.step = reader.number("step", shadows.step, scene::kNotNegative);
  shadows.memoryLimitMb = reader.number("memory_limit_mb", shadows.memoryLimitMb, scene::kNotNegative);
  shadows.onOverflow = reader.choice("on_overflow", shadows.onOverflow, kOverflows);
  shadows.cache = reader.choice("cache", shadows.cache, kCaches);
  shadows.bias = reader.number("bias", shadows.bias, scene::kNotNegative);
  reader.locate("tolerance", [&] { scene::validateShadows(shadows); });  // all else has been checked above
  return shadows;
}

AmbientOcclusion readOcclusion(const toml::table& table) {
  const TableReader reader(table, "[ambient_occlusion]", keyNamesOf("ambient_occlusion"));
  AmbientOcclusion occlusion;
  occlusion.directions = reader.integer("directions", occlusion.directions, scene::kDirections);
  occlusion.distance = reader.number("distance", occlusion.distance, scene::kOcclusionDistance);
  occlusion.resolution = reader.integerOr("resolution", occlusion.resolution, scene::kOcclusionResolution, "auto", 0);
  occlusion.strength = reader.number("strength", occlusion.strength, scene::kNotNegative);
  return occlusion;
}

}  // namespace cdsm::io
