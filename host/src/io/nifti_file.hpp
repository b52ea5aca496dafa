// SPDX-License-Identifier: Apache-2.0
// In: a NIfTI-1 file (.nii, .nii.gz) or pair (.hdr with .img). Out: the grid as stored. The header is niftiio's affair;
// the voxels are read here, because niftiio turns NaN into 0.
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// The grid lies where sform says, else qform, else pixdim with the origin at 0. Throws Error for all that is not one
/// scalar, three-dimensional grid.
StoredVolume readNifti(const std::string& path);

}  // namespace cdsm::io
