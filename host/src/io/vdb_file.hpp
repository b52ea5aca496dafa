// SPDX-License-Identifier: Apache-2.0
// OpenVDB. In: a sparse grid. Out: a dense one over the box of its active voxels, the background where none are.
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// `grid` names a grid of float, double, int32 or int64; "": the first one of float. Index coordinates and the file's
/// own transform say where voxels lie: a voxel's centre is at its index. Its file shows all else that it defines.
__attribute__((visibility("hidden"))) StoredVolume readVdb(const std::string& path, const std::string& grid);

}  // namespace cdsm::io
