// SPDX-License-Identifier: Apache-2.0
// build/cell_cubic.clh against trilinear values in double precision: rays through random cells of a volume, parts of
// them down to a millionth, near the volume's origin and far from it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel_test.hpp"
#include "test_volumes.hpp"

namespace cdsm::kernels {
namespace {

using shared::float2;
using shared::float4;

const char* const kText = R"(
#include "build/cell_cubic.clh"
/// An item per part: of the ray origin + depth * dir between the depths spans.x and spans.y, from u to u + h.
__kernel void cutCubics(uint count, __global const float4* origins, __global const float4* dirs,
                        __global const float2* spans, __global const float2* parts, __global float4* results,
                        CDSM_SCENE_PARAMS) {
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  MediumData m = media[0];
  IndexRay ray;
  ray.origin = origins[i].xyz;
  ray.dir = dirs[i].xyz;
  CellCubic cubic = cellCubic(&m, &ray, spans[i].x, spans[i].y - spans[i].x CDSM_VOLUME_ARGS);
  CubicPart part = partOfCubic(cubic, parts[i].x, parts[i].y);
  results[i] = (float4)(part.first, part.rise, part.bend, 0.0f);
}
)";

constexpr unsigned kWidth = 200;
constexpr double kHighest = 255.0;
/// Of values: the corners are exact, some eight operations on them are not.
constexpr double kRounding = 8.0 * kHighest * 6e-8;

/// Rays that enter a cell and leave it at whole coordinates, and parts of the way between.
struct Cuts {
  std::vector<float4> origins, dirs;
  std::vector<float2> spans, parts;
};

/// At depth 1 a ray enters a cell through its left or right side, at depth 2 it leaves it through the other. Both
/// points have few digits, so that single precision has them exactly, far from the volume's origin too.
Cuts randomCuts(int count) {
  reference::Random random(3);
  const auto sixteenths = [&] { return float(random.integer(0, 16)) / 16.0f; };
  Cuts cuts;
  for (int i = 0; i < count; ++i) {
    const float x = float(random.integer(0, int(kWidth) - 2)), y = float(random.integer(0, 4));
    glm::vec3 from(x, y + sixteenths(), sixteenths()), to(x + 1.0f, y + sixteenths(), sixteenths());
    if (i % 2 == 1) std::swap(from, to);
    const glm::vec3 dir = to - from, origin = from - dir;
    cuts.origins.push_back({origin.x, origin.y, origin.z, 0.0f});
    cuts.dirs.push_back({dir.x, dir.y, dir.z, 0.0f});
    cuts.spans.push_back({1.0f, 2.0f});
    const float h = std::exp2(-float(random.integer(0, 20)));
    cuts.parts.push_back({float(random.integer(0, 63)) / 64.0f * (1.0f - h), h});
  }
  return cuts;
}

std::vector<float4> cutOnDevice(const TestGrid& grid, const Cuts& cuts) {
  device::Device& device = deviceOf();
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, grid.data, reference::constantOpacity(0.5f, 1.0f));
  build::DeviceScene onDevice(device);
  onDevice.update(scene);
  using Pairs = device::Buffer<float2>;
  using Quadruples = device::Buffer<float4>;
  const auto origins = Quadruples::fromHost(device, cuts.origins, "origins");
  const auto dirs = Quadruples::fromHost(device, cuts.dirs, "directions");
  const auto spans = Pairs::fromHost(device, cuts.spans, "spans"), parts = Pairs::fromHost(device, cuts.parts, "parts");
  Quadruples results(device, cuts.parts.size(), "results");
  const device::Buffer<std::uint32_t> around(device, 0, "objects around");
  device::Kernel<std::uint32_t, Quadruples, Quadruples, Pairs, Pairs, Quadruples, device::ArgumentList> kernel(
      device, sceneTestProgram(device, onDevice, kText), "cutCubics");
  kernel({"cut cubics", {cuts.parts.size()}, {kGroup}}, std::uint32_t(cuts.parts.size()), origins, dirs, spans, parts,
         results, onDevice.arguments(onDevice.allObjects(), around));
  return results.download();
}

/// The field on the ray of a cut, by way u from 0 to 1: as coefficients of the cubic through four of its values.
struct TrueCubic {
  double c[4];

  TrueCubic(const TestGrid& grid, const float4& origin, const float4& dir) {
    double v[4];
    for (int i = 0; i < 4; ++i)
      v[i] = grid.value(glm::dvec3(origin.x, origin.y, origin.z) + (1.0 + i / 3.0) * glm::dvec3(dir.x, dir.y, dir.z));
    c[0] = v[0];
    c[1] = -5.5 * v[0] + 9.0 * v[1] - 4.5 * v[2] + v[3];
    c[2] = 9.0 * v[0] - 22.5 * v[1] + 18.0 * v[2] - 4.5 * v[3];
    c[3] = 4.5 * (v[3] - v[0]) + 13.5 * (v[1] - v[2]);
  }
  double at(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
  double slope(double u) const { return c[1] + u * (2.0 * c[2] + 3.0 * u * c[3]); }
  /// at(u + h) - at(u), without cancellation.
  double rise(double u, double h) const { return h * (slope(u) + h * (c[2] + 3.0 * u * c[3] + h * c[3])); }
  double size() const { return std::abs(c[1]) + 2.0 * std::abs(c[2]) + 3.0 * std::abs(c[3]); }
};

struct Beside {
  double bend = 0.0, unevenness = 0.0;
};

/// How far the part from u to u + h gets from the line between its ends, in value and in slope, at a hundred places.
Beside besideLine(const TrueCubic& cubic, double u, double h) {
  Beside most;
  const double rise = cubic.rise(u, h);
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.0;
    most.bend = std::max(most.bend, std::abs(cubic.rise(u, t * h) - t * rise));
    most.unevenness = std::max(most.unevenness, std::abs(h * cubic.slope(u + t * h) - rise));
  }
  return most;
}

class CellCubics : public ::testing::Test {
 protected:
  const TestGrid grid_ = randomGrid({VoxelType::UInt8, "UInt8", 0.0, kHighest}, {kWidth, 6, 2}, 4);
  const Cuts cuts_ = randomCuts(4000);
  const std::vector<float4> found_ = cutOnDevice(grid_, cuts_);
};

TEST_F(CellCubics, haveTheFieldsValues) {
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const TrueCubic cubic(grid_, cuts_.origins[i], cuts_.dirs[i]);
    ASSERT_NEAR(found_[i].x, cubic.at(double(cuts_.parts[i].x)), kRounding);
  }
}

TEST_F(CellCubics, areExactInShortParts) {
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const TrueCubic cubic(grid_, cuts_.origins[i], cuts_.dirs[i]);
    const auto [u, h] = std::pair<double, double>(cuts_.parts[i].x, cuts_.parts[i].y);
    const Beside truth = besideLine(cubic, u, h);
    const double bent = 1e-6 * h * h * cubic.size();  // rounding falls as they do
    ASSERT_NEAR(found_[i].y, cubic.rise(u, h), 1e-6 * h * cubic.size());
    ASSERT_GE(found_[i].z, truth.bend - bent);
    ASSERT_LE(found_[i].z, 3.0 * truth.bend + bent);
    ASSERT_GE(4.0 * found_[i].z, truth.unevenness - bent);
    ASSERT_LE(4.0 * found_[i].z, 1.001 * truth.unevenness + bent);
  }
}

}  // namespace
}  // namespace cdsm::kernels
