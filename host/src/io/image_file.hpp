// SPDX-License-Identifier: Apache-2.0
// Images of linear colours and .png (sRGB, 8 bit, RGB) or .exr (linear float, R G B A) files. They are written by
// cdsm::writeImage().
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::io {

/// What a .png of the image holds: 3 bytes per pixel.
std::vector<std::uint8_t> srgbPixels(const Image& image);

/// Throws what writeImage() would throw for this path, before there is an image.
void checkImagePath(const std::string& path);

/// Reads a .png or .exr as linear colours; alpha is 1 where the file has none. Throws Error.
Image readImage(const std::string& path);

}  // namespace cdsm::io
