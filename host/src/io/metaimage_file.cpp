// SPDX-License-Identifier: Apache-2.0
// MetaImage; see metaimage_file.hpp.
#include "io/metaimage_file.hpp"

#include <map>
#include <optional>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 20;

struct Entry {
  std::string value;
  int line = 0;
};

/// The header's keys, and where the bytes behind its last line begin.
struct Header {
  std::string path;
  std::map<std::string, Entry, std::less<>> entries;
  std::uint64_t end = 0;

  /// The first of several names of one thing.
  const Entry* find(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (const auto at = entries.find(name); at != entries.end()) return &at->second;
    return nullptr;
  }
  const Entry& need(const char* name) const {
    const Entry* entry = find({name});
    if (!entry) throw Error(Location{path}, "its header has no " + std::string(name));
    return *entry;
  }
  [[noreturn]] void fail(const Entry& entry, const std::string& message) const {
    throw Error(Location{path, entry.line, 1}, message);
  }
};

Header readHeader(const std::string& path) {
  const std::string text = readText(path, kMaxHeaderBytes);
  Header header{path, {}, 0};
  std::string_view rest = text;
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view content = trimmed(takeLine(rest));
    if (content.empty()) continue;
    const std::size_t equals = content.find('=');
    if (equals == std::string_view::npos)
      throw Error(Location{path, line, 1}, "is not a line \"Key = value\" of a MetaImage header");
    const std::string key(trimmed(content.substr(0, equals)));
    header.entries[key] = Entry{std::string(trimmed(content.substr(equals + 1))), line};
    header.end = text.size() - rest.size();
    if (key == "ElementDataFile") return header;
  }
  throw Error(Location{path}, "its header has no ElementDataFile, which must be its last line");
}

bool readFlag(const Header& header, std::initializer_list<const char*> names, bool otherwise) {
  const Entry* entry = header.find(names);
  if (!entry || entry->value.empty()) return otherwise;
  const char first = entry->value.front();
  if (first == 'T' || first == 't' || first == '1') return true;
  if (first == 'F' || first == 'f' || first == '0') return false;
  header.fail(*entry, quoted(entry->value) + " is neither True nor False");
}

template <typename T>
std::vector<T> readNumbers(const Header& header, const Entry& entry, std::size_t count) {
  std::vector<T> numbers;
  for (const std::string_view word : words(entry.value)) {
    const std::optional<T> number = parseNumber<T>(word);
    if (!number) header.fail(entry, quoted(word) + " is not a number that can stand here");
    numbers.push_back(*number);
  }
  if (numbers.size() != count)
    header.fail(entry, std::to_string(numbers.size()) + " numbers where " + std::to_string(count) + " are needed");
  return numbers;
}

/// ITK writes and reads MET_LONG as 4 bytes.
const std::map<std::string, StoredType>& elementTypes() {
  static const std::map<std::string, StoredType> types = {
      {"MET_CHAR", StoredType::Int8},         {"MET_UCHAR", StoredType::UInt8},   {"MET_SHORT", StoredType::Int16},
      {"MET_USHORT", StoredType::UInt16},     {"MET_INT", StoredType::Int32},     {"MET_UINT", StoredType::UInt32},
      {"MET_LONG", StoredType::Int32},        {"MET_ULONG", StoredType::UInt32},  {"MET_LONG_LONG", StoredType::Int64},
      {"MET_ULONG_LONG", StoredType::UInt64}, {"MET_FLOAT", StoredType::Float32}, {"MET_DOUBLE", StoredType::Float64}};
  return types;
}

StoredType readType(const Header& header) {
  const Entry& entry = header.need("ElementType");
  const auto at = elementTypes().find(entry.value);
  if (at == elementTypes().end())
    header.fail(entry, "ElementType " + printable(entry.value) +
                           " is not read; MET_UCHAR, MET_SHORT, MET_FLOAT and the like are");
  return at->second;
}

