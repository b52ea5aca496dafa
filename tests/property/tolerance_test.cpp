// SPDX-License-Identifier: Apache-2.0
// |V' - V| <= tolerance at every depth: the compressed function, read at texel centres without filtering, against the
// uncompressed one of the same ray at the same step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::Visibility;

constexpr int kMapSize = 64;
constexpr int kDepths = 240;

/// Single precision in the depths, the samples and the point itself.
constexpr double kSlack = 2e-3;

/// Points nearer than this to a surface in depth are on either side of it in single precision.
constexpr double kAtSurface = 1e-3;

struct Band {
  double low, high;
};

/// V at a depth. Inside a step it lies between the straight line and the exponential through the step's ends.
Band visibilityAt(const Visibility& v, double depth) {
  const auto after = std::upper_bound(v.begin(), v.end(), depth,
                                      [](double d, const std::pair<double, double>& entry) { return d < entry.first; });
  if (after == v.begin()) return {1.0, 1.0};
  const auto before = after - 1;
  if (after == v.end()) return {before->second, before->second};
  const double f = (depth - before->first) / (after->first - before->first);
  const double line = before->second + f * (after->second - before->second);
  const double exponential = std::pow(before->second, 1.0 - f) * std::pow(after->second, f);
  return {std::min(line, exponential), std::max(line, exponential)};
}

bool atSurface(const Visibility& v, double depth) {
  for (std::size_t i = 1; i < v.size(); ++i) {
    if (v[i].first == v[i - 1].first && std::abs(depth - v[i].first) < kAtSurface) return true;
  }
  return false;
}

/// Smoke, a blob that overlaps it, a translucent sheet inside of both, seen at a slant; by an omni light, on its map
/// towards -y.
Scene cloudyScene(LightType type = LightType::Spot) {
  Scene scene = reference::emptyScene();
  Light& light = scene.lights.front();
  light.type = type;
  light.position = {1.5f, 3.5f, 1.0f};
  light.direction = {-0.5f, -1.0f, -0.3f};
  light.cutoff = 16.0f;
  reference::addVolume(
      scene, reference::makeVolume(VoxelType::UInt8, glm::uvec3(20), glm::vec3(-1), glm::vec3(1), reference::smoke),
      reference::linearOpacity(255.0, 0.9f, 0.25f));
  glm::mat4 lower(1.0f);
  lower[3] = {0.2f, -0.7f, 0.1f, 1.0f};
  reference::addVolume(
      scene,
      reference::makeVolume(VoxelType::Float32, glm::uvec3(16), glm::vec3(-1), glm::vec3(1), reference::gaussianBlob),
      reference::linearOpacity(1.0, 0.8f, 0.5f), lower);
  reference::addMesh(scene, reference::stackMesh(1, -0.3f, 1.0f, 2.0f),
                     reference::addMaterial(scene, glm::vec3(1), 0.4f));
  return scene;
}

struct TexelRay {
  std::vector<Visibility> visibilities;  ///< of red, green and blue light
  std::vector<double> depths;
  std::vector<glm::vec3> points;
};

/// The ray through one texel's centre with points at dense depths, those at surfaces left out.
TexelRay texelRay(const reference::World& world, int column, int row) {
  const LightFrame frame(world.scene, world.scene.lights.front(), kMapSize);
  const reference::Ray line = frame.texelRay(column, row);
  const double depthPerT = frame.depthPerT(column, row);
  TexelRay ray;
  for (int channel = 0; channel < 3; ++channel)
    ray.visibilities.push_back(reference::visibility(world, line, depthPerT, reference::kEngineStep, channel));
  const Visibility& red = ray.visibilities.front();  // all have the same depths
  const double first = 0.5 * red[1].first;
  const double last = red.back().first + 0.5;
  for (int i = 0; i < kDepths; ++i) {
    const double depth = first + (last - first) * (i + 0.5) / kDepths;
    if (atSurface(red, depth)) continue;
    ray.depths.push_back(depth);
    ray.points.emplace_back(line.at(depth / depthPerT));
  }
  return ray;
}

