// SPDX-License-Identifier: Apache-2.0
// The slices of a DICOM series in one folder, put together to a volume in the patient's coordinates (millimetres).
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// All DICOM files of the folder, sorted by position. Values are those after rescale slope and intercept (Hounsfield
/// units of a CT), kept as 8 or 16 bit integers when all are such, else float32. Throws Error for more than one series,
/// slices that are missing or twice there, that differ in size or direction, or that are shifted (gantry tilt).
StoredVolume readDicomSeries(const std::string& folder);

}  // namespace cdsm::io
