// SPDX-License-Identifier: Apache-2.0
// Trilinear values and gradients of common/volume.clh against double precision: all voxel types, from buffers and from
// images, inside, at the border and beyond it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"
#include "test_volumes.hpp"

namespace cdsm::kernels {
namespace {

using shared::float4;

const char* const kText = R"(
#include "common/medium.clh"
/// An item per point; values: of volumeValue, gradients: of volumeGradient, corners: eight of volumeCell.
__kernel void sampleVolume(uint count, __global const float* points, __global float* values,
                           __global float4* gradients, __global float* corners, CDSM_SCENE_PARAMS) {
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  MediumData m = media[0];
  float3 p = vload3(i, points);
  values[i] = volumeValue(m.size.w, m.size, p CDSM_VOLUME_ARGS);
  gradients[i] = volumeGradient(m.size.w, m.size, p CDSM_VOLUME_ARGS);
  vstore8(volumeCell(m.size.w, m.size, convert_int3(floor(p)) CDSM_VOLUME_ARGS), i, corners);
}
)";

/// Voxel centres, borders, corners, a little beside them, and anywhere up to three voxels outside.
std::vector<glm::vec3> samplePoints(const glm::vec3& size, std::uint32_t seed) {
  reference::Random random(seed);
  std::vector<glm::vec3> points;
  const auto coordinate = [&](float n) -> float {
    const float special[] = {-0.5f, 0.0f, n - 1.0f, n - 0.5f, 0.5f, n - 1.5f, -1e-6f, n - 1.0f + 1e-6f};
    switch (random.integer(0, 3)) {
      case 0:
        return special[random.integer(0, 7)];
      case 1:
        return float(random.integer(-2, int(n) + 1));
      case 2:
        return float(random.uniform(-3.0, n + 3.0));
      default:
        return float(random.uniform(0.0, n - 1.0));
    }
  };
  for (int i = 0; i < 2000; ++i) {
    const float x = coordinate(size.x), y = coordinate(size.y), z = coordinate(size.z);
    points.emplace_back(x, y, z);
  }
  return points;
}

struct Samples {
  std::vector<float> values;
  std::vector<float4> gradients;
  std::vector<float> corners;  ///< eight a point
};

Samples sampleOnDevice(device::Device& device, const TestGrid& grid, const std::vector<glm::vec3>& points) {
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, grid.data, reference::constantOpacity(0.5f, 1.0f));
  build::DeviceScene onDevice(device);
  onDevice.update(scene);
  std::vector<float> coordinates;
  for (const glm::vec3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  using Floats = device::Buffer<float>;
  const Floats in = Floats::fromHost(device, coordinates, "points");
  Floats values(device, points.size(), "values"), corners(device, 8 * points.size(), "corners");
  device::Buffer<float4> gradients(device, points.size(), "gradients");
  const device::Buffer<std::uint32_t> around(device, 0, "objects around");
  device::Kernel<std::uint32_t, Floats, Floats, device::Buffer<float4>, Floats, device::ArgumentList> kernel(
      device, sceneTestProgram(device, onDevice, kText), "sampleVolume");
  kernel({"sample volume", {points.size()}, {kGroup}}, std::uint32_t(points.size()), in, values, gradients, corners,
         onDevice.arguments(onDevice.allObjects(), around));
  return {values.download(), gradients.download(), corners.download()};
}

class VolumeSamples : public ::testing::TestWithParam<std::tuple<std::size_t, const char*>> {
 protected:
  const TypeRange& range_ = kTypes[std::get<0>(GetParam())];
  const std::string fetch_ = std::get<1>(GetParam());

  void SetUp() override {
    if (!canFetch(fetch_)) GTEST_SKIP() << "the device has no images";
  }
  /// Of a value: rounding of seven interpolations, or an image's fractions of 8 bits [OpenCL 1.2, §8.2] in three axes.
  double allowed() const {
    const double span = range_.high - range_.low;
    return span * (fetch_ == "image" ? 3.0 / 256.0 : 2e-6);
  }
  void expectExact(const glm::uvec3& size);
};

void VolumeSamples::expectExact(const glm::uvec3& size) {
  const TestGrid grid = randomGrid(range_, size, size.x + 31 * size.y);
  const std::vector<glm::vec3> points = samplePoints(glm::vec3(size), 5);
  const Samples samples = sampleOnDevice(deviceOf(fetch_), grid, points);
  int wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 p(points[i]), gradient = grid.gradient(p);
    const float4 g = samples.gradients[i];
    const double value = grid.value(p);
    const double error = std::max(std::abs(samples.values[i] - value), std::abs(g.w - value));
    const double slope = std::max({std::abs(g.x - gradient.x), std::abs(g.y - gradient.y), std::abs(g.z - gradient.z)});
    if ((error <= allowed() && slope <= 2.0 * allowed()) || ++wrong > 4) continue;
    ADD_FAILURE() << "at " << p.x << ", " << p.y << ", " << p.z << " of " << size.x << " x " << size.y << " x "
                  << size.z << ": value " << samples.values[i] << " (with gradient " << g.w << "), expected " << value
                  << "; gradient " << g.x << ", " << g.y << ", " << g.z << ", expected " << gradient.x << ", "
                  << gradient.y << ", " << gradient.z;
  }
}

TEST_P(VolumeSamples, areTrilinear) { expectExact({7, 9, 6}); }
TEST_P(VolumeSamples, areTrilinearInThinVolumes) {
  expectExact({1, 5, 2});
  expectExact({2, 1, 3});
  expectExact({4, 2, 1});
}
TEST_P(VolumeSamples, areTheVoxelInAVolumeOfOne) { expectExact({1, 1, 1}); }

/// Of images too, whose fractions play no part: within rounding of their scale.
TEST_P(VolumeSamples, areTheVoxelsAtTheCornersOfCells) {
  const TestGrid grid = randomGrid(range_, {5, 4, 6}, 9);
  const std::vector<glm::vec3> points = samplePoints(glm::vec3(5, 4, 6), 6);
  const Samples samples = sampleOnDevice(deviceOf(fetch_), grid, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 8; ++k) {
      const double voxel = grid.value(glm::dvec3(glm::floor(points[i])) + glm::dvec3(k >> 2, k & 1, k >> 1 & 1));
      ASSERT_NEAR(samples.corners[8 * i + std::size_t(k)], voxel,
                  fetch_ == "image" ? 1e-6 * (range_.high - range_.low) : 0.0)
          << "corner " << k << " at " << points[i].x << ", " << points[i].y << ", " << points[i].z;
    }
  }
}

/// The ends of a type as they are in the file, at voxel centres.
TEST_P(VolumeSamples, areTheFilesOwnValuesAtTheEnds) {
  const std::vector<double> values{range_.low, range_.low + 1.0, range_.high - 1.0, range_.high};
  const TestGrid grid = makeGrid(range_.type, {4, 1, 1}, values);
  const std::vector<glm::vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const Samples samples = sampleOnDevice(deviceOf(fetch_), grid, points);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(samples.values[i], values[i], 1e-6 * (range_.high - range_.low));
    EXPECT_NEAR(samples.gradients[i].w, values[i], 1e-6 * (range_.high - range_.low));
  }
}

INSTANTIATE_TEST_SUITE_P(Types, VolumeSamples,
                         ::testing::Combine(::testing::Range<std::size_t>(0, kTypes.size()),
                                            ::testing::Values("buffer", "image")),
                         [](const auto& instance) {
                           return kTypes[std::get<0>(instance.param)].name + std::string(std::get<1>(instance.param));
                         });

}  // namespace
}  // namespace cdsm::kernels
