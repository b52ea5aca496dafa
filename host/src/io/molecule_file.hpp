// SPDX-License-Identifier: Apache-2.0
// Molecules and other particles: PDB, mmCIF or XYZ in, places and elements out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <cdsm/error.hpp>

#include "io/elements.hpp"

namespace cdsm::io {

struct Atom {
  glm::vec3 position;
  ElementId element = kUnknownElement;
  bool water = false;  ///< of a water molecule; XYZ files do not say
};

struct Molecule {
  struct Unknown {
    std::string name;  ///< quoted, or what is there in its place
    Location place;
  };

  std::vector<Atom> atoms;         ///< at least one
  std::optional<Unknown> unknown;  ///< the first atom whose element is not known
};

/// Reads .pdb and .ent, .cif and .mmcif, .xyz, each also with .gz behind: of several models or frames the first, of
/// alternate locations of an atom the first. Coordinates are finite and in the file's own unit, which is the ångström
/// of molecules. Throws Error with file and, where there is one, line.
std::shared_ptr<const Molecule> readMolecule(const std::string& path);

}  // namespace cdsm::io
