// SPDX-License-Identifier: Apache-2.0
// Voxels without a header, whose size and type stand in the file's name as in the Open SciVis datasets:
// NAME_256x256x128_uint8.raw, or .raw.gz. Little endian, x fastest, voxel (0, 0, 0) at the origin, edges of length 1.
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// Types are uint8 to uint64, int8 to int64, float32, float64.
StoredVolume readRaw(const std::string& path);

}  // namespace cdsm::io
