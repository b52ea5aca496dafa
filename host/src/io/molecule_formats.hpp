// SPDX-License-Identifier: Apache-2.0
// The readers behind readMolecule(), one for each format, and what they share. `path` is for messages.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "io/molecule_file.hpp"

namespace cdsm::io {

Molecule readPdb(const std::string& path, const std::string& text);
Molecule readMmcif(const std::string& path, const std::string& text);
Molecule readXyz(const std::string& path, std::string_view text);

/// A finite number of the range of coordinates. Throws Error at `place`.
float moleculeCoordinate(std::string_view word, const Location& place);

/// Whether residues of that name are water, in files of the archive and of simulations.
bool isWater(std::string_view residue);

/// Which atoms of a structure with alternate locations make its first conformation.
class FirstConformation {
 public:
  /// `place`: chain and number of the residue; `alternate`: the location's letter, 0 for none.
  bool has(const std::string& place, const std::string& residue, const std::string& atom, char alternate);

 private:
  struct Seen {
    std::string residue;
    std::map<std::string, char> alternates;  ///< the first one, by the atom's name
  };
  std::map<std::string, Seen> seen_;
};

}  // namespace cdsm::io
