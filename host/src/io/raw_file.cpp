// SPDX-License-Identifier: Apache-2.0
// Raw voxels; see raw_file.hpp.
#include "io/raw_file.hpp"

#include <filesystem>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

/// Takes what stands behind the last _ off the name, the _ too.
std::string_view takeLastPart(std::string_view& name) {
  const std::size_t at = name.rfind('_');
  if (at == std::string_view::npos) return {};
  const std::string_view part = name.substr(at + 1);
  name = name.substr(0, at);
  return part;
}

/// AxBxC; nothing for anything else.
std::optional<std::array<std::uint64_t, 3>> parseSize(std::string_view text) {
  std::array<std::uint64_t, 3> size{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? text.find('x') : text.size();
    if (end == std::string_view::npos) return std::nullopt;
    const auto side = parseNumber<std::uint64_t>(text.substr(0, end));
    if (!side) return std::nullopt;
    size[axis] = *side;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return size;
}

}  // namespace

StoredVolume readRaw(const std::string& path) {
  const bool gzip = hasEnding(path, ".gz");
  const std::string file = std::filesystem::path(path).filename().string();
  std::string_view name = std::string_view(file).substr(0, file.size() - (gzip ? 7 : 4));  // without .raw.gz or .raw
  const auto type = storedTypeOf(takeLastPart(name));
  const auto size = parseSize(takeLastPart(name));
  if (!type || !size)
    throw Error(Location{path},
                "has no size and type in its name; a raw file is called like NAME_256x256x128_uint8.raw, with uint8, "
                "int8, uint16, int16, uint32, int32, uint64, int64, float32 or float64");
  StoredVolume stored;
  stored.type = *type;
  stored.size = *size;
  DataBlock block;
  block.path = path;
  block.encoding = gzip ? DataBlock::Encoding::Deflated : DataBlock::Encoding::Raw;
  stored.bytes = readBlock(block, checkedBytes(path, stored.size, stored.type));
  return stored;
}

}  // namespace cdsm::io
