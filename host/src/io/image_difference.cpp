// SPDX-License-Identifier: Apache-2.0
#include "io/image_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include <jxl/butteraugli.h>

#include <cdsm/error.hpp>

#include "io/color_space.hpp"
#include "io/image_file.hpp"
#include "io/srgb.hpp"

namespace cdsm::io {
namespace {

void requireSameSize(const Image& image, const Image& reference) {
  const auto text = [](const Image& of) { return std::to_string(of.width) + " x " + std::to_string(of.height); };
  if (image.width != reference.width || image.height != reference.height || image.pixels.empty())
    throw Error("an image of " + text(image) + " and one of " + text(reference) +
                " cannot be compared; they must have the same size");
}

/// Of linear RGB with the primaries of sRGB [ITU-R BT.709].
double luminance(const glm::vec4& pixel) { return glm::dot(glm::dvec3(pixel), glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// The image as PNG, its border repeated where it is smaller than Butteraugli can judge.
struct ShownImage {
  explicit ShownImage(const Image& image)
      : width(std::max(image.width, kLeastSide)), height(std::max(image.height, kLeastSide)) {
    const std::vector<std::uint8_t> pixels = srgbPixels(image);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t from = std::size_t(std::min(y, image.height - 1)) * std::size_t(image.width) +
                                 std::size_t(std::min(x, image.width - 1));
        bytes.insert(bytes.end(), &pixels[3 * from], &pixels[3 * from] + 3);
      }
    }
  }

  static constexpr int kLeastSide = 8;
  int width, height;
  std::vector<std::uint8_t> bytes;
};

double perceivedDifference(const Image& image, const Image& reference) {
  constexpr float kCandelas = 100.0f;  // per square metre
  constexpr JxlPixelFormat kFormat{3, JXL_TYPE_UINT8, JXL_NATIVE_ENDIAN, 0};
  const std::unique_ptr<JxlButteraugliApi, decltype(&JxlButteraugliApiDestroy)> api(JxlButteraugliApiCreate(nullptr),
                                                                                    JxlButteraugliApiDestroy);
  if (!api) throw std::bad_alloc();
  JxlButteraugliApiSetIntensityTarget(api.get(), kCandelas);
  const ShownImage right(reference), shown(image);
  const std::unique_ptr<JxlButteraugliResult, decltype(&JxlButteraugliResultDestroy)> distances(
      JxlButteraugliCompute(api.get(), std::uint32_t(right.width), std::uint32_t(right.height), &kFormat,
                            right.bytes.data(), right.bytes.size(), &kFormat, shown.bytes.data(), shown.bytes.size()),
      JxlButteraugliResultDestroy);
  if (!distances) throw Error("libjxl cannot compare the images; they must be smaller");
  const float* map = nullptr;
  std::uint32_t stride = 0;
  JxlButteraugliResultGetDistmap(distances.get(), &map, &stride);
  double cubes = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double distance = map[std::size_t(y) * stride + std::size_t(x)];
      cubes += distance * distance * distance;
    }
  }
  return std::cbrt(cubes / double(image.pixels.size()));
}

}  // namespace

ImageDifference differenceOf(const Image& image, const Image& reference) {
  ImageDifference result;
  result.rms = rmsDifference(image, reference);
  result.perceived = perceivedDifference(image, reference);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    result.mean += (luminance(image.pixels[i]) - luminance(reference.pixels[i])) / double(image.pixels.size());
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = double(image.pixels[i][channel]) - double(reference.pixels[i][channel]);
      result.largest = std::max(result.largest, std::abs(difference));
    }
  }
  return result;
}

double rmsDifference(const Image& image, const Image& reference) {
  requireSameSize(image, reference);
  double squares = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const glm::dvec3 difference = glm::dvec3(image.pixels[i]) - glm::dvec3(reference.pixels[i]);
    squares += glm::dot(difference, difference);
  }
  return std::sqrt(squares / (3.0 * double(image.pixels.size())));
}

glm::vec3 differenceColor(double part) {
  const glm::dvec3 cool(0.230, 0.299, 0.754), warm(0.706, 0.016, 0.150);  // sRGB [Moreland 2009, Table 1]
  static const ColorBlend blend = *colorBlendOf("Diverging");
  const glm::dvec3 shown = blend(cool, warm, 0.5 + 0.5 * std::clamp(part, -1.0, 1.0));
  return {linearOfSrgb(shown.r), linearOfSrgb(shown.g), linearOfSrgb(shown.b)};
}

Image differencePicture(const Image& image, const Image& reference, double factor) {
  requireSameSize(image, reference);
  Image picture{image.width, image.height, {}};
  picture.pixels.reserve(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double difference = luminance(image.pixels[i]) - luminance(reference.pixels[i]);
    picture.pixels.emplace_back(differenceColor(factor * difference), 1.0f);
  }
  return picture;
}

}  // namespace cdsm::io
