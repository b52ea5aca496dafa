// SPDX-License-Identifier: Apache-2.0
// In: an image of linear colours. Out: a .png (sRGB, 8 bit, RGB) or .exr (linear float, R G B A), whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::io {

/// Writes the image in the format that the path's ending names; an earlier file stays if that fails. PNG: clamped to
/// [0, 1], rounded to 8 bits, without alpha. Throws Error.
void writeImage(const std::string& path, const Image& image);

/// What a .png of the image holds: 3 bytes per pixel.
std::vector<std::uint8_t> srgbPixels(const Image& image);

/// Throws what writeImage() would throw for this path, before there is an image.
void checkImagePath(const std::string& path);

/// Reads a .png or .exr as linear colours; alpha is 1 where the file has none. Throws Error.
Image readImage(const std::string& path);

}  // namespace cdsm::io
