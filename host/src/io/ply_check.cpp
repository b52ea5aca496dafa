// SPDX-License-Identifier: Apache-2.0
// PLY before assimp: walks over every value that the header announces; see mesh_check.hpp.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/mesh_check.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

struct Property {
  std::string name;
  bool isList = false;
  Scalar count = Scalar::UInt8;  ///< of a list's length
  Scalar value = Scalar::Float32;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Format { Unknown, Ascii, Little, Big };

struct PlyHeader {
  Format format = Format::Unknown;
  std::vector<Element> elements;
  std::string_view data;  ///< what follows the header
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
};

class HeaderParser {
 public:
  HeaderParser(const std::string& path, std::string_view text) : path_(path), rest_(text) {}

  PlyHeader parse() {
    if (trimmed(takeLine(rest_)) != "ply") fail("is not a PLY file; its first line must be \"ply\"");
    for (line_ = 2; !rest_.empty(); ++line_) {
      const std::vector<std::string_view> line = words(takeLine(rest_));
      if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
      if (line[0] == "end_header") return finished();
      if (line[0] == "format")
        format(line);
      else if (line[0] == "element")
        element(line);
      else if (line[0] == "property")
        property(line);
      else
        fail(quoted(line[0]) + " is no word of a PLY header");
    }
    fail("the header has no end_header; is the file cut short?");
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Error(Location{path_, line_, 1}, message); }

  PlyHeader finished() {
    if (header_.format == Format::Unknown)
      fail("the header names no format; ascii, binary_little_endian or binary_big_endian is needed");
    header_.data = rest_;
    return std::move(header_);
  }

  void format(const std::vector<std::string_view>& line) {
    const std::string_view name = line.size() > 1 ? line[1] : "";
    if (name == "ascii")
      header_.format = Format::Ascii;
    else if (name == "binary_little_endian")
      header_.format = Format::Little;
    else if (name == "binary_big_endian")
      header_.format = Format::Big;
    else
      fail("the format is none of ascii, binary_little_endian and binary_big_endian");
  }

  void element(const std::vector<std::string_view>& line) {
    const auto count = line.size() == 3 ? parseNumber<std::uint64_t>(line[2]) : std::nullopt;
    if (!count) fail("an element needs a name and a count");
    header_.elements.push_back({std::string(line[1]), *count, {}});
    if (line[1] == "vertex") header_.vertices = *count;
    if (line[1] == "face") header_.faces = *count;
  }

  void property(const std::vector<std::string_view>& line) {
    if (header_.elements.empty()) fail("a property must follow the element that it belongs to");
    const bool isList = line.size() > 1 && line[1] == "list";
    if (line.size() != (isList ? 5 : 3))
      fail("a property is \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
    Property property{std::string(line.back()), isList, Scalar::UInt8, scalar(line[line.size() - 2])};
    if (isList) property.count = scalar(line[2]);
    header_.elements.back().properties.push_back(property);
  }

  Scalar scalar(std::string_view name) const {
    if (name == "char" || name == "int8") return Scalar::Int8;
    if (name == "uchar" || name == "uint8") return Scalar::UInt8;
    if (name == "short" || name == "int16") return Scalar::Int16;
    if (name == "ushort" || name == "uint16") return Scalar::UInt16;
    if (name == "int" || name == "int32") return Scalar::Int32;
    if (name == "uint" || name == "uint32") return Scalar::UInt32;
    if (name == "float" || name == "float32") return Scalar::Float32;
    if (name == "double" || name == "float64") return Scalar::Float64;
    fail(quoted(name) + " is no type of PLY");
  }

  std::string path_;
  std::string_view rest_;
  int line_ = 1;
  PlyHeader header_;
};

/// The data as a row of numbers, from text or bytes.
class Values {
 public:
  Values(const std::string& path, const PlyHeader& header) : path_(path), format_(header.format), rest_(header.data) {}

  double next(Scalar type, const Element& element, std::uint64_t index) {
    if (format_ == Format::Ascii) return nextWord(element, index);
    switch (type) {
      case Scalar::Int8:
        return nextBinary<std::int8_t>(element, index);
      case Scalar::UInt8:
        return nextBinary<std::uint8_t>(element, index);
      case Scalar::Int16:
        return nextBinary<std::int16_t>(element, index);
      case Scalar::UInt16:
        return nextBinary<std::uint16_t>(element, index);
      case Scalar::Int32:
        return nextBinary<std::int32_t>(element, index);
      case Scalar::UInt32:
        return nextBinary<std::uint32_t>(element, index);
      case Scalar::Float32:
        return nextBinary<float>(element, index);
      default:
        return nextBinary<double>(element, index);
    }
  }

  [[noreturn]] void fail(const Element& element, std::uint64_t index, const std::string& message) const {
    throw Error(Location{path_}, element.name + " " + std::to_string(index) + " of " + std::to_string(element.count) +
                                     " (from 0) " + message);
  }

 private:
  [[noreturn]] void failShort(const Element& element, std::uint64_t index) const {
    fail(element, index, "is missing or incomplete; is the file cut short?");
  }

  double nextWord(const Element& element, std::uint64_t index) {
    const std::string_view word = takeWord(rest_);
    if (word.empty()) failShort(element, index);
    const std::optional<double> value = parseNumber<double>(word);
    if (!value) fail(element, index, "holds " + quoted(word) + " where a number is needed");
    return *value;
  }

  template <typename T>
  double nextBinary(const Element& element, std::uint64_t index) {
    if (rest_.size() < sizeof(T)) failShort(element, index);
    char bytes[sizeof(T)];
    std::memcpy(bytes, rest_.data(), sizeof(T));
    if (format_ == Format::Big)
      std::reverse(bytes, bytes + sizeof(T));  // the hosts that OpenCL runs on are little endian
    rest_.remove_prefix(sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  }

  std::string path_;
  Format format_;
  std::string_view rest_;
};

void checkList(Values& values, const PlyHeader& header, const Element& element, std::uint64_t index,
               const Property& list) {
  const double length = values.next(list.count, element, index);
  if (!(length >= 0.0) || length != std::floor(length))
    values.fail(element, index, "has a list of negative or broken length");
  const bool isFace = list.name == "vertex_indices" || list.name == "vertex_index";
  for (double i = 0; i < length; ++i) {
    const double value = values.next(list.value, element, index);
    if (isFace && !(value >= 0.0 && value < static_cast<double>(header.vertices)))
      values.fail(element, index, "uses a vertex that does not exist; the file has " + std::to_string(header.vertices));
  }
}

void checkElement(Values& values, const PlyHeader& header, const Element& element, std::uint64_t index) {
  for (const Property& property : element.properties) {
    if (property.isList)
      checkList(values, header, element, index, property);
    else if (!std::isfinite(values.next(property.value, element, index)) && element.name == "vertex")
      values.fail(element, index, "has a " + property.name + " that is not a finite number");
  }
}

}  // namespace

std::uint64_t checkPly(const std::string& path) {
  const std::string text = readText(path);
  const PlyHeader header = HeaderParser(path, text).parse();
  Values values(path, header);
  for (const Element& element : header.elements)
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
      checkElement(values, header, element, i);
  return header.faces;
}

}  // namespace cdsm::io