/// Number of dimensions, at least 3; those beyond the third must have size 1.
std::size_t readDimensions(const Header& header, StoredVolume& stored) {
  const Entry& entry = header.need("NDims");
  const int count = readNumbers<int>(header, entry, 1)[0];
  if (count < 3 || count > 10)
    header.fail(entry, "has " + std::to_string(count) + " dimensions; a volume is one scalar grid of three");
  const Entry& sizeEntry = header.need("DimSize");
  const auto sizes = readNumbers<std::uint64_t>(header, sizeEntry, static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (i < 3)
      stored.size[i] = sizes[i];
    else if (sizes[i] != 1)
      header.fail(sizeEntry, "has more than one time step; a volume is one grid of three dimensions");
  }
  return sizes.size();
}

void checkScalarImage(const Header& header) {
  const Entry* object = header.find({"ObjectType"});
  if (object && object->value != "Image")
    header.fail(*object, "ObjectType is " + printable(object->value) + "; Image is needed");
  const Entry* channels = header.find({"ElementNumberOfChannels"});
  if (channels && channels->value != "1")
    header.fail(*channels, "has " + printable(channels->value) + " components per voxel; a volume has one");
  if (!readFlag(header, {"BinaryData"}, true))
    header.fail(*header.find({"BinaryData"}), "numbers as text are not read; write the file with BinaryData = True");
}

glm::dmat4 readMatrix(const Header& header, std::size_t dimensions) {
  glm::dmat4 matrix(1.0);
  if (const Entry* entry = header.find({"TransformMatrix", "Rotation", "Orientation"})) {
    const auto numbers = readNumbers<double>(header, *entry, dimensions * dimensions);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t row = 0; row < 3; ++row) matrix[axis][row] = numbers[axis * dimensions + row];
  }
  if (const Entry* entry = header.find({"ElementSpacing", "ElementSize"})) {
    const auto spacing = readNumbers<double>(header, *entry, dimensions);
    for (std::size_t axis = 0; axis < 3; ++axis) matrix[axis] *= spacing[axis];
  }
  if (const Entry* entry = header.find({"Offset", "Position", "Origin"})) {
    const auto origin = readNumbers<double>(header, *entry, dimensions);
    for (std::size_t row = 0; row < 3; ++row) matrix[3][row] = origin[row];
  }
  return matrix;
}

DataBlock dataBlock(const Header& header, std::uint64_t bytes) {
  const Entry& entry = header.need("ElementDataFile");
  if (entry.value == "LIST" || words(entry.value).size() > 1 || entry.value.find('%') != std::string::npos)
    header.fail(entry, "data in a list of files are not read; write the volume into one file");
  if (entry.value.empty()) header.fail(entry, "ElementDataFile names no file; LOCAL or a file name is needed");
  const bool local = entry.value == "LOCAL" || entry.value == "Local" || entry.value == "local";
  DataBlock block;
  block.path = local ? header.path : besideHeader(header.path, entry.value);
  block.offset = local ? header.end : 0;
  if (readFlag(header, {"CompressedData"}, false)) block.encoding = DataBlock::Encoding::Deflated;
  const Entry* skip = local ? nullptr : header.find({"HeaderSize"});
  if (!skip) return block;
  const long long count = readNumbers<long long>(header, *skip, 1)[0];
  const std::uint64_t held = inputFileSize(block.path);
  if (count >= 0)
    block.offset = static_cast<std::uint64_t>(count);
  else if (block.encoding == DataBlock::Encoding::Raw && held > bytes)
    block.offset = held - bytes;  // -1: the last bytes
  return block;
}

}  // namespace

StoredVolume readMetaImage(const std::string& path) {
  const Header header = readHeader(path);
  checkScalarImage(header);
  StoredVolume stored;
  stored.type = readType(header);
  const std::size_t dimensions = readDimensions(header, stored);
  stored.objectFromIndex = readMatrix(header, dimensions);
  stored.bigEndian = readFlag(header, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  const std::uint64_t bytes = checkedBytes(path, stored.size, stored.type);
  stored.bytes = readBlock(dataBlock(header, bytes), bytes);
  return stored;
}

}  // namespace cdsm::io
