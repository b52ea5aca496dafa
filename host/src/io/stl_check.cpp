// SPDX-License-Identifier: Apache-2.0
// STL before assimp; see mesh_check.hpp.
#include <cmath>
#include <cstdint>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/mesh_check.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

constexpr std::size_t kBinaryHeaderBytes = 84;  // 80 of comment, 4 of triangle count
constexpr std::uint64_t kTriangleBytes = 50;

/// The count, little endian in bytes 80 to 83, if the size of the data is the right one for it.
std::optional<std::uint64_t> binaryTriangles(const std::string& data) {
  if (data.size() < kBinaryHeaderBytes) return std::nullopt;
  std::uint64_t count = 0;
  for (int i = 3; i >= 0; --i) count = count << 8 | static_cast<unsigned char>(data[80 + i]);
  if (data.size() != kBinaryHeaderBytes + count * kTriangleBytes) return std::nullopt;
  return count;
}

void checkVertex(const std::string& path, int line, std::string_view text) {
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = takeWord(text);
    const std::optional<double> value = parseNumber<double>(word);
    if (!value || !std::isfinite(static_cast<float>(*value)))
      throw Error(Location{path, line, 1}, quoted(word) + " is not a finite number; a vertex has three");
  }
}

std::uint64_t checkText(const std::string& path, std::string_view rest) {
  std::uint64_t facets = 0;
  int verticesInFacet = 0;
  bool ended = false;
  for (int line = 1; !rest.empty(); ++line) {
    std::string_view text = takeLine(rest);
    const std::string_view keyword = takeWord(text);
    if (keyword == "facet") verticesInFacet = 0;
    if (keyword == "vertex") {
      checkVertex(path, line, text);
      ++verticesInFacet;
    }
    if (keyword == "endfacet" && verticesInFacet != 3)
      throw Error(Location{path, line, 1},
                  "a facet has " + std::to_string(verticesInFacet) + " vertices; three are needed");
    if (keyword == "endfacet") ++facets;
    ended = keyword == "endsolid" || (ended && keyword.empty());
  }
  if (!ended) throw Error(Location{path}, "does not end with endsolid; is the file cut short?");
  return facets;
}

}  // namespace

std::uint64_t checkStl(const std::string& path) {
  const std::string data = readText(path);
  if (const std::optional<std::uint64_t> triangles = binaryTriangles(data)) return *triangles;
  std::string_view start = std::string_view(data).substr(0, 200);
  if (takeWord(start) != "solid" || data.find('\0') != std::string::npos)
    throw Error(Location{path},
                "its size does not match the number of triangles that it claims; is the file cut short?");
  return checkText(path, data);
}

}  // namespace cdsm::io
