// SPDX-License-Identifier: Apache-2.0
// Views of lights' maps: rays and pixels belong together, omni lights see every point, directional ones all of the
// scene.
#include "cluster/light_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cdsm::cluster {
namespace {

using shared::ViewData;

constexpr int kSize = 64;

scene::Bounds boxAround(const glm::vec3& center, const glm::vec3& half) {
  scene::Bounds bounds;
  bounds.add(center - half);
  bounds.add(center + half);
  return bounds;
}

Light lightOf(LightType type) {
  Light light;
  light.type = type;
  light.position = {1.0f, 2.0f, -1.5f};
  light.direction = {0.4f, -2.0f, 1.0f};
  return light;
}

glm::vec3 xyz(const shared::float4& v) { return {v.x, v.y, v.z}; }
float row(const shared::float4& row, const glm::vec3& p) { return glm::dot(xyz(row), p) + row.w; }

struct Pixel {
  float u, v, depth, w;
};

Pixel pixelOf(const ViewData& view, const glm::vec3& p) {
  const float w = row(view.pixelW, p);
  return {row(view.pixelU, p) / w, row(view.pixelV, p) / w, row(view.depth, p), w};
}

glm::vec3 pointOf(const ViewData& view, float u, float v, float depth) {
  return xyz(view.origin) + u * xyz(view.originU) + v * xyz(view.originV) +
         depth * (xyz(view.dir) + u * xyz(view.dirU) + v * xyz(view.dirV));
}

TEST(LightCamera, RaysRunThroughTheirPixels) {
  const scene::Bounds bounds = boxAround({0.5f, 0.0f, 1.0f}, {2.0f, 1.0f, 3.0f});
  for (const LightType type : {LightType::Spot, LightType::Omni, LightType::Directional})
    for (const ViewData& view : lightViews(lightOf(type), bounds, kSize))
      for (const float u : {0.5f, 13.5f, 63.5f})
        for (const float v : {0.0f, 40.5f, 64.0f}) {
          const Pixel pixel = pixelOf(view, pointOf(view, u, v, 2.5f));
          EXPECT_NEAR(pixel.u, u, 2e-4f);
          EXPECT_NEAR(pixel.v, v, 2e-4f);
          EXPECT_NEAR(pixel.depth, 2.5f, 1e-5f);
        }
}

/// Of the six maps, those that look along the axis on which a point is farthest see it, with a texel to spare.
TEST(LightCamera, OmniLightsSeeEveryPoint) {
  const Light light = lightOf(LightType::Omni);
  const auto views = lightViews(light, boxAround({0, 0, 0}, {1, 1, 1}), kSize);
  ASSERT_EQ(views.size(), 6u);
  for (int face = 0; face < 6; ++face)
    for (const float a : {-1.0f, -0.3f, 1.0f})
      for (const float b : {-1.0f, 0.6f, 1.0f}) {
        glm::vec3 way;
        way[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
        way[(face / 2 + 1) % 3] = a;
        way[(face / 2 + 2) % 3] = b;
        const Pixel pixel = pixelOf(views[std::size_t(face)], light.position + 3.0f * way);
        EXPECT_NEAR(pixel.depth, 3.0f, 1e-5f);
        EXPECT_GE(std::min(pixel.u, pixel.v), 1.0f - 1e-4f) << face;
        EXPECT_LE(std::max(pixel.u, pixel.v), kSize - 1.0f + 1e-4f) << face;
      }
  EXPECT_NEAR(mapFov(views[0]), 2.0 * glm::degrees(std::atan(64.0 / 62.0)), 1e-4);
}

TEST(LightCamera, DirectionalLightsSeeAllOfTheScene) {
  for (const glm::vec3& half : {glm::vec3(2, 1, 3), glm::vec3(5, 0, 5), glm::vec3(0, 1, 0), glm::vec3(1e-3f, 1, 100)})
    for (const glm::vec3& direction : {glm::vec3(0, -1, 0), glm::vec3(1, 0, 0), glm::vec3(0.4f, -2, 1)})
      for (const float far : {0.0f, 1000.0f}) {
        Light light = lightOf(LightType::Directional);
        light.direction = direction;
        const glm::vec3 center(far, 0.5f, -far);
        const scene::Bounds bounds = boxAround(center, half);
        const auto views = lightViews(light, bounds, kSize);
        ASSERT_EQ(views.size(), 1u);
        const shared::LightData data = lightData(light, bounds);
        for (int i = 0; i < 8; ++i) {
          const glm::vec3 corner = center + half * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
          const Pixel pixel = pixelOf(views[0], corner);
          EXPECT_GT(pixel.depth, 0.0f);
          EXPECT_EQ(pixel.w, 1.0f);
          EXPECT_GE(std::min(pixel.u, pixel.v), 0.75f);
          EXPECT_LE(std::max(pixel.u, pixel.v), kSize - 0.75f);
          EXPECT_LT(glm::dot(xyz(data.position), corner), data.front);
        }
        EXPECT_EQ(mapFov(views[0]), 0.0);
      }
}

TEST(LightCamera, AnEmptySceneHasViewsToo) {
  for (const LightType type : {LightType::Omni, LightType::Directional}) {
    for (const ViewData& view : lightViews(lightOf(type), {}, kSize))
      for (const float number :
           {view.pixelU.w, view.pixelV.w, view.depth.w, view.origin.x, view.dirU.x, view.originU.x})
        EXPECT_TRUE(std::isfinite(number));
    EXPECT_TRUE(std::isfinite(lightData(lightOf(type), {}).front));
  }
}

}  // namespace
}  // namespace cdsm::cluster
