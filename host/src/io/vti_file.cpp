// SPDX-License-Identifier: Apache-2.0
// VTK image data; see vti_file.hpp.
#include "io/vti_file.hpp"

#include <cstring>
#include <new>

#include <cdsm/error.hpp>

#include "io/ascii_voxels.hpp"
#include "io/input_file.hpp"
#include "io/text_numbers.hpp"
#include "io/vti_data.hpp"
#include "io/xml_text.hpp"

namespace cdsm::io {

namespace {

/// The XML of a file, which appended data behind it must not disturb: raw ones are no XML.
struct Document {
  std::string path, text;
  std::string header;         ///< the XML without appended data
  std::string_view appended;  ///< these data, from behind their mark _ on
  std::unique_ptr<XmlText> xml;

  pugi::xml_node image() const { return xml->root().child("ImageData"); }
  std::string rootValue(const char* attribute, const char* otherwise) const {
    return xml->root().attribute(attribute).as_string(otherwise);
  }
};

void splitAppended(Document& document) {
  const std::string_view text = document.text;
  const std::size_t tag = text.find("<AppendedData");
  document.header = document.text.substr(0, tag);
  if (tag == std::string_view::npos) return;
  const std::size_t close = text.find('>', tag);
  const std::size_t mark = text.find('_', close);
  constexpr std::string_view kEnd = "</VTKFile>";
  const std::string_view whole = trimmed(text);
  if (mark == std::string_view::npos || whole.size() < kEnd.size() || whole.substr(whole.size() - kEnd.size()) != kEnd)
    throw Error(Location{document.path}, "ends within its appended data; is the file cut short?");
  document.appended = text.substr(mark + 1);
  document.header = document.text.substr(0, close + 1) + "</AppendedData></VTKFile>";
}

void checkRoot(const Document& document) {
  const XmlText& xml = *document.xml;
  if (std::strcmp(xml.root().name(), "VTKFile") != 0 || document.rootValue("type", "") != "ImageData")
    xml.fail(xml.root(), "is not a VTKFile of type ImageData");
  const std::string order = document.rootValue("byte_order", "LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian")
    xml.fail(xml.root(), "byte_order is " + quoted(order) + ", must be LittleEndian or BigEndian");
  const std::string counts = document.rootValue("header_type", "UInt32");
  if (counts != "UInt32" && counts != "UInt64")
    xml.fail(xml.root(), "header_type is " + quoted(counts) + ", must be UInt32 or UInt64");
  const std::string compressor = document.rootValue("compressor", "");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    xml.fail(xml.root(), "compressor is " + quoted(compressor) + "; vtkZLibDataCompressor or none is read");
}

template <typename T>
std::vector<T> readNumbers(const Document& document, pugi::xml_node element, const char* name, const std::string& text,
                           std::size_t count) {
  std::vector<T> numbers;
  for (const std::string_view word : words(text))
    if (const auto number = parseNumber<T>(word)) numbers.push_back(*number);
  if (numbers.size() != count || words(text).size() != count)
    document.xml->fail(element,
                       std::string(name) + " is " + quoted(text) + ", must be " + std::to_string(count) + " numbers");
  return numbers;
}

template <typename T>
std::vector<T> readAttribute(const Document& document, const char* name, const char* otherwise, std::size_t count) {
  const pugi::xml_node image = document.image();
  return readNumbers<T>(document, image, name, image.attribute(name).as_string(otherwise), count);
}

/// Size and place: a point's place is Origin + Direction * (Spacing * its index), and indices begin with the extent.
void readGeometry(const Document& document, StoredVolume& stored) {
  const auto extent = readAttribute<std::int32_t>(document, "WholeExtent", "", 6);
  const auto origin = readAttribute<double>(document, "Origin", "0 0 0", 3);
  const auto spacing = readAttribute<double>(document, "Spacing", "1 1 1", 3);
  const auto direction = readAttribute<double>(document, "Direction", "1 0 0 0 1 0 0 0 1", 9);  // row by row
  glm::dvec4 first(0.0, 0.0, 0.0, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t low = extent[2 * axis], high = extent[2 * axis + 1];
    stored.size[axis] = static_cast<std::uint64_t>(std::max<std::int64_t>(high - low + 1, 0));
    first[axis] = static_cast<double>(low);
    for (int row = 0; row < 3; ++row) stored.objectFromIndex[axis][row] = direction[3 * row + axis] * spacing[axis];
    stored.objectFromIndex[3][axis] = origin[axis];
  }
  stored.objectFromIndex[3] = stored.objectFromIndex * first;
}

pugi::xml_node onlyPiece(const Document& document) {
  const pugi::xml_node piece = document.image().child("Piece");
  if (!piece) document.xml->fail(document.image(), "has no Piece, must have one");
  if (piece.next_sibling("Piece"))
    document.xml->fail(piece.next_sibling("Piece"), "is a second Piece; write the image as one");
  const std::string whole = document.image().attribute("WholeExtent").value();
  const auto extent = [&](const std::string& text) {
    return readNumbers<std::int32_t>(document, piece, "Extent", text, 6);
  };
  if (extent(piece.attribute("Extent").as_string(whole.c_str())) != extent(whole))
    document.xml->fail(piece, "is a Piece of another Extent than WholeExtent; write the image as one piece");
  return piece;
}

std::string describe(pugi::xml_node arrays) {
  std::string list;
  for (const pugi::xml_node array : arrays.children("DataArray"))
    list += (list.empty() ? "" : ", ") + quoted(array.attribute("Name").value());
  return list.empty() ? "none" : list;
}

pugi::xml_node chooseArray(const Document& document, const std::string& name) {
  const pugi::xml_node piece = onlyPiece(document);
  const pugi::xml_node points = piece.child("PointData");
  const std::string wanted = name.empty() ? points.attribute("Scalars").value() : name;
  if (!wanted.empty())
    for (const pugi::xml_node array : points.children("DataArray"))
      if (array.attribute("Name").value() == wanted) return array;
  const pugi::xml_node first = points.child("DataArray");
  if (name.empty() && first && !first.next_sibling("DataArray")) return first;
  if (!first && piece.child("CellData").child("DataArray"))
    document.xml->fail(piece, "has cell data alone; point data are read (filter Cell Data to Point Data)");
  const std::string lack = wanted.empty() ? "has no array called its Scalars" : "has no point data " + quoted(wanted);
  document.xml->fail(piece, lack + "; name one with array = \"...\", its arrays of points are: " + describe(points));
}

StoredType readType(const Document& document, pugi::xml_node array) {
  const std::string components = array.attribute("NumberOfComponents").as_string("1");
  if (components != "1")
    document.xml->fail(array, "array " + quoted(array.attribute("Name").value()) + " has " + quoted(components) +
                                  " components; a volume has one");
  const std::string name = array.attribute("type").value();
  const auto type = storedTypeOf(name);
  if (!type) document.xml->fail(array, "type is " + quoted(name) + "; Int8 to UInt64, Float32 and Float64 are read");
  return *type;
}

/// Where the array's data begin, inline or appended.
VtiData dataOf(const Document& document, pugi::xml_node array, const std::string& format) {
  VtiData data;
  data.compressed = !document.rootValue("compressor", "").empty();
  data.countBytes = document.rootValue("header_type", "UInt32") == "UInt64" ? 8 : 4;
  data.bigEndian = document.rootValue("byte_order", "") == "BigEndian";
  if (format == "binary") {
    data.text = array.text().get();
    data.base64 = true;
    return data;
  }
  const std::string encoding = document.xml->root().child("AppendedData").attribute("encoding").value();
  if (encoding != "raw" && encoding != "base64")
    document.xml->fail(array, "is appended with encoding " + quoted(encoding) + ", must be raw or base64");
  const std::string_view offset = array.attribute("offset").value();
  const auto at = parseNumber<std::uint64_t>(offset);
  if (!at || *at >= document.appended.size())
    document.xml->fail(array, "offset is " + quoted(offset) + ", must be within the appended data of " +
                                  std::to_string(document.appended.size()) + " bytes");
  data.text = document.appended.substr(static_cast<std::size_t>(*at));
  data.base64 = encoding == "base64";
  return data;
}

void readVoxels(const Document& document, pugi::xml_node array, StoredVolume& stored) {
  const std::string& path = document.path;
  const std::uint64_t bytes = checkedBytes(path, stored.size, stored.type);
  const std::string format = array.attribute("format").as_string("ascii");
  if (format == "ascii") {
    stored.bytes = parseAsciiVoxels(path, array.text().get(), bytes / storedBytes(stored.type), stored.type);
    stored.bigEndian = hostIsBigEndian();
  } else if (format == "binary" || format == "appended") {
    stored.bytes = readVtiData(path, dataOf(document, array, format), bytes);
    stored.bigEndian = document.rootValue("byte_order", "") == "BigEndian";
  } else {
    document.xml->fail(array, "format is " + quoted(format) + ", must be ascii, binary or appended");
  }
}

}  // namespace

StoredVolume readVti(const std::string& path, const std::string& array) {
  try {
    Document document;
    document.path = path;
    document.text = readText(path);
    splitAppended(document);
    document.xml = std::make_unique<XmlText>(path, document.header);
    checkRoot(document);
    StoredVolume stored;
    readGeometry(document, stored);
    const pugi::xml_node chosen = chooseArray(document, array);
    stored.type = readType(document, chosen);
    readVoxels(document, chosen, stored);
    return stored;
  } catch (const std::bad_alloc&) {
    throw Error(Location{path}, "there is no memory for its voxels");
  }
}

}  // namespace cdsm::io
