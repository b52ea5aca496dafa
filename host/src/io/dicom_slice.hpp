// SPDX-License-Identifier: Apache-2.0
// One DICOM file through GDCM: where its slice lies, and its values after rescale slope and intercept.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace cdsm::io {

/// Millimetres in the patient's coordinates (x to the left, y to the back, z to the head).
struct DicomSlice {
  std::string path;
  std::string series;  ///< SeriesInstanceUID
  std::uint32_t width = 0, height = 0;
  glm::dvec3 position{0.0};     ///< of the centre of the first pixel
  glm::dvec3 alongRow{0.0};     ///< unit vector, the way x grows
  glm::dvec3 alongColumn{0.0};  ///< unit vector, the way y grows
  glm::dvec2 spacing{0.0};      ///< of pixel centres along x and y
  double slope = 1.0, intercept = 0.0;
};

/// All but the pixels. Throws Error when the file is none, or lacks what a slice in space must say.
DicomSlice readDicomHeader(const std::string& path);

/// The slice's width x height values, row by row.
std::vector<float> readDicomValues(const DicomSlice& slice);

}  // namespace cdsm::io
