// SPDX-License-Identifier: Apache-2.0
// PNG and EXR through OpenImageIO; see image_file.hpp.
#include "io/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include <OpenImageIO/imageio.h>

#include <cdsm/error.hpp>

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/srgb.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

enum class Format { Png, Exr };

Format formatOf(const std::string& path) {
  if (hasEnding(path, ".png")) return Format::Png;
  if (hasEnding(path, ".exr")) return Format::Exr;
  throw Error(Location{path}, "is not known as an image by its ending; images are .png or .exr");
}

/// NaN becomes 0.
std::uint8_t srgbByte(float linear) {
  const double x = linear > 0.0f ? std::min(static_cast<double>(linear), 1.0) : 0.0;
  return static_cast<std::uint8_t>(std::lround(255.0 * srgbOfLinear(x)));
}

void checkImage(const std::string& path, const Image& image) {
  if (image.width < 1 || image.height < 1 ||
      image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
    throw Error(Location{path}, "an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                    " with " + std::to_string(image.pixels.size()) + " pixels cannot be written");
}

void writeTo(const std::string& file, const std::string& path, const Image& image, Format format) {
  const bool png = format == Format::Png;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(png ? "png" : "openexr");
  if (!output) throw Error(Location{path}, "cannot be written: " + printable(OIIO::geterror()));
  OIIO::ImageSpec spec(image.width, image.height, png ? 3 : 4, png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  spec.attribute("oiio:ColorSpace", png ? "sRGB" : "Linear");
  // same input, same bytes: OpenImageIO would write the time of day into an EXR file
  if (!png) spec.attribute("DateTime", "1970:01:01 00:00:00");
  const std::vector<std::uint8_t> bytes = png ? srgbPixels(image) : std::vector<std::uint8_t>();
  const bool written =
      output->open(file, spec) && (png ? output->write_image(OIIO::TypeDesc::UINT8, bytes.data())
                                       : output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data()));
  if (!written || !output->close()) throw Error(Location{path}, "cannot be written: " + printable(output->geterror()));
}

Image toImage(const OIIO::ImageSpec& spec, const std::vector<float>& values, Format format) {
  Image image{spec.width, spec.height, {}};
  const int channels = spec.nchannels;
  for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(channels)) {
    glm::vec4 pixel(0.0f, 0.0f, 0.0f, 1.0f);
    for (int c = 0; c < 3; ++c) {
      const float value = values[i + static_cast<std::size_t>(channels < 3 ? 0 : c)];
      pixel[c] = format == Format::Png ? static_cast<float>(linearOfSrgb(value)) : value;
    }
    if (channels == 2 || channels > 3) pixel.a = values[i + static_cast<std::size_t>(channels == 2 ? 1 : 3)];
    image.pixels.push_back(pixel);
  }
  return image;
}

}  // namespace

std::vector<std::uint8_t> srgbPixels(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const glm::vec4& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) bytes.push_back(srgbByte(pixel[channel]));
  return bytes;
}

void checkImagePath(const std::string& path) {
  formatOf(path);
  checkOutputPath(path);
}

Image readImage(const std::string& path) {
  const Format format = formatOf(path);
  inputFileSize(path);
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // colours as the file has them
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &config);
  if (!input) throw Error(Location{path}, "cannot be read as an image: " + printable(OIIO::geterror()));
  const OIIO::ImageSpec spec = input->spec();
  std::vector<float> values(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                            static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
    throw Error(Location{path}, "cannot be read as an image: " + printable(input->geterror()));
  return toImage(spec, values, format);
}

}  // namespace cdsm::io

void cdsm::writeImage(const std::string& path, const Image& image) {
  const io::Format format = io::formatOf(path);
  io::checkImage(path, image);
  io::AtomicFile file(path);
  io::writeTo(file.temporaryPath(), path, image, format);
  file.commit();
}
