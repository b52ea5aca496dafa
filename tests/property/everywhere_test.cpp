// SPDX-License-Identifier: Apache-2.0
// Tolerance mode "everywhere": |V' - V| <= tolerance at every depth, where V is the integral of the transfer function
// over the trilinear field, here summed up in double precision at steps so fine that even the thinnest peak takes
// several.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::Visibility;
using OpacityPoints = std::vector<TransferFunction::OpacityPoint>;

constexpr int kMapSize = 16;
constexpr int kDepths = 400;
constexpr unsigned kVoxels = 12;
/// Steps of the reference per voxel of that grid: of a peak one value wide, where neighbours differ by 255, sixteen.
constexpr double kFine = 4096.0;
/// For extinctions of which one such step more or less makes a difference.
constexpr double kVeryFine = 65536.0;
/// Texels from one ray to the next, in both directions.
constexpr int kRayDistance = 3;

/// Single precision of the engine, and what the reference is off: half a step at each jump of the extinction.
constexpr double kSlack = 1e-4;
/// Points nearer than this to a surface in depth are on either side of it in single precision.
constexpr double kAtSurface = 1e-4;

TransferFunction transfer(const OpacityPoints& points, float unitDistance) {
  TransferFunction function = reference::constantOpacity(0.0f, unitDistance);
  function.opacity = points;
  return function;
}

/// A peak of one value unit in data of 0 .. 255, with nothing beside it.
TransferFunction thinPeak(float at) { return transfer({{at - 0.5f, 0.0f}, {at, 0.99f}, {at + 0.5f, 0.0f}}, 0.12f); }

TransferFunction steps() {
  return transfer({{0.0f, 0.0f},
                   {80.0f, 0.0f},
                   {80.0f, 0.6f},
                   {81.5f, 0.6f},
                   {81.5f, 0.02f},
                   {200.25f, 0.1f},
                   {200.25f, 0.9999f},
                   {201.0f, 1.0f},
                   {201.0f, 0.0f}},
                  3.0f);
}

VolumeData randomVolume(std::uint32_t seed, VoxelType type = VoxelType::UInt8) {
  reference::Random random(seed);
  return reference::makeVolume(type, glm::uvec3(kVoxels), glm::vec3(-1), glm::vec3(1),
                               [&](const glm::dvec3&) { return random.uniform(0.0, 1.0); });
}

Scene withVolume(const VolumeData& data, const TransferFunction& function) {
  Scene scene = reference::emptyScene();
  scene.lights.front().position = {1.0f, 3.0f, 0.6f};
  scene.lights.front().cutoff = 17.0f;
  reference::addVolume(scene, data, function);
  return scene;
}

Scene smokePeaks() {
  return withVolume(
      reference::makeVolume(VoxelType::UInt8, glm::uvec3(kVoxels), glm::vec3(-1), glm::vec3(1), reference::smoke),
      thinPeak(60.3f));
}

/// A peak as thin as that in data of 0 .. 1.
TransferFunction thinPeakOfFractions(float at) {
  return transfer({{at - 0.5f / 255.0f, 0.0f}, {at, 0.99f}, {at + 0.5f / 255.0f, 0.0f}}, 0.12f);
}

void addFilledBox(Scene& scene, float extinction) {
  const int box = reference::addMesh(scene, reference::boxMesh(glm::vec3(-0.5f), glm::vec3(0.6f)),
                                     reference::addMaterial(scene, glm::vec3(1), 0.1f));
  scene.meshes[std::size_t(box)].interiorExtinction = extinction;
}

/// Two volumes of noise in each other, one of them turned, a filled box and a translucent sheet through both.
Scene overlapping(std::uint32_t seed, const TransferFunction& first, const TransferFunction& second, float extinction) {
  Scene scene = withVolume(randomVolume(seed), first);
  glm::mat4 turned(0.6f);
  turned[0] = {0.5f, 0.2f, 0.1f, 0.0f};
  turned[3] = {0.2f, -0.3f, 0.1f, 1.0f};
  reference::addVolume(scene, randomVolume(seed + 1, VoxelType::Float32), second, turned);
  addFilledBox(scene, extinction);
  reference::addMesh(scene, reference::stackMesh(1, -0.3f, 1.0f, 2.0f),
                     reference::addMaterial(scene, glm::vec3(1), 0.4f));
  return scene;
}

Scene overlapping() {
  return overlapping(11, thinPeak(128.0f), transfer({{0.4f, 0.0f}, {0.4f, 0.5f}, {0.7f, 0.1f}}, 0.4f), 0.8f);
}

