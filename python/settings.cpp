// SPDX-License-Identifier: Apache-2.0
// Camera, image, shadows, lights and materials.
#include <array>

#include <cdsm/error.hpp>

#include "objects.hpp"

namespace cdsm::python {

namespace {

constexpr std::array<const char*, 3> kLightTypes = {"spot", "omni", "directional"};  ///< in the order of LightType

LightType lightTypeOf(const py::handle& given) {
  const auto name = valueOf<std::string>(given, "Light.type");
  for (std::size_t i = 0; i < kLightTypes.size(); ++i)
    if (name == kLightTypes[i]) return LightType(i);
  throw Error("Light.type is '" + name + "', must be 'spot', 'omni' or 'directional'");
}

void bindCamera(py::module_& module) {
  Fields<Camera>(module, "Camera", "Where the picture is taken from. Lengths are world units, angles degrees.")
      .field("position", &Camera::position, "Of the eye.")
      .field("target", &Camera::target, "What is in the middle of the picture.")
      .field("up", &Camera::up, "What is upwards in the picture.")
      .field("fov", &Camera::fov, "Vertical, full angle, in (0, 180).")
      .constructor();
}

void bindImageSettings(py::module_& module) {
  Fields<ImageSettings>(module, "ImageSettings", "Size of the picture, and light without a source. Colours are linear.")
      .field("width", &ImageSettings::width, "Pixels.")
      .field("height", &ImageSettings::height, "Pixels.")
      .field("background", &ImageSettings::background, "Colour behind everything.")
      .field("ambient", &ImageSettings::ambient, "Light that is everywhere.")
      .field("supersampling", &ImageSettings::supersampling, "Rays per pixel side, in [1, 8].")
      .constructor();
}

void bindLight(py::module_& module) {
  Fields<Light>(module, "Light", "A light of type 'spot', 'omni' or 'directional'.")
      .field("name", &Light::name, "What queries call it.")
      .property(
          "type", [](Light& light) { return py::str(kLightTypes[std::size_t(light.type)]); },
          [](Light& light, const py::object& given) { light.type = lightTypeOf(given); },
          "'spot', 'omni' or 'directional'.")
      .field("position", &Light::position, "Of a spot or omni light.")
      .field("target", &Light::target, "What a spot light shines at.")
      .field("direction", &Light::direction, "The way directional light travels.")
      .field("cutoff", &Light::cutoff, "Half the angle of a spot light's cone, degrees, in (0, 90).")
      .field("color", &Light::color, "Linear RGB.")
      .constructor();
}

void bindMaterial(py::module_& module) {
  Fields<Material>(module, "Material", "The look of a surface.")
      .field("name", &Material::name, "For messages.")
      .field("diffuse", &Material::diffuse, "Linear RGB.")
      .field("specular", &Material::specular, "Linear RGB.")
      .field("shininess", &Material::shininess, "Exponent of the highlight.")
      .field("opacity", &Material::opacity, "Of one crossing of the surface, in [0, 1].")
      .field("transmission", &Material::transmission,
             "What of the light's colour gets through where the surface interacts; ShadowSettings.transmittance 'rgb'.")
      .constructor();
}

void addLookup(Fields<ShadowSettings>& fields) {
  fields.field("filter", &ShadowSettings::filter, "'bilinear' or 'nearest'.")
      .field("rays", &ShadowSettings::rays, "Technique 'shadow-rays': 'exact' or 'opaque'.")
      .field("transmittance", &ShadowSettings::transmittance,
             "'grey' or 'rgb': whether what light gets through colours it.")
      .field("threshold", &ShadowSettings::threshold, "Shadow maps: opacity above which all light is stopped.")
      .field("pcf", &ShadowSettings::pcf, "Shadow maps: texels of the filter around the one looked up.")
      .field("samples", &ShadowSettings::samples, "Stochastic maps: texels averaged per lookup, 7, 13 or 21.")
      .field("seed", &ShadowSettings::seed, "Stochastic maps: of the random numbers.")
      .field("stratified", &ShadowSettings::stratified, "Stochastic maps: numbers spread evenly over a lookup.")
      .field("patch", &ShadowSettings::patch,
             "Implicit spheres: rings of texels around the one looked up; -1: as needed.")
      .field("softness", &ShadowSettings::softness, "Implicit spheres: world units that penumbrae reach out.")
      .field("softness_distance", &ShadowSettings::softnessDistance,
             "Implicit spheres: where penumbrae are fully soft.")
      .field("softness_exponent", &ShadowSettings::softnessExponent,
             "Implicit spheres: how penumbrae grow up to there.")
      .field("cache", &ShadowSettings::cache, "'none' or 'volume': transmittance kept at every voxel.")
      .field("bias", &ShadowSettings::bias, "World units towards the light for surface points; 0: from the scene.");
}

void bindShadowSettings(py::module_& module) {
  Fields<ShadowSettings> fields(module, "ShadowSettings",
                                "How shadows are made; names are those of scene files (docs/scene-file.md).");
  fields.field("technique", &ShadowSettings::technique, "'deep-shadow-map', 'shadow-rays' ...")
      .field("memory", &ShadowSettings::memory, "How the nodes of maps are kept: 'exact', 'chunked' ...")
      .field("max_nodes", &ShadowSettings::maxNodes, "Memory 'fixed': nodes per texel, in [2, 256].")
      .field("node_format", &ShadowSettings::nodeFormat, "'float32' or 'unorm16'.")
      .field("map_size", &ShadowSettings::mapSize, "Texels per side.")
      .field("tolerance", &ShadowSettings::tolerance, "Error of the maps that is allowed, in opacity, in [0, 1).")
      .field("tolerance_mode", &ShadowSettings::toleranceMode, "'samples' or 'everywhere'.")
      .field("clusters", &ShadowSettings::clusters, "The most clusters of casters per light.")
      .field("cluster_distance", &ShadowSettings::clusterDistance, "From which on casters are apart.")
      .field("stable", &ShadowSettings::stable, "Hand over smoothly when clusters change.")
      .field("step", &ShadowSettings::step, "Of rays, world units; 0: half the smallest voxel edge.")
      .field("memory_limit_mb", &ShadowSettings::memoryLimitMb, "MiB of finished maps; 0: what the device has.")
      .field("on_overflow", &ShadowSettings::onOverflow, "Of that limit: 'error' or 'coarsen'.");
  addLookup(fields);
  fields.constructor();
}

void bindAmbientOcclusion(py::module_& module) {
  Fields<AmbientOcclusion>(module, "AmbientOcclusion", "How much of their surroundings spheres see.")
      .field("directions", &AmbientOcclusion::directions, "That are looked along, in [4, 256].")
      .field("distance", &AmbientOcclusion::distance, "Up to which spheres occlude, in longest sides of their box.")
      .field("resolution", &AmbientOcclusion::resolution, "Cells along that side, in [8, 256]; 0: from the radii.")
      .field("strength", &AmbientOcclusion::strength, "Factor of what occludes; 0: nothing does.")
      .constructor();
}

}  // namespace

void bindSettings(py::module_& module) {
  bindCamera(module);
  bindImageSettings(module);
  bindShadowSettings(module);
  bindAmbientOcclusion(module);
  bindLight(module);
  bindMaterial(module);
}

}  // namespace cdsm::python
