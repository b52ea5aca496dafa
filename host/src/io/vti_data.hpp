// SPDX-License-Identifier: Apache-2.0
// In: the binary data of an array in a VTK XML file, raw or base64, plain or in blocks of zlib. Out: its bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cdsm::io {

struct VtiData {
  std::string_view text;  ///< from where the array's data begin; may go on behind them
  bool base64 = false;    ///< text is base64, not the bytes themselves
  bool compressed = false;
  std::size_t countBytes = 4;  ///< of each integer of the data's own header: 4 or 8
  bool bigEndian = false;      ///< of these integers
};

/// Exactly `bytes` bytes, as extent and type ask for. Throws Error, with `path` as its place, for fewer or more, or for
/// damaged data.
std::vector<std::byte> readVtiData(const std::string& path, const VtiData& data, std::uint64_t bytes);

}  // namespace cdsm::io
