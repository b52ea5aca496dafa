// SPDX-License-Identifier: Apache-2.0
// In: paths of files that somebody else wrote, and what their headers claim. Out: their bytes, or an Error that names
// the file. Nothing is allocated on the word of a header alone: the file's own size bounds it first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cdsm::io {

/// Deflate never packs better than this (zlib's technical notes).
inline constexpr std::uint64_t kMaxDeflateRatio = 1032;

/// Whether the path ends so; `ending` in lower case with its dot, the path in either case.
bool hasEnding(const std::string& path, const std::string& ending);

/// The file's size in bytes, > 0. Throws Error for a missing, empty, unreadable or not regular file.
std::uint64_t inputFileSize(const std::string& path);

/// The first `most` bytes of the file, or all of them if there are fewer.
std::string readText(const std::string& path, std::uint64_t most = UINT64_MAX);

/// The whole file, unpacked if its name ends in .gz. Throws Error where compressed data are damaged or cut short.
std::string readUnpackedText(const std::string& path);

/// `name` as it stands in the header file `header`: relative to the header's folder unless absolute.
std::string besideHeader(const std::string& header, const std::string& name);

/// Where voxels lie in a file.
struct DataBlock {
  enum class Encoding { Raw, Deflated };  ///< Deflated: gzip or zlib, told apart by their first bytes
  std::string path;
  Encoding encoding = Encoding::Raw;
  std::uint64_t offset = 0;  ///< bytes of the file before the (compressed) data
  std::uint64_t skip = 0;    ///< bytes before the voxels, counted after unpacking
};

/// The first `most` bytes of the block, or all of them if there are fewer.
std::vector<std::byte> readStart(const DataBlock& block, std::size_t most);

/// Exactly `bytes` bytes. Throws Error when the block holds less or more than that.
std::vector<std::byte> readBlock(const DataBlock& block, std::uint64_t bytes);

}  // namespace cdsm::io
