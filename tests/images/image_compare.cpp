// SPDX-License-Identifier: Apache-2.0
// Pixel differences, and the pictures a failed comparison leaves behind.
#include "image_compare.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <iostream>

namespace cdsm::images {
namespace {

glm::vec4 shown(const glm::vec4& color) { return glm::clamp(color, 0.0f, 1.0f); }

void write(const std::string& file, const Image& image, int channels) {
  const auto output = OIIO::ImageOutput::create(file);
  const OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::FLOAT);
  if (!output || !output->open(file, spec)) {
    std::cerr << file << " cannot be written\n";
    return;
  }
  output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data(), sizeof(glm::vec4));
  output->close();
  std::cerr << "wrote " << file << "\n";
}

}  // namespace

double partWithin(const Image& a, const Image& b, float limit) {
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) return 0.0;
  std::size_t within = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::vec4 difference = glm::abs(shown(a.pixels[i]) - shown(b.pixels[i]));
    // Written so that a NaN counts as a difference.
    if (difference.x <= limit && difference.y <= limit && difference.z <= limit && difference.w <= limit) ++within;
  }
  return static_cast<double>(within) / static_cast<double>(std::max<std::size_t>(1, a.pixels.size()));
}

void writeFailure(const std::string& name, const Image& render, const Image& reference) {
  Image difference = reference;
  for (std::size_t i = 0; i < std::min(render.pixels.size(), reference.pixels.size()); ++i) {
    difference.pixels[i] = shown(10.0f * glm::abs(shown(render.pixels[i]) - shown(reference.pixels[i])));
  }
  write(name + "_render.exr", render, 4);
  write(name + "_reference.exr", reference, 4);
  write(name + "_difference.png", difference, 3);
}

}  // namespace cdsm::images
