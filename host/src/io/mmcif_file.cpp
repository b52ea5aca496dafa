// SPDX-License-Identifier: Apache-2.0
// mmCIF: gemmi's CIF parser, and the table atom_site of the first block that has one.
#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include <gemmi/cif.hpp>

#include "io/molecule_formats.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {
namespace {

using Table = gemmi::cif::Table;

/// Columns of atom_site in the order in which columnNames() asks for them.
enum Column {
  X,
  Y,
  Z,
  Symbol,
  Alternate,
  AuthChain,
  LabelChain,
  AuthNumber,
  LabelNumber,
  Insertion,
  Residue,
  Name,
  Model
};

/// "?": may be missing.
std::vector<std::string> columnNames() {
  return {"Cartn_x",
          "Cartn_y",
          "Cartn_z",
          "type_symbol",
          "?label_alt_id",
          "?auth_asym_id",
          "?label_asym_id",
          "?auth_seq_id",
          "?label_seq_id",
          "?pdbx_PDB_ins_code",
          "?label_comp_id",
          "?label_atom_id",
          "?pdbx_PDB_model_num"};
}

gemmi::cif::Document parse(const std::string& path, const std::string& text) {
  try {
    return gemmi::cif::read_memory(text.data(), text.size(), path.c_str());
  } catch (const tao::pegtl::parse_error& error) {
    const auto place = error.positions().front();
    throw Error(Location{path, static_cast<int>(place.line), static_cast<int>(place.column)},
                "cannot be read as mmCIF: " + printable(error.message()));
  } catch (const std::exception& error) {
    throw Error(Location{path}, "cannot be read as mmCIF: " + printable(error.what()));
  }
}

Table findAtoms(const std::string& path, gemmi::cif::Document& document) {
  for (gemmi::cif::Block& block : document.blocks) {
    Table table = block.find("_atom_site.", columnNames());
    if (table.length() > 0) return table;
  }
  throw Error(Location{path}, "holds no atoms: no table atom_site with Cartn_x, Cartn_y, Cartn_z and type_symbol");
}

class AtomTable {
 public:
  AtomTable(const std::string& path, const std::string& text, gemmi::cif::Document& document)
      : path_(path), text_(text), table_(findAtoms(path, document)) {}

  Molecule firstModel() {
    const std::string model = textOf(table_[0], Model);
    for (Table::Row row : table_) {
      if (textOf(row, Model) != model) break;
      if (isOfFirstConformation(row)) add(row);
    }
    return std::move(molecule_);
  }

 private:
  /// Empty where the value is missing or said to be unknown.
  static std::string textOf(const Table::Row& row, Column column) {
    return row.has2(column) ? gemmi::cif::as_string(row[column]) : std::string();
  }

  bool isOfFirstConformation(const Table::Row& row) {
    const std::string alternate = textOf(row, Alternate);
    if (alternate.empty()) return true;
    const std::string place = textOf(row, row.has2(AuthChain) ? AuthChain : LabelChain) + " " +
                              textOf(row, row.has2(AuthNumber) ? AuthNumber : LabelNumber) + textOf(row, Insertion);
    return first_.has(place, textOf(row, Residue), textOf(row, Name), alternate[0]);
  }

  void add(const Table::Row& row) {
    Atom atom{{coordinate(row, X), coordinate(row, Y), coordinate(row, Z)},
              elementOf(textOf(row, Symbol)),
              isWater(textOf(row, Residue))};
    if (atom.element == kUnknownElement && !molecule_.unknown)
      molecule_.unknown = {io::quoted(row[Symbol]), placeOf(row, row[Symbol])};
    molecule_.atoms.push_back(atom);
  }

  float coordinate(const Table::Row& row, Column axis) const {
    std::string value = row[axis];
    value.resize(std::min(value.find('('), value.size()));  // a standard uncertainty may follow in brackets
    try {
      return moleculeCoordinate(value, {});
    } catch (const Error& error) {
      throw Error(placeOf(row, row[axis]), error.message());
    }
  }

  /// The row's line where each row has its own, as in the files of the archive, else that of the loop.
  Location placeOf(const Table::Row& row, const std::string& value) const {
    if (!table_.loop_item) return {path_};
    const int loop = table_.loop_item->line_number;
    const int likely = loop + static_cast<int>(table_.loop_item->loop.tags.size()) + row.row_index + 1;
    std::string_view rest = text_, line;
    for (int i = 0; i < likely; ++i) line = takeLine(rest);
    return {path_, line.find(value) != std::string_view::npos ? likely : loop, 1};
  }

  const std::string& path_;
  const std::string& text_;
  Table table_;
  FirstConformation first_;
  Molecule molecule_;
};

}  // namespace

Molecule readMmcif(const std::string& path, const std::string& text) {
  gemmi::cif::Document document = parse(path, text);
  return AtomTable(path, text, document).firstModel();
}

}  // namespace cdsm::io
