// SPDX-License-Identifier: Apache-2.0
// Radii and colours of atoms; see sphere_look.hpp.
#include "io/sphere_look.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <cdsm/error.hpp>

namespace cdsm::io {
namespace {

bool hasElements(const Molecule& molecule) {
  return std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                     [](const Atom& atom) { return atom.element != kUnknownElement; });
}

}  // namespace

std::array<float, 6> SphereLook::key() const {
  const glm::vec3 rgb = color.value_or(glm::vec3(0.0f));
  return {radius, waters ? 1.0f : 0.0f, color ? 1.0f : 0.0f, rgb.r, rgb.g, rgb.b};
}

std::shared_ptr<const SphereData> makeSpheres(const Molecule& molecule, const SphereLook& look) {
  if (look.radius == 0.0f && molecule.unknown)
    throw Error(molecule.unknown->place, molecule.unknown->name + " is no known element, which has a van der Waals " +
                                             "radius; the scene must give a 'radius' for all");
  const bool colored = look.color || hasElements(molecule);
  std::vector<glm::vec3> centers, colors;
  std::vector<float> radii;
  for (const Atom& atom : molecule.atoms) {
    if (atom.water && !look.waters) continue;
    centers.push_back(atom.position);
    radii.push_back(look.radius > 0.0f ? look.radius : vanDerWaalsRadius(atom.element));
    if (colored) colors.push_back(look.color ? *look.color : elementColor(atom.element));
  }
  if (centers.empty()) throw Error("the file holds water alone, which waters = false leaves out");
  return std::make_shared<SphereData>(SphereData{std::move(centers), std::move(radii), std::move(colors)});
}

}  // namespace cdsm::io
