// SPDX-License-Identifier: Apache-2.0
// XYZ: a number of rows, a comment, rows "element x y z" or "x y z", more columns ignored. Two relatives are read as
// well: extended XYZ, whose comment says which column is what, and bare rows without a number of them before.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/molecule_formats.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {
namespace {

/// Columns of a row, from 0.
struct Layout {
  std::optional<std::size_t> element;
  std::size_t position = 0;

  std::size_t width() const { return std::max(position + 3, element ? *element + 1 : 0); }
};

class XyzReader {
 public:
  XyzReader(const std::string& path, std::string_view text) : path_(path), rest_(text) {}

  Molecule read() {
    const std::string_view first = takeLine(rest_);
    const std::vector<std::string_view> head = words(first);
    if (head.size() > 2) {
      layout_ = layoutOf(head);
      row(head);
      while (!trimmed(rest_).empty()) row(nextLine());
    } else {
      counted(head);
    }
    return std::move(molecule_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Error(Location{path_, line_, 1}, message); }

  std::vector<std::string_view> nextLine() {
    ++line_;
    return words(takeLine(rest_));
  }

  void counted(const std::vector<std::string_view>& head) {
    const auto count = head.size() == 1 ? parseNumber<std::uint64_t>(head[0]) : std::nullopt;
    if (!count) fail("the first line must be the number of atoms, or the first of bare rows \"x y z\"");
    ++line_;
    const std::optional<Layout> described = layoutOfComment(takeLine(rest_));
    for (std::uint64_t i = 0; i < *count; ++i) {
      if (rest_.empty())
        fail("the file ends after " + std::to_string(i) + " of its " + std::to_string(*count) +
             " atoms; is it cut short?");
      const std::vector<std::string_view> columns = nextLine();
      if (i == 0) layout_ = described ? *described : layoutOf(columns);
      row(columns);
    }
    requireEnd(*count);
  }

  /// Further frames of a trajectory may follow, each with a number of atoms.
  void requireEnd(std::uint64_t count) {
    if (trimmed(rest_).empty()) return;
    const std::vector<std::string_view> next = nextLine();
    if (next.size() != 1 || !parseNumber<std::uint64_t>(next[0]))
      fail("there are more rows than the " + std::to_string(count) + " atoms that the first line promises");
  }

  /// The first column is the element if there are more than three, unless bare rows begin with three numbers.
  Layout layoutOf(const std::vector<std::string_view>& columns) const {
    const bool bare = line_ == 1;
    const bool named = !columns.empty() && !parseNumber<double>(columns[0]);
    return (bare ? named : columns.size() > 3) ? Layout{0, 1} : Layout{};
  }

  /// Of extended XYZ: "Properties=species:S:1:pos:R:3", each a name, a type and a number of columns.
  std::optional<Layout> layoutOfComment(std::string_view comment) const {
    constexpr std::string_view kKey = "Properties=";
    const std::size_t at = comment.find(kKey);
    if (at == std::string_view::npos) return std::nullopt;
    std::string_view list = comment.substr(at + kKey.size());
    list = list.substr(0, list.find_first_of(" \t"));
    Layout layout;
    bool hasPosition = false;
    for (std::size_t column = 0; !list.empty();) {
      const std::string_view name = takeField(list);
      takeField(list);
      const std::optional<unsigned> width = parseNumber<unsigned>(takeField(list));
      if (!width) fail("Properties of the comment must be NAME:TYPE:COLUMNS, one after another");
      if (name == "species") layout.element = column;
      if (name == "pos" && *width == 3) layout.position = column, hasPosition = true;
      column += *width;
    }
    if (!hasPosition) fail("Properties of the comment name no pos:R:3, the columns of the coordinates");
    return layout;
  }

  static std::string_view takeField(std::string_view& list) {
    const std::size_t end = std::min(list.find(':'), list.size());
    const std::string_view field = list.substr(0, end);
    list.remove_prefix(std::min(end + 1, list.size()));
    return field;
  }

  void row(const std::vector<std::string_view>& columns) {
    if (columns.size() < layout_.width())
      fail("has " + std::to_string(columns.size()) + " columns, at least " + std::to_string(layout_.width()) +
           " are needed; is the file cut short?");
    Atom atom;
    for (int axis = 0; axis < 3; ++axis)
      atom.position[axis] = moleculeCoordinate(columns[layout_.position + axis], Location{path_, line_, 1});
    if (layout_.element) atom.element = elementOf(columns[*layout_.element]);
    if (atom.element == kUnknownElement && !molecule_.unknown)
      molecule_.unknown = {layout_.element ? quoted(columns[*layout_.element]) : "no element", {path_, line_, 1}};
    molecule_.atoms.push_back(atom);
  }

  std::string path_;
  std::string_view rest_;
  int line_ = 1;
  Layout layout_;
  Molecule molecule_;
};

}  // namespace

Molecule readXyz(const std::string& path, std::string_view text) { return XyzReader(path, text).read(); }

}  // namespace cdsm::io