/// More media in one place than the march keeps cubics of, constant ones between them.
Scene crowd() {
  Scene scene = reference::emptyScene();
  scene.lights.front() = withVolume(randomVolume(1), thinPeak(128.0f)).lights.front();
  for (std::uint32_t i = 0; i < 7; ++i) {
    glm::mat4 turned(0.6f);
    turned[0] = {0.5f, 0.3f - 0.1f * float(i), 0.1f, 0.0f};
    turned[3] = {0.2f - 0.05f * float(i), -0.3f, 0.1f, 1.0f};
    const TransferFunction peak = transfer({{70.0f + 8.0f * float(i), 0.0f}, {128.0f, 0.9f}, {140.0f, 0.0f}}, 2.0f);
    reference::addVolume(scene, randomVolume(40 + i), peak, turned);
    addFilledBox(scene, 0.05f);
  }
  return scene;
}

Scene filledBox() {
  Scene scene = reference::emptyScene();
  const int box = reference::addMesh(scene, reference::boxMesh(glm::vec3(-1.0f), glm::vec3(1.0f)),
                                     reference::addMaterial(scene, glm::vec3(1), 0.0f));
  scene.meshes[std::size_t(box)].interiorExtinction = 40.0f;
  return scene;
}

/// V at a depth; the reference's steps have even extinction.
double visibilityAt(const Visibility& v, double depth) {
  const auto after = std::upper_bound(v.begin(), v.end(), depth,
                                      [](double d, const std::pair<double, double>& entry) { return d < entry.first; });
  if (after == v.begin()) return 1.0;
  const auto before = after - 1;
  if (after == v.end()) return before->second;
  const double f = (depth - before->first) / (after->first - before->first);
  return std::pow(before->second, 1.0 - f) * std::pow(after->second, f);
}

/// Shares of the way from the first to the last extinction at which V is asked for: even ones, and ones where it falls.
std::vector<double> depthsOf(const Visibility& v) {
  std::vector<double> depths;
  const double first = v[0].first, last = v.back().first;
  for (int i = 0; i < kDepths; ++i) depths.push_back(first + (last - first) * (i + 0.5) / kDepths);
  double level = 1.0;
  for (const auto& [depth, value] : v) {
    if (value > level - 0.004) continue;
    depths.push_back(depth);
    level = value;
  }
  const auto atSurface = [&](double depth) {
    for (std::size_t i = 1; i < v.size(); ++i)
      if (v[i].first == v[i - 1].first && std::abs(depth - v[i].first) < kAtSurface) return true;
    return false;
  };
  depths.erase(std::remove_if(depths.begin(), depths.end(), atSurface), depths.end());
  return depths;
}

/// A texel's ray: depths, the points there, V at them.
struct TexelRay {
  std::vector<glm::dvec3> values;  ///< of red, green and blue light
  std::vector<glm::vec3> points;
};

std::vector<TexelRay> texelRays(const reference::World& world, double fineness, int distance) {
  const LightFrame frame(world.scene, world.scene.lights.front(), kMapSize);
  std::vector<TexelRay> rays;
  for (int row = 3; row < kMapSize - 3; row += distance) {
    for (int column = 3; column < kMapSize - 3; column += distance) {
      const reference::Ray line = frame.texelRay(column, row);
      const double depthPerT = frame.depthPerT(column, row);
      const auto visibility = [&](int channel) {
        return reference::visibility(world, line, depthPerT, 2.0 / kVoxels / fineness, channel);
      };
      const Visibility red = visibility(0);
      if (red.size() < 2) continue;
      const bool colored = world.scene.shadows.transmittance == "rgb";
      const Visibility green = colored ? visibility(1) : red, blue = colored ? visibility(2) : red;
      TexelRay ray;
      for (const double depth : depthsOf(red)) {
        ray.values.emplace_back(visibilityAt(red, depth), visibilityAt(green, depth), visibilityAt(blue, depth));
        ray.points.emplace_back(line.at(depth / depthPerT));
      }
      rays.push_back(ray);
    }
  }
  return rays;
}

Scene inMode(Scene scene, const std::string& mode, LightType type = LightType::Spot) {
  scene.lights.front().type = type;
  scene.lights.front().direction = {-0.3f, -1.0f, -0.2f};
  scene.shadows.toleranceMode = mode;
  return scene;
}

