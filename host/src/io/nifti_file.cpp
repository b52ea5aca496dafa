// SPDX-License-Identifier: Apache-2.0
// NIfTI-1 through niftiio's header parser; see nifti_file.hpp.
#include "io/nifti_file.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>

#include <nifti1_io.h>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"

namespace cdsm::io {

namespace {

/// MSB_FIRST, which niftiio keeps to itself.
constexpr int kMsbFirst = 2;

constexpr std::size_t kHeaderBytes = sizeof(nifti_1_header);
static_assert(kHeaderBytes == 348, "the header as it stands in the file");

struct HeaderDelete {
  void operator()(nifti_image* header) const { nifti_image_free(header); }
};
using Header = std::unique_ptr<nifti_image, HeaderDelete>;

/// The files of a volume: one, or a header and its voxels.
struct Files {
  DataBlock header, voxels;
  const char* magic = "n+1";
};

Files filesOf(const std::string& path) {
  const auto block = [](const std::string& file) {
    const bool gz = hasEnding(file, ".gz");
    return DataBlock{file, gz ? DataBlock::Encoding::Deflated : DataBlock::Encoding::Raw, 0, 0};
  };
  if (!hasEnding(path, ".hdr") && !hasEnding(path, ".img")) return {block(path), block(path), "n+1"};
  const std::string stem = path.substr(0, path.size() - 4);
  if (hasEnding(path, ".hdr")) return {block(path), block(stem + ".img"), "ni1"};
  return {block(stem + ".hdr"), block(path), "ni1"};
}

template <typename T>
T swapped(T value, bool swap) {
  auto* bytes = reinterpret_cast<unsigned char*>(&value);
  if (swap) std::reverse(bytes, bytes + sizeof(T));
  return value;
}

/// niftiio prints when it refuses a header, and takes sizes below 1 for 1; so what it refuses is found here.
void checkHeader(const std::string& path, const nifti_1_header& header, const char* magic) {
  const bool swap = header.sizeof_hdr != static_cast<int>(kHeaderBytes);
  if (swapped(header.sizeof_hdr, swap) != static_cast<int>(kHeaderBytes) || std::string(header.magic, 3) != magic)
    throw Error(Location{path}, "is not a NIfTI-1 file of this ending (its header says so neither by size nor by \"" +
                                    std::string(magic) + "\"); ANALYZE and NIfTI-2 are not read");
  const int dimensions = swapped(header.dim[0], swap);
  if (dimensions < 3 || dimensions > 7)
    throw Error(Location{path}, "has " + std::to_string(dimensions) + " dimensions; a volume has three");
  for (int i = 1; i <= dimensions; ++i) {
    const int size = swapped(header.dim[i], swap);
    if (size < 1)
      throw Error(Location{path}, "its dimension " + std::to_string(i) + " has the size " + std::to_string(size) +
                                      "; every side must be at least 1");
    if (i > 3 && size > 1)
      throw Error(Location{path}, "has " + std::to_string(size) + (i == 4 ? " time steps" : " components") +
                                      "; a volume is one scalar grid of three dimensions");
  }
  const float offset = swapped(header.vox_offset, swap);
  if (!(offset >= 0.0f && offset < 1e9f))
    throw Error(Location{path}, "its vox_offset makes no sense; it must name the byte of the first voxel");
}

/// niftiio puts the header into this machine's order and works out where the voxels lie.
Header loadHeader(const Files& files) {
  const std::string& path = files.header.path;
  const std::vector<std::byte> bytes = readStart(files.header, kHeaderBytes);
  if (bytes.size() < kHeaderBytes)
    throw Error(Location{path}, "is shorter than a NIfTI-1 header; is the file cut short?");
  nifti_1_header raw;
  std::memcpy(&raw, bytes.data(), kHeaderBytes);
  checkHeader(path, raw, files.magic);
  static std::mutex niftiHasGlobals;
  const std::lock_guard<std::mutex> lock(niftiHasGlobals);
  nifti_set_debug_level(0);  // it prints otherwise
  const bool known = nifti_is_valid_datatype(swapped(raw.datatype, raw.sizeof_hdr != static_cast<int>(kHeaderBytes)));
  Header header(known ? nifti_convert_nhdr2nim(raw, nullptr) : nullptr);
  if (!header)
    throw Error(Location{path}, "its header cannot be used; the datatype is unknown or a size makes no sense");
  return header;
}

StoredType storedType(const std::string& path, const nifti_image& header) {
  switch (header.datatype) {
    case DT_UINT8:
      return StoredType::UInt8;
    case DT_INT8:
      return StoredType::Int8;
    case DT_UINT16:
      return StoredType::UInt16;
    case DT_INT16:
      return StoredType::Int16;
    case DT_UINT32:
      return StoredType::UInt32;
    case DT_INT32:
      return StoredType::Int32;
    case DT_UINT64:
      return StoredType::UInt64;
    case DT_INT64:
      return StoredType::Int64;
    case DT_FLOAT32:
      return StoredType::Float32;
    case DT_FLOAT64:
      return StoredType::Float64;
    default:
      throw Error(Location{path}, "has voxels of type " + std::string(nifti_datatype_string(header.datatype)) +
                                      "; one real number per voxel is needed (no colours, no complex numbers)");
  }
}

glm::dmat4 objectFromIndex(const nifti_image& header) {
  const mat44& rows =
      header.sform_code > 0 ? header.sto_xyz : header.qto_xyz;  // qto_xyz: pixdim when there is no qform
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) matrix[column][row] = rows.m[row][column];
  return matrix;
}

}  // namespace

StoredVolume readNifti(const std::string& path) {
  Files files = filesOf(path);
  const Header header = loadHeader(files);
  StoredVolume stored;
  stored.type = storedType(path, *header);
  for (int i = 0; i < 3; ++i) stored.size[i] = static_cast<std::uint64_t>(header->dim[i + 1]);
  stored.objectFromIndex = objectFromIndex(*header);
  stored.bigEndian = header->byteorder == kMsbFirst;
  files.voxels.skip = static_cast<std::uint64_t>(header->iname_offset);
  stored.bytes = readBlock(files.voxels, checkedBytes(path, stored.size, stored.type));
  return stored;
}

}  // namespace cdsm::io
