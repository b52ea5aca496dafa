// SPDX-License-Identifier: Apache-2.0
#include "engine/supersampling.hpp"

namespace cdsm::engine {

namespace {

glm::vec4 averageRays(const std::vector<shared::float4>& rays, int x, int y, int side, int rayWidth) {
  glm::vec4 sum(0.0f);
  for (int v = y * side; v < (y + 1) * side; ++v)
    for (int u = x * side; u < (x + 1) * side; ++u) {
      const shared::float4& ray = rays[std::size_t(v) * rayWidth + u];
      sum += glm::vec4(ray.x, ray.y, ray.z, ray.w);
    }
  return sum / float(side * side);
}

}  // namespace

Image resolve(const std::vector<shared::float4>& rays, const ImageSettings& settings) {
  Image image;
  image.width = settings.width;
  image.height = settings.height;
  image.pixels.resize(std::size_t(image.width) * image.height);
  resolve(rays, settings, image.pixels.data());
  return image;
}

void resolve(const std::vector<shared::float4>& rays, const ImageSettings& settings, glm::vec4* pixels) {
  const int side = settings.supersampling;
  for (int y = 0; y < settings.height; ++y)
    for (int x = 0; x < settings.width; ++x) {
      const glm::vec4 pixel = averageRays(rays, x, y, side, settings.width * side);
      *pixels++ = glm::vec4(glm::vec3(pixel) + (1.0f - pixel.w) * settings.background, pixel.w);
    }
}

}  // namespace cdsm::engine
