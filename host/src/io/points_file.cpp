// SPDX-License-Identifier: Apache-2.0
// CSV in and out; see points_file.hpp.
#include "io/points_file.hpp"

#include <cmath>
#include <fstream>
#include <iostream>

#include <cdsm/error.hpp>

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

/// One value of a row, without the spaces around it, and where it stands.
struct Cell {
  std::string_view text;
  int column = 1;
};

std::vector<Cell> cells(std::string_view line) {
  std::vector<Cell> row;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    const std::string_view raw = line.substr(at, comma - at);
    const std::size_t blanks = std::min(raw.find_first_not_of(" \t"), raw.size());
    row.push_back({trimmed(raw), static_cast<int>(at + blanks) + 1});
    at = comma + 1;
  }
  return row;
}

void checkHeader(const std::string& path, std::string_view line) {
  const std::vector<Cell> row = cells(line);
  const bool good = row.size() == 3 && row[0].text == "x" && row[1].text == "y" && row[2].text == "z";
  if (!good) throw Error(Location{path, 1, 1}, "the first line must be the header x,y,z");
}

float coordinate(const std::string& path, int line, const Cell& cell) {
  if (const std::optional<float> value = parseNumber<float>(cell.text); value && std::isfinite(*value)) return *value;
  if (const std::optional<double> tiny = parseNumber<double>(cell.text); tiny && std::abs(*tiny) < 1.0)
    return static_cast<float>(*tiny);  // below the smallest float
  throw Error(Location{path, line, cell.column}, quoted(cell.text) + " is not a finite number (of float range)");
}

glm::vec3 parsePoint(const std::string& path, int line, std::string_view text) {
  const std::vector<Cell> row = cells(text);
  if (row.size() < 3)
    throw Error(Location{path, line, static_cast<int>(text.size()) + 1}, "a point needs three values x,y,z");
  if (row.size() > 3)
    throw Error(Location{path, line, row[3].column}, "a point has three values x,y,z; this is a fourth");
  return glm::vec3(coordinate(path, line, row[0]), coordinate(path, line, row[1]), coordinate(path, line, row[2]));
}

void appendNumber(std::string& text, float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  text.append(digits, end);
}

void appendNumbers(std::string& text, const glm::vec3& values) {
  for (int i = 0; i < 3; ++i) {
    if (i > 0) text += ',';
    appendNumber(text, values[i]);
  }
}

}  // namespace

std::vector<glm::vec3> readPoints(const std::string& path) {
  const std::string text = readText(path);
  std::string_view rest = text;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest.substr(0, kByteOrderMark.size()) == kByteOrderMark) rest.remove_prefix(kByteOrderMark.size());
  checkHeader(path, takeLine(rest));
  std::vector<glm::vec3> points;
  for (int line = 2; !trimmed(rest).empty(); ++line) {
    const std::string_view content = takeLine(rest);
    if (trimmed(content).empty()) throw Error(Location{path, line, 1}, "is a blank line among the points; remove it");
    points.push_back(parsePoint(path, line, content));
  }
  return points;
}

void writeTransmittances(std::ostream& out, const std::vector<glm::vec3>& points,
                         const std::vector<Transmittance>& transmittances, LightColumns columns) {
  if (points.size() != transmittances.size())
    throw Error(std::to_string(points.size()) + " points with " + std::to_string(transmittances.size()) +
                " transmittances cannot be written; there must be one for each");
  const bool colored = columns == LightColumns::Colors;
  std::string text = colored ? "x,y,z,lit,r,g,b\n" : "x,y,z,lit,transmittance\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Transmittance& light = transmittances[i];
    appendNumbers(text, points[i]);
    text += light.lit ? ",1," : ",0,";
    if (colored)
      appendNumbers(text, light.color);
    else
      appendNumber(text, light.transmittance);
    text += '\n';
  }
  out << text << std::flush;
  if (!out) throw Error("the transmittances cannot be written; is the disk full or the reader gone?");
}

void writeTransmittances(const std::string& path, const std::vector<glm::vec3>& points,
                         const std::vector<Transmittance>& transmittances, LightColumns columns) {
  if (path == "-") return writeTransmittances(std::cout, points, transmittances, columns);
  AtomicFile file(path);
  std::ofstream stream(file.temporaryPath(), std::ios::binary);
  writeTransmittances(stream, points, transmittances, columns);
  stream.close();
  if (!stream) throw Error(Location{path}, "cannot be written; is the disk full?");
  file.commit();
}

}  // namespace cdsm::io
