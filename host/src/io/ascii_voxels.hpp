// SPDX-License-Identifier: Apache-2.0
// In: numbers as text. Out: the same numbers as bytes of the given type, in the byte order of this machine.
#pragma once

#include "io/input_file.hpp"
#include "io/stored_volume.hpp"

namespace cdsm::io {

/// Exactly `count` numbers, parted by white space or commas. Throws Error, with `path` as its place, for fewer, more,
/// or one that the type cannot hold.
std::vector<std::byte> parseAsciiVoxels(const std::string& path, std::string text, std::uint64_t count,
                                        StoredType type);

/// The same of the text from the block's offset on.
std::vector<std::byte> readAsciiVoxels(const DataBlock& block, std::uint64_t count, StoredType type);

}  // namespace cdsm::io
