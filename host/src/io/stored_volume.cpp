// SPDX-License-Identifier: Apache-2.0
// From stored numbers to VolumeData; see stored_volume.hpp.
#include "io/stored_volume.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <type_traits>

#include <cdsm/error.hpp>

#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

/// More voxels than this are taken for a damaged header.
constexpr std::uint64_t kMaxVoxels = std::uint64_t{1} << 34;
constexpr std::uint64_t kMaxSide = 0x7fffffff;

std::string voxelName(const StoredVolume& stored, std::uint64_t index) {
  const std::uint64_t x = index % stored.size[0];
  const std::uint64_t y = index / stored.size[0] % stored.size[1];
  const std::uint64_t z = index / stored.size[0] / stored.size[1];
  return "voxel (" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + ")";
}

[[noreturn]] void throwNotFinite(const std::string& path, const StoredVolume& stored, std::uint64_t index) {
  throw Error(Location{path},
              voxelName(stored, index) + " is not a finite number; replace NaN and infinity in the file");
}

template <typename T>
T load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

void swapBytes(std::vector<std::byte>& bytes, std::size_t each) {
  for (std::size_t at = 0; at + each <= bytes.size(); at += each)
    std::reverse(bytes.data() + at, bytes.data() + at + each);
}

/// A float has 24 binary digits: trailing zeros cost none of them.
template <typename T>
bool fitsFloat(T value) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::abs(value) <= static_cast<T>(std::numeric_limits<float>::max());
  } else {
    std::uint64_t digits = static_cast<std::uint64_t>(value);
    if (value < T{0}) digits = ~digits + 1;
    while (digits != 0 && (digits & 1) == 0) digits >>= 1;
    return digits < (std::uint64_t{1} << 24);
  }
}

template <typename T>
std::vector<std::byte> convertToFloat(const std::string& path, const StoredVolume& stored) {
  std::vector<std::byte> floats(stored.bytes.size() / sizeof(T) * sizeof(float));
  for (std::uint64_t i = 0; i < stored.bytes.size() / sizeof(T); ++i) {
    const T value = load<T>(stored.bytes.data() + i * sizeof(T));
    if (!std::isfinite(static_cast<double>(value))) throwNotFinite(path, stored, i);
    if (!fitsFloat(value))
      throw Error(Location{path}, voxelName(stored, i) + " holds " + std::to_string(value) +
                                      ", which a 32 bit float cannot hold; write the file as 16 bit integers or float");
    const float converted = static_cast<float>(value);
    std::memcpy(floats.data() + i * sizeof(float), &converted, sizeof(float));
  }
  return floats;
}

void checkFinite(const std::string& path, const StoredVolume& stored) {
  for (std::uint64_t i = 0; i < stored.bytes.size() / sizeof(float); ++i)
    if (!std::isfinite(load<float>(stored.bytes.data() + i * sizeof(float)))) throwNotFinite(path, stored, i);
}

VoxelType voxelType(StoredType type) {
  switch (type) {
    case StoredType::UInt8:
      return VoxelType::UInt8;
    case StoredType::Int8:
      return VoxelType::Int8;
    case StoredType::UInt16:
      return VoxelType::UInt16;
    case StoredType::Int16:
      return VoxelType::Int16;
    default:
      return VoxelType::Float32;
  }
}

std::vector<std::byte> keptVoxels(const std::string& path, StoredVolume& stored) {
  if (stored.bigEndian != hostIsBigEndian()) swapBytes(stored.bytes, storedBytes(stored.type));
  switch (stored.type) {
    case StoredType::UInt32:
      return convertToFloat<std::uint32_t>(path, stored);
    case StoredType::Int32:
      return convertToFloat<std::int32_t>(path, stored);
    case StoredType::UInt64:
      return convertToFloat<std::uint64_t>(path, stored);
    case StoredType::Int64:
      return convertToFloat<std::int64_t>(path, stored);
    case StoredType::Float64:
      return convertToFloat<double>(path, stored);
    case StoredType::Float32:
      checkFinite(path, stored);
      break;
    default:
      break;
  }
  return std::move(stored.bytes);
}

/// Invertible in single precision too, and with axes at least a hair (1e-6 of a right angle) apart.
glm::mat4 checkedMatrix(const std::string& path, const glm::dmat4& matrix) {
  const glm::mat4 kept(matrix);
  bool finite = true;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) finite = finite && std::isfinite(kept[column][row]);
  const glm::dmat3 axes(matrix);
  const double box = glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
  const double volume = std::abs(glm::determinant(axes));
  if (!finite || !(volume > 1e-6 * box) || !std::isnormal(static_cast<float>(volume)))
    throw Error(Location{path},
                "its axes span no space (spacing, directions or orientation in the header are zero, "
                "parallel or not finite); three independent axes are needed");
  return kept;
}

}  // namespace

std::size_t storedBytes(StoredType type) {
  switch (type) {
    case StoredType::UInt8:
    case StoredType::Int8:
      return 1;
    case StoredType::UInt16:
    case StoredType::Int16:
      return 2;
    case StoredType::UInt32:
    case StoredType::Int32:
    case StoredType::Float32:
      return 4;
    default:
      return 8;
  }
}

std::optional<StoredType> storedTypeOf(std::string_view name) {
  static const std::map<std::string, StoredType> types = {
      {"uint8", StoredType::UInt8},    {"int8", StoredType::Int8},     {"uint16", StoredType::UInt16},
      {"int16", StoredType::Int16},    {"uint32", StoredType::UInt32}, {"int32", StoredType::Int32},
      {"uint64", StoredType::UInt64},  {"int64", StoredType::Int64},   {"float32", StoredType::Float32},
      {"float64", StoredType::Float64}};
  const auto at = types.find(lowerCase(name));
  return at == types.end() ? std::nullopt : std::optional(at->second);
}

bool hostIsBigEndian() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

std::uint64_t checkedBytes(const std::string& path, const std::array<std::uint64_t, 3>& size, StoredType type) {
  std::uint64_t voxels = 1;
  const std::string name =
      std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) + " voxels";
  for (const std::uint64_t side : size) {
    if (side == 0) throw Error(Location{path}, "has a grid of " + name + "; every side must be at least 1");
    if (side > kMaxVoxels / voxels || side > kMaxSide)
      throw Error(Location{path}, "claims a grid of " + name + "; at most 2^34 voxels are read, 2^31 - 1 per side");
    voxels *= side;
  }
  return voxels * storedBytes(type);
}

std::shared_ptr<const VolumeData> makeVolume(const std::string& path, StoredVolume stored) {
  if (stored.bytes.size() != checkedBytes(path, stored.size, stored.type))
    throw Error(Location{path}, "the number of voxels does not match the size in the header");
  auto volume = std::make_shared<VolumeData>();
  volume->type = voxelType(stored.type);
  volume->size = glm::uvec3(stored.size[0], stored.size[1], stored.size[2]);
  volume->objectFromIndex = checkedMatrix(path, stored.objectFromIndex);
  try {
    volume->voxels = keptVoxels(path, stored);
  } catch (const std::bad_alloc&) {
    throw Error(Location{path}, "there is no memory for its voxels as 32 bit floats");
  }
  return volume;
}

}  // namespace cdsm::io
