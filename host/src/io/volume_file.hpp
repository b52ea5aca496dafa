// SPDX-License-Identifier: Apache-2.0
// In: a file with a scalar grid. Out: its voxels in the file's own values and where they lie. The file's origin is the
// centre of voxel (0, 0, 0). Rescaling that a header proposes (NIfTI scl_slope, NRRD old min/max) is not applied.
#pragma once

#include <memory>
#include <string>

#include <cdsm/scene.hpp>

namespace cdsm::io {

/// Reads NRRD (.nrrd, .nhdr), MetaImage (.mhd, .mha) or NIfTI-1 (.nii, .nii.gz, .hdr with .img), chosen by the ending.
/// 8 and 16 bit integers and float32 keep their type, other numbers become float32 where that is exact (doubles:
/// rounded). Throws Error for anything but a complete, finite, scalar, three-dimensional grid. Safe from many threads.
std::shared_ptr<const VolumeData> readVolume(const std::string& path);

}  // namespace cdsm::io
