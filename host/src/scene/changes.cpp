// SPDX-License-Identifier: Apache-2.0
#include "scene/changes.hpp"

#include <algorithm>
#include <tuple>

#include "scene/objects.hpp"

namespace cdsm::scene {

namespace {

auto key(const Material& m) { return std::tie(m.name, m.diffuse, m.specular, m.shininess, m.opacity, m.transmission); }
auto key(const ShadowRole& r) { return std::tie(r.casts, r.receives, r.weight); }
auto key(const Mesh& m) {
  return std::tuple_cat(std::tie(m.name, m.data, m.revision, m.material, m.worldFromObject, m.interiorExtinction,
                                 m.interiorColor, m.interiorTransmission),
                        key(m.shadow));
}
auto key(const Spheres& s) {
  return std::tuple_cat(std::tie(s.name, s.data, s.revision, s.material, s.worldFromObject), key(s.shadow));
}
auto key(const TransferFunction::OpacityPoint& p) { return std::tie(p.value, p.opacity); }
auto key(const TransferFunction::ColorPoint& p) { return std::tie(p.value, p.color); }

template <class T>
bool sameLists(const std::vector<T>& a, const std::vector<T>& b);

bool same(const TransferFunction& a, const TransferFunction& b) {
  return a.unitDistance == b.unitDistance && sameLists(a.opacity, b.opacity) && sameLists(a.color, b.color) &&
         sameLists(a.shadowOpacity, b.shadowOpacity) && sameLists(a.transmission, b.transmission);
}

bool same(const Volume& a, const Volume& b) {
  const auto plain = [](const Volume& v) {
    return std::tuple_cat(
        std::tie(v.name, v.data, v.revision, v.worldFromObject, v.boundary, v.specular, v.shininess, v.shading),
        key(v.shadow));
  };
  return plain(a) == plain(b) && same(a.transfer, b.transfer);
}

template <class T>
bool same(const T& a, const T& b) {
  return key(a) == key(b);
}

template <class T>
bool sameLists(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

/// A transmission as far as it counts.
glm::vec3 counted(const Scene& scene, const glm::vec3& transmission) {
  return scene.shadows.transmittance == "rgb" ? transmission : glm::vec3(0.0f);
}

auto meshCaster(const Scene& scene, std::size_t index) {
  const Mesh& m = scene.meshes[index];
  const Material& material = scene.materials[m.material];
  return std::make_tuple(m.data, m.revision, m.worldFromObject, m.interiorExtinction,
                         counted(scene, m.interiorTransmission), m.shadow.casts, material.opacity,
                         counted(scene, material.transmission));
}

/// What of them is seen, and occludes.
auto spheresShape(const Scene& scene, std::size_t index) {
  const Spheres& s = scene.spheres[index];
  return std::tie(s.data, s.revision, s.worldFromObject, s.shadow.casts, scene.materials[s.material].opacity);
}

auto spheresCaster(const Scene& scene, std::size_t index) {
  const Material& material = scene.materials[scene.spheres[index].material];
  return std::tuple_cat(spheresShape(scene, index), std::make_tuple(counted(scene, material.transmission)));
}

CasterChange volumeChange(const Scene& a, const Scene& b, std::size_t index) {
  const Volume &v = a.volumes[index], &w = b.volumes[index];
  const auto grid = [](const Volume& x) {
    return std::tie(x.data, x.revision, x.worldFromObject, x.boundary, x.shadow.casts);
  };
  if (grid(v) != grid(w)) return CasterChange::Other;
  if (v.boundary >= 0) {
    const auto shape = [&](const Scene& scene) {
      const Mesh& m = scene.meshes[std::size_t(v.boundary)];
      return std::tie(m.data, m.revision, m.worldFromObject);
    };
    if (shape(a) != shape(b)) return CasterChange::Other;
  }
  const TransferFunction &s = v.transfer, &t = w.transfer;
  const bool same = s.unitDistance == t.unitDistance && sameLists(s.towardsLights(), t.towardsLights()) &&
                    (a.shadows.transmittance == "grey" || sameLists(s.transmission, t.transmission));
  return same ? CasterChange::None : CasterChange::TransferFunction;
}

}  // namespace

bool sameObjects(const Scene& a, const Scene& b) {
  return sameLists(a.materials, b.materials) && sameLists(a.meshes, b.meshes) && sameLists(a.volumes, b.volumes) &&
         sameLists(a.spheres, b.spheres) && a.shadows.step == b.shadows.step &&
         a.shadows.tolerance == b.shadows.tolerance && a.shadows.transmittance == b.shadows.transmittance;
}

bool sameObjectNames(const Scene& a, const Scene& b) {
  const auto sameNames = [](const auto& x, const auto& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const auto& p, const auto& q) { return p.name == q.name; });
  };
  return sameNames(a.meshes, b.meshes) && sameNames(a.volumes, b.volumes) && sameNames(a.spheres, b.spheres);
}

