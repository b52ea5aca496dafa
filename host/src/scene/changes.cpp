// SPDX-License-Identifier: Apache-2.0
#include "scene/changes.hpp"

#include <algorithm>
#include <tuple>

namespace cdsm::scene {

namespace {

auto key(const Material& m) { return std::tie(m.name, m.diffuse, m.specular, m.shininess, m.opacity); }
auto key(const ShadowRole& r) { return std::tie(r.casts, r.receives, r.weight); }
auto key(const Mesh& m) {
  return std::tuple_cat(std::tie(m.name, m.data, m.material, m.worldFromObject, m.interiorExtinction, m.interiorColor),
                        key(m.shadow));
}
auto key(const TransferFunction::OpacityPoint& p) { return std::tie(p.value, p.opacity); }
auto key(const TransferFunction::ColorPoint& p) { return std::tie(p.value, p.color); }
auto key(const Light& l) { return std::tie(l.type, l.position, l.target, l.direction, l.cutoff); }

template <class T>
bool sameLists(const std::vector<T>& a, const std::vector<T>& b);

bool same(const TransferFunction& a, const TransferFunction& b) {
  return a.unitDistance == b.unitDistance && sameLists(a.opacity, b.opacity) && sameLists(a.color, b.color);
}

bool same(const Volume& a, const Volume& b) {
  const auto plain = [](const Volume& v) {
    return std::tuple_cat(std::tie(v.name, v.data, v.worldFromObject, v.boundary, v.specular, v.shininess, v.shading),
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

}  // namespace

bool sameObjects(const Scene& a, const Scene& b) {
  return sameLists(a.materials, b.materials) && sameLists(a.meshes, b.meshes) && sameLists(a.volumes, b.volumes) &&
         a.shadows.step == b.shadows.step && a.shadows.tolerance == b.shadows.tolerance;
}

bool sameLightShapes(const Scene& a, const Scene& b) { return sameLists(a.lights, b.lights); }

bool sameMapSettings(const ShadowSettings& a, const ShadowSettings& b) {
  return std::tie(a.technique, a.memory, a.mapSize, a.tolerance) ==
         std::tie(b.technique, b.memory, b.mapSize, b.tolerance);
}

}  // namespace cdsm::scene
