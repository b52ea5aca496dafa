// SPDX-License-Identifier: Apache-2.0
// In: a file with a scalar grid, or the folder of a DICOM series. Out: its voxels in the file's own values and where
// they lie. The file's origin is the centre of voxel (0, 0, 0). Rescaling that a header proposes (NIfTI scl_slope, NRRD
// old min/max) is not applied, but for DICOM, whose values are those after its rescale slope and intercept.
#pragma once

#include <memory>
#include <string>

#include <cdsm/scene.hpp>

namespace cdsm::io {

/// Which of several volumes in one file; "": the only or usual one.
struct VolumePart {
  std::string grid;   ///< of an OpenVDB file
  std::string array;  ///< of a VTI file
};

/// Reads NRRD (.nrrd, .nhdr), MetaImage (.mhd, .mha), NIfTI-1 (.nii, .nii.gz, .hdr with .img), OpenVDB (.vdb), VTK
/// image data (.vti) or raw voxels (.raw, .raw.gz), chosen by the ending, or the DICOM series of a folder. 8 and 16 bit
/// integers and float32 keep their type, other numbers become float32 where that is exact (doubles: rounded). Throws
/// Error for anything but a complete, finite, scalar, three-dimensional grid, and, without a place, for a part that the
/// format does not have. Safe from many threads.
std::shared_ptr<const VolumeData> readVolume(const std::string& path, const VolumePart& part = {});

}  // namespace cdsm::io
