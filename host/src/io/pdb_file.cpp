// SPDX-License-Identifier: Apache-2.0
// PDB through gemmi, which takes what it cannot read for 0: so the records of atoms are checked first.
#include <cstddef>
#include <exception>

#include <gemmi/pdb.hpp>

#include "io/molecule_formats.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {
namespace {

bool isRecord(std::string_view line, std::string_view name) {
  return trimmed(line.substr(0, 6)) == name;  // the record's name takes six columns
}

bool isAtom(std::string_view line) { return isRecord(line, "ATOM") || isRecord(line, "HETATM"); }

/// Columns from `first`, which counts from 0.
std::string_view columns(std::string_view line, std::size_t first, std::size_t count) {
  return first < line.size() ? trimmed(line.substr(first, count)) : std::string_view();
}

/// Checks the first model and finds its end.
class PdbCheck {
 public:
  PdbCheck(const std::string& path, std::string_view text) : path_(path), text_(text), rest_(text) {}

  /// What of the text to read.
  std::string_view firstModel() {
    bool complete = true, entry = false;  // entry: of the archive, so that END must come
    while (!rest_.empty()) {
      ++line_;
      const std::string_view line = takeLine(rest_);
      if (line.substr(0, 5) == "data_") fail("is mmCIF, whose files must end in .cif");
      if (isAtom(line)) atom(line);
      entry = entry || isRecord(line, "HEADER");
      if (isRecord(line, "MODEL")) complete = false;
      if (isRecord(line, "END")) entry = false, rest_ = {};
      if (isRecord(line, "ENDMDL")) return text_.substr(0, text_.size() - rest_.size());
    }
    if (!complete) fail("a MODEL has no ENDMDL; is the file cut short?");
    if (entry) fail("an entry with a HEADER has no END; is the file cut short?");
    return text_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Error(Location{path_, line_, 1}, message); }

  void atom(std::string_view line) const {
    constexpr std::size_t kWidth = 8;
    constexpr std::size_t kCoordinates[] = {30, 38, 46};
    if (line.size() < kCoordinates[2] + kWidth)
      fail("the record of an atom is too short for three coordinates; is the file cut short?");
    for (const std::size_t column : kCoordinates)
      moleculeCoordinate(columns(line, column, kWidth), Location{path_, line_, static_cast<int>(column) + 1});
  }

  std::string path_;
  std::string_view text_, rest_;
  int line_ = 0;
};

gemmi::Structure parse(const std::string& path, std::string text) {
  text += '\n';  // a last record without its line end is complete all the same
  try {
    return gemmi::read_pdb_string(text, path);
  } catch (const std::exception& error) {
    throw Error(Location{path}, "cannot be read as PDB: " + printable(error.what()));
  }
}

/// Where the atom stands: only asked for when it is at fault.
int lineOf(std::string_view text, const gemmi::Atom& atom) {
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::string_view line = takeLine(text);
    if (!isAtom(line) || columns(line, 12, 4) != atom.name) continue;
    if (parseNumber<double>(columns(line, 30, 8)) == atom.pos.x) return number;
  }
  return 0;
}

}  // namespace

Molecule readPdb(const std::string& path, const std::string& text) {
  const std::string model(PdbCheck(path, text).firstModel());
  const gemmi::Structure structure = parse(path, model);
  Molecule molecule;
  FirstConformation first;
  for (const gemmi::Chain& chain : structure.models.at(0).chains) {
    for (const gemmi::Residue& residue : chain.residues) {
      const std::string place = chain.name + " " + residue.seqid.str();
      for (const gemmi::Atom& atom : residue.atoms) {
        if (!first.has(place, residue.name, atom.name, atom.altloc)) continue;
        const auto element = static_cast<ElementId>(atom.element.elem);
        if (element == kUnknownElement && !molecule.unknown)
          molecule.unknown = {io::quoted(atom.name), {path, lineOf(model, atom), 1}};
        molecule.atoms.push_back({glm::vec3(atom.pos.x, atom.pos.y, atom.pos.z), element, isWater(residue.name)});
      }
    }
  }
  return molecule;
}

}  // namespace cdsm::io