/// |V' - V| over the ray's points, without the slack.
double largestError(const TexelRay& ray, const std::vector<Transmittance>& result) {
  double largest = 0.0;
  for (std::size_t i = 0; i < ray.depths.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const Band band = visibilityAt(ray.visibilities[std::size_t(channel)], ray.depths[i]);
      const auto found = static_cast<double>(result[i].color[channel]);
      largest = std::max({largest, band.low - found, found - band.high});
    }
  }
  return largest;
}

class Tolerance : public ::testing::TestWithParam<std::tuple<std::string, float, LightType, std::string, bool>> {};

TEST_P(Tolerance, boundsTheCompression) {
  const auto [memory, tolerance, type, format, colored] = GetParam();
  Path path = mapPath(memory, "nearest");
  path.format = format;
  Scene scene = cloudyScene(type);
  if (colored) reference::giveRandomTransmissions(scene, 1);
  const reference::World world(along(path, scene, kMapSize, tolerance));
  double largest = 0.0;
  for (int row = 14; row < kMapSize - 13; row += 5) {
    for (int column = 14; column < kMapSize - 13; column += 5) {
      const TexelRay ray = texelRay(world, column, row);
      const std::vector<Transmittance> result = query(path, world.scene, ray.points);
      ASSERT_EQ(result.size(), ray.points.size());
      const double error = largestError(ray, result);
      EXPECT_LE(error, static_cast<double>(tolerance) + kSlack) << "texel " << column << " " << row;
      largest = std::max(largest, error);
    }
  }
  std::cout << memory << ", " << format << (colored ? ", in colour" : "") << ", tolerance " << tolerance
            << ": largest error " << largest << "\n";
}

INSTANTIATE_TEST_SUITE_P(Maps, Tolerance,
                         ::testing::Combine(::testing::Values("atlas", "chunked", "exact", "tiled"),
                                            ::testing::Values(0.0f, 0.002f, 0.01f, 0.05f),
                                            ::testing::Values(LightType::Spot), ::testing::Values("float32"),
                                            ::testing::Values(false)));

INSTANTIATE_TEST_SUITE_P(MapsOf16Bits, Tolerance,
                         ::testing::Combine(::testing::Values("atlas", "chunked", "exact", "tiled"),
                                            ::testing::Values(2e-5f, 0.01f), ::testing::Values(LightType::Spot),
                                            ::testing::Values("unorm16"), ::testing::Values(false)));

INSTANTIATE_TEST_SUITE_P(MapsInColor, Tolerance,
                         ::testing::Combine(::testing::Values("chunked", "exact"), ::testing::Values(0.01f),
                                            ::testing::Values(LightType::Spot), ::testing::Values("float32", "unorm16"),
                                            ::testing::Values(true)));

INSTANTIATE_TEST_SUITE_P(MapsOfOtherLights, Tolerance,
                         ::testing::Combine(::testing::Values("chunked"), ::testing::Values(0.0f, 0.01f),
                                            ::testing::Values(LightType::Omni, LightType::Directional),
                                            ::testing::Values("float32"), ::testing::Values(false)));

INSTANTIATE_TEST_SUITE_P(MapsOf16BitsOfOtherLights, Tolerance,
                         ::testing::Combine(::testing::Values("exact"), ::testing::Values(0.01f),
                                            ::testing::Values(LightType::Omni, LightType::Directional),
                                            ::testing::Values("unorm16"), ::testing::Values(false)));

std::uint64_t nodesOf(float tolerance) {
  const Path path = mapPath();
  query(path, along(path, cloudyScene(), kMapSize, tolerance), {glm::vec3(0.0f)});
  std::uint64_t nodes = 0;
  for (const LightStats& light : engineOf(path.fetch).stats().lights) {
    for (const MapStats& map : light.maps) nodes += map.nodesTotal;
  }
  return nodes;
}

TEST(Compression, takesFewerNodesForALargerTolerance) {
  const std::uint64_t fine = nodesOf(0.001f);
  const std::uint64_t medium = nodesOf(0.01f);
  const std::uint64_t coarse = nodesOf(0.05f);
  EXPECT_GT(coarse, 0u);
  EXPECT_LT(coarse, medium);
  EXPECT_LT(medium, fine);
}

}  // namespace
}  // namespace cdsm::property
