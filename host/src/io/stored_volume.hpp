// SPDX-License-Identifier: Apache-2.0
// In: a grid as a file stores it (any number type, either byte order). Out: VolumeData, or an Error when a value cannot
// be kept exactly, is not finite, or the grid has no place in space. What all volume readers share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <cdsm/scene.hpp>

namespace cdsm::io {

enum class StoredType { UInt8, Int8, UInt16, Int16, UInt32, Int32, UInt64, Int64, Float32, Float64 };

/// Bytes of one stored value.
std::size_t storedBytes(StoredType type);

/// Of "uint8", "Float32" and the like, in either case; nothing for other words.
std::optional<StoredType> storedTypeOf(std::string_view name);

/// The byte order of values that another library has already read.
bool hostIsBigEndian();

struct StoredVolume {
  StoredType type = StoredType::UInt8;
  bool bigEndian = false;
  std::array<std::uint64_t, 3> size{};  ///< x fastest
  glm::dmat4 objectFromIndex{1.0};      ///< of voxel centres
  std::vector<std::byte> bytes;
};

/// Bytes that the grid needs. Throws Error for a size of zero and for grids that no file can mean.
std::uint64_t checkedBytes(const std::string& path, const std::array<std::uint64_t, 3>& size, StoredType type);

/// 8 and 16 bit integers and float32 stay what they are, all else becomes float32 if no integer loses a digit and no
/// double its range. `path` is for messages.
std::shared_ptr<const VolumeData> makeVolume(const std::string& path, StoredVolume stored);

}  // namespace cdsm::io