/// |V' - V| over the rays.
double largestError(const Scene& scene, const std::vector<TexelRay>& rays, float tolerance, const char* fetch) {
  Path path = mapPath("chunked", "nearest");
  path.fetch = fetch;
  double largest = 0.0;
  for (const TexelRay& ray : rays) {
    const std::vector<Transmittance> found = query(path, along(path, scene, kMapSize, tolerance), ray.points);
    for (std::size_t i = 0; i < found.size(); ++i)
      for (int channel = 0; channel < 3; ++channel)
        largest = std::max(largest, std::abs(double(found[i].color[channel]) - ray.values[i][channel]));
  }
  return largest;
}

void expectBoundOn(const char* what, const Scene& scene, const std::vector<TexelRay>& rays,
                   const std::vector<float>& tolerances, const char* fetch = "buffer") {
  for (const float tolerance : tolerances) {
    const double error = largestError(scene, rays, tolerance, fetch);
    EXPECT_LE(error, static_cast<double>(tolerance) + kSlack) << what;
    std::cout << what << ", tolerance " << tolerance << ": largest error " << error << "\n";
  }
}

void expectBound(const char* what, const Scene& given, LightType type = LightType::Spot) {
  const Scene scene = inMode(given, "everywhere", type);
  expectBoundOn(what, scene, texelRays(scene, kFine, kRayDistance), {0.01f, 0.002f});
}

/// On fewer rays, but to the least tolerance.
void expectBoundToTheLast(const char* what, const Scene& given, double fineness) {
  const Scene scene = inMode(given, "everywhere");
  expectBoundOn(what, scene, texelRays(scene, fineness, 2 * kRayDistance), {0.01f, 0.002f, 0.001f});
}

TEST(ToleranceEverywhere, boundsThinPeaks) { expectBound("thin peak in smoke", smokePeaks()); }

TEST(ToleranceEverywhere, boundsThinPeaksInNoise) {
  expectBound("thin peak in noise", withVolume(randomVolume(1), thinPeak(140.0f)));
}

TEST(ToleranceEverywhere, boundsSteps) { expectBound("steps in noise", withVolume(randomVolume(2), steps())); }

TEST(ToleranceEverywhere, boundsPeaksThinnerThanTheTable) {
  // data in [0, 1], where a table of 8192 entries up to 1e5 has none between 0 and 12
  const OpacityPoints points{{0.4f, 0.0f}, {0.5f, 0.7f}, {0.6f, 0.0f}, {1e5f, 0.0f}, {100000.5f, 0.1f}};
  expectBound("peak within one entry", withVolume(randomVolume(3, VoxelType::Float32), transfer(points, 0.5f)));
}

TEST(ToleranceEverywhere, boundsOverlappingMedia) { expectBound("overlapping media", overlapping()); }

/// Hundreds of peaks on a ray, each met for a thousandth of a voxel cell, and an interior that takes a little of the
/// light in each of as many steps: what rounding does in one of them must neither ask for more steps nor add up.
TEST(ToleranceEverywhere, boundsThinPeaksInOverlappingNoise) {
  const Scene scene = overlapping(13, thinPeak(128.0f), thinPeakOfFractions(0.5f), 0.2f);
  expectBoundToTheLast("thin peaks in overlapping noise", scene, kVeryFine);
}

TEST(ToleranceEverywhere, boundsManyMediaInOnePlace) { expectBoundToTheLast("crowd of media", crowd(), kFine); }

TEST(ToleranceEverywhere, boundsWhatIsReadFromImages) {
  if (!canFetch("image")) GTEST_SKIP() << "the device has no images";
  const Scene scene = inMode(smokePeaks(), "everywhere");
  expectBoundOn("thin peak in smoke, from images", scene, texelRays(scene, kFine, 2 * kRayDistance), {0.002f}, "image");
}

TEST(ToleranceEverywhere, boundsInteriors) { expectBound("interior", filledBox()); }

TEST(ToleranceEverywhere, boundsColors) {
  Scene scene = smokePeaks();
  addFilledBox(scene, 0.8f);
  reference::giveRandomTransmissions(scene, 7);
  scene.volumes.front().transfer.transmission = {{60.2f, {0.0f, 1.0f, 0.2f}}, {60.2f, {1.0f, 0.3f, 0.0f}}};
  expectBound("colours of a thin peak with a step and of an interior", scene);
}

TEST(ToleranceEverywhere, boundsParallelLight) { expectBound("parallel light", overlapping(), LightType::Directional); }

TEST(ToleranceEverywhere, isMoreThanTheBoundAtSamples) {
  const Scene scene = inMode(smokePeaks(), "samples");
  EXPECT_GT(largestError(scene, texelRays(scene, kFine, kRayDistance), 0.01f, "buffer"), 0.02);
}

}  // namespace
}  // namespace cdsm::property
