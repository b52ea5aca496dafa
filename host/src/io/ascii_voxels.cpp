// SPDX-License-Identifier: Apache-2.0
// Numbers as text to bytes; see ascii_voxels.hpp.
#include "io/ascii_voxels.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <cdsm/error.hpp>

#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

template <typename T>
void append(std::vector<std::byte>& bytes, const std::string& path, std::string_view word, std::uint64_t index) {
  const std::optional<T> value = parseNumber<T>(word);
  if (!value)
    throw Error(Location{path}, "number " + std::to_string(index + 1) + " of its voxels is " + quoted(word) +
                                    ", which the type in the header cannot hold");
  bytes.resize(bytes.size() + sizeof(T));
  std::memcpy(bytes.data() + bytes.size() - sizeof(T), &*value, sizeof(T));
}

using Append = void (*)(std::vector<std::byte>&, const std::string&, std::string_view, std::uint64_t);

Append appendOf(StoredType type) {
  switch (type) {
    case StoredType::UInt8:
      return append<std::uint8_t>;
    case StoredType::Int8:
      return append<std::int8_t>;
    case StoredType::UInt16:
      return append<std::uint16_t>;
    case StoredType::Int16:
      return append<std::int16_t>;
    case StoredType::UInt32:
      return append<std::uint32_t>;
    case StoredType::Int32:
      return append<std::int32_t>;
    case StoredType::UInt64:
      return append<std::uint64_t>;
    case StoredType::Int64:
      return append<std::int64_t>;
    case StoredType::Float32:
      return append<float>;
    default:
      return append<double>;
  }
}

}  // namespace

std::vector<std::byte> parseAsciiVoxels(const std::string& path, std::string text, std::uint64_t count,
                                        StoredType type) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::string_view rest = text;
  std::vector<std::byte> bytes;
  const Append appendNumber = appendOf(type);
  std::uint64_t found = 0;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest), ++found)
    if (found < count) appendNumber(bytes, path, word, found);
  if (found != count)
    throw Error(Location{path},
                "holds " + std::to_string(found) + " voxels as text, but its header asks for " + std::to_string(count));
  return bytes;
}

std::vector<std::byte> readAsciiVoxels(const DataBlock& block, std::uint64_t count, StoredType type) {
  std::string text = readText(block.path);
  text.erase(0, std::min<std::uint64_t>(text.size(), block.offset + block.skip));
  return parseAsciiVoxels(block.path, std::move(text), count, type);
}

}  // namespace cdsm::io
