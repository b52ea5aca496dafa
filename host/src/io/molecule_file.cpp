// SPDX-License-Identifier: Apache-2.0
// Chooses the reader of a molecule file; see molecule_file.hpp.
#include "io/molecule_file.hpp"

#include <algorithm>
#include <iterator>

#include "io/input_file.hpp"
#include "io/molecule_formats.hpp"
#include "io/text_numbers.hpp"
#include "scene/range.hpp"

namespace cdsm::io {
namespace {

using Reader = Molecule (*)(const std::string&, const std::string&);

Reader readerFor(const std::string& path) {
  const auto ends = [&path](const char* ending) {
    return hasEnding(path, ending) || hasEnding(path, ending + std::string(".gz"));
  };
  if (ends(".pdb") || ends(".ent")) return readPdb;
  if (ends(".cif") || ends(".mmcif")) return readMmcif;
  if (ends(".xyz")) return [](const std::string& name, const std::string& text) { return readXyz(name, text); };
  throw Error(Location{path},
              "is not known as a molecule by its ending; spheres are read from .pdb, .ent, .cif, .mmcif and .xyz, "
              "plain or with .gz behind");
}

}  // namespace

float moleculeCoordinate(std::string_view word, const Location& place) {
  const std::optional<double> value = parseNumber<double>(word);
  if (value && scene::kCoordinate.contains(*value)) return static_cast<float>(*value);
  throw Error(place, quoted(word) + " is no coordinate, must be a number " + scene::kCoordinate.text());
}

bool isWater(std::string_view residue) {
  constexpr std::string_view kNames[] = {"HOH", "DOD", "H2O", "WAT", "SOL", "TIP"};
  return std::find(std::begin(kNames), std::end(kNames), residue.substr(0, 3)) != std::end(kNames);
}

bool FirstConformation::has(const std::string& place, const std::string& residue, const std::string& atom,
                            char alternate) {
  if (alternate == '\0') return true;
  Seen& seen = seen_.try_emplace(place, Seen{residue, {}}).first->second;
  return seen.residue == residue && seen.alternates.try_emplace(atom, alternate).first->second == alternate;
}

std::shared_ptr<const Molecule> readMolecule(const std::string& path) {
  const Reader read = readerFor(path);
  auto molecule = std::make_shared<Molecule>(read(path, readUnpackedText(path)));
  if (molecule->atoms.empty()) throw Error(Location{path}, "holds no atoms; at least one is needed");
  return molecule;
}

}  // namespace cdsm::io
