// SPDX-License-Identifier: Apache-2.0
// VTK's XML format for image data (.vti): numbers as text, base64 or raw, zlib blocks, either byte order.
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// `array` names a scalar array of the points; "": the one that the file calls Scalars, else the only one. One piece
/// that is the whole extent.
StoredVolume readVti(const std::string& path, const std::string& array);

}  // namespace cdsm::io