CasterChange casterChange(const Scene& a, const Scene& b, unsigned object) {
  const ObjectPlace place = placeOf(a, object);
  if (place.kind == ObjectKind::Volume) return volumeChange(a, b, place.index);
  const bool mesh = place.kind == ObjectKind::Mesh;
  const bool same = mesh ? meshCaster(a, place.index) == meshCaster(b, place.index)
                         : spheresCaster(a, place.index) == spheresCaster(b, place.index);
  return same ? CasterChange::None : CasterChange::Other;
}

LightChange lightChange(const Light& a, const Light& b) {
  if (a.type != b.type) return LightChange::Other;
  if (a.type == LightType::Directional) return a.direction == b.direction ? LightChange::None : LightChange::Turned;
  if (a.position != b.position) return LightChange::Moved;
  if (a.type == LightType::Omni) return LightChange::None;
  if (a.target != b.target) return LightChange::Turned;
  return a.cutoff == b.cutoff ? LightChange::None : LightChange::Cone;
}

bool sameMapSettings(const ShadowSettings& a, const ShadowSettings& b) {
  const auto common = [](const ShadowSettings& s) { return std::tie(s.technique, s.mapSize, s.step, s.transmittance); };
  if (common(a) != common(b)) return false;
  if (a.technique == "shadow-map" || a.technique == "implicit-sphere") return a.threshold == b.threshold;
  if (a.technique == "stochastic")
    return std::tie(a.seed, a.stratified) == std::tie(b.seed, b.stratified) &&
           (!a.stratified || a.samples == b.samples);
  const auto settings = [](const ShadowSettings& s) {
    return std::tie(s.memory, s.maxNodes, s.nodeFormat, s.tolerance, s.toleranceMode, s.memoryLimitMb, s.onOverflow);
  };
  return settings(a) == settings(b);
}

bool sameTransmittance(const Scene& a, const Scene& b) {
  const auto settings = [](const ShadowSettings& s) {
    return std::tie(s.filter, s.rays, s.threshold, s.pcf, s.samples, s.patch, s.softness, s.softnessDistance,
                    s.softnessExponent, s.clusters, s.clusterDistance, s.cache);
  };
  if (!sameMapSettings(a.shadows, b.shadows) || settings(a.shadows) != settings(b.shadows)) return false;
  const auto counts = [](const Scene& s) {
    return std::make_tuple(s.lights.size(), s.meshes.size(), s.volumes.size(), s.spheres.size());
  };
  if (counts(a) != counts(b)) return false;
  for (std::size_t i = 0; i < a.lights.size(); ++i)
    if (lightChange(a.lights[i], b.lights[i]) != LightChange::None) return false;
  for (unsigned i = 0; i < objectCount(a); ++i)
    if (casterChange(a, b, i) != CasterChange::None) return false;
  return true;
}

bool sameOcclusion(const Scene& a, const Scene& b) {
  const auto settings = [](const Scene& s) {
    const auto& o = s.ambientOcclusion;
    return o ? std::make_tuple(true, o->directions, o->distance, o->resolution, o->strength)
             : std::make_tuple(false, 0, 0.0f, 0, 0.0f);
  };
  if (settings(a) != settings(b) || a.spheres.size() != b.spheres.size()) return false;
  for (std::size_t i = 0; i < a.spheres.size(); ++i)
    if (spheresShape(a, i) != spheresShape(b, i)) return false;
  return true;
}

bool sameVisibility(const Scene& a, const Scene& b) {
  return std::equal(a.volumes.begin(), a.volumes.end(), b.volumes.begin(), b.volumes.end(),
                    [](const Volume& v, const Volume& w) { return sameLists(v.transfer.opacity, w.transfer.opacity); });
}

}  // namespace cdsm::scene
