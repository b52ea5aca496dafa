// SPDX-License-Identifier: Apache-2.0
// Between linear light and the numbers of an sRGB display, both 0 .. 1 (IEC 61966-2-1).
#pragma once

#include <cmath>

namespace cdsm::io {

inline double srgbOfLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

inline double linearOfSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace cdsm::io
