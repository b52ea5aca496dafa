// SPDX-License-Identifier: Apache-2.0
#include "deep_map_file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>

namespace cdsm::property {
namespace {

/// Imath's rows, which multiply points from the left, are GLM's columns.
glm::dmat4 matrixOf(const OIIO::ImageSpec& spec, const char* name) {
  float values[16] = {};
  if (!spec.getattribute(name, OIIO::TypeMatrix, values)) throw std::runtime_error(std::string("no ") + name);
  glm::dmat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = double(values[i]);
  return matrix;
}

DeepPart readPart(OIIO::ImageInput& input, int number) {
  const OIIO::ImageSpec spec = input.spec(number);
  if (!spec.deep || spec.channelnames != std::vector<std::string>{"A", "Z", "ZBack"})
    throw std::runtime_error("not deep, or other channels");
  DeepPart part;
  part.name = spec.get_string_attribute("oiio:subimagename");
  part.side = spec.get_string_attribute("cdsm:side");
  part.width = spec.width;
  part.height = spec.height;
  part.tileWidth = spec.tile_width;
  part.ndcFromWorld = matrixOf(spec, "worldToNDC");
  part.cameraFromWorld = matrixOf(spec, "worldToCamera");
  OIIO::DeepData deep;
  if (!input.read_native_deep_image(number, 0, deep)) throw std::runtime_error(input.geterror());
  part.texels.resize(std::size_t(deep.pixels()));
  for (std::int64_t texel = 0; texel < deep.pixels(); ++texel)
    for (int i = 0; i < deep.samples(texel); ++i)
      part.texels[std::size_t(texel)].push_back(
          {deep.deep_value(texel, 1, i), deep.deep_value(texel, 2, i), deep.deep_value(texel, 0, i)});
  return part;
}

int partsOf(OIIO::ImageInput& input) {
  int count = 0;
  while (input.seek_subimage(count, 0)) ++count;
  return count;
}

}  // namespace

glm::dvec3 DeepPart::worldPoint(int x, int y, double depth) const {
  const glm::dmat4 back = glm::inverse(ndcFromWorld);
  glm::dvec3 ends[2];
  for (int end = 0; end < 2; ++end) {
    const glm::dvec4 world = back * glm::dvec4((x + 0.5) / width, (y + 0.5) / height, double(end), 1.0);
    ends[end] = glm::dvec3(world) / world.w;
  }
  const double first = depthOf(ends[0]), last = depthOf(ends[1]);
  return glm::mix(ends[0], ends[1], (depth - first) / (last - first));
}

double DeepPart::depthOf(const glm::dvec3& point) const { return (cameraFromWorld * glm::dvec4(point, 1.0)).z; }

int DeepPart::texelOf(const glm::dvec3& point, double& offCentre) const {
  const glm::dvec4 ndc = ndcFromWorld * glm::dvec4(point, 1.0);
  const double u = ndc.x / ndc.w * width, v = ndc.y / ndc.w * height;
  offCentre = std::max(std::abs(u - std::floor(u) - 0.5), std::abs(v - std::floor(v) - 0.5));
  if (ndc.w <= 0.0 || u < 0.0 || v < 0.0 || u >= width || v >= height) return -1;
  return int(v) * width + int(u);
}

double DeepPart::transmittance(int texel, double depth) const {
  double t = 1.0;
  for (const DeepSample& sample : texels[std::size_t(texel)]) {
    if (depth <= double(sample.z)) break;
    const double length = double(sample.zBack) - double(sample.z);
    const double part = length > 0.0 ? std::min(1.0, (depth - double(sample.z)) / length) : 1.0;
    t *= 1.0 - part * double(sample.alpha);
  }
  return t;
}

std::vector<DeepPart> readDeepParts(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) throw std::runtime_error(OIIO::geterror());
  std::vector<DeepPart> parts;
  for (int number = 0, count = partsOf(*input); number < count; ++number) parts.push_back(readPart(*input, number));
  return parts;
}

std::vector<std::vector<float>> readFlatAlphas(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) throw std::runtime_error(OIIO::geterror());
  std::vector<std::vector<float>> alphas;
  for (int number = 0, count = partsOf(*input); number < count; ++number) {
    const OIIO::ImageSpec spec = input->spec(number);
    const int channel = spec.channelindex("A");
    std::vector<float>& values = alphas.emplace_back(std::size_t(spec.width) * std::size_t(spec.height));
    if (!input->read_image(number, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, values.data()))
      throw std::runtime_error(input->geterror());
  }
  return alphas;
}

}  // namespace cdsm::property
