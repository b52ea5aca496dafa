// SPDX-License-Identifier: Apache-2.0
// Macrocells: no cell that is called empty holds a sample with extinction, and the rings of empty cells that a ray may
// skip are empty. Random volumes of all voxel types under transfer functions with thin peaks, ramps and steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "build/transfer_table.hpp"
#include "kernel_test.hpp"
#include "test_volumes.hpp"

namespace cdsm::kernels {
namespace {

const char* const kText = R"(
#include "common/medium.clh"
/// An item per point of medium `number`.
__kernel void extinctions(uint number, uint count, __global const float* points, __global float* values,
                          CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  MediumData m = media[number];
  values[i] = volumeExtinction(scene, &m, vload3(i, points) CDSM_VOLUME_ARGS);
}
/// An item per macrocell of medium `number`.
__kernel void reaches(uint number, __global int4* counts, __global uint* values, CDSM_SCENE_PARAMS) {
  uint i = (uint)get_global_id(0);
  int4 n = media[number].cells;
  if (i == 0) *counts = n;
  if (i < (uint)(n.x * n.y * n.z)) values[i] = cells[(uint)n.w + i];
}
)";

using Floats = device::Buffer<float>;
using Uints = device::Buffer<std::uint32_t>;

/// Macrocells of one volume as the device has them.
struct Cells {
  glm::ivec3 counts;
  std::vector<std::uint32_t> reach;  ///< 0: not empty; c: the cube c - 1 cells around is empty

  std::uint32_t at(const glm::ivec3& cell) const { return reach[(cell.z * counts.y + cell.y) * counts.x + cell.x]; }
};

class OnDevice {
 public:
  OnDevice(device::Device& device, const Scene& scene) : device_(device), scene_(device), around_(device, 0, "around") {
    scene_.update(scene);
  }

  std::vector<float> extinctions(unsigned medium, const std::vector<glm::vec3>& points) {
    std::vector<float> coordinates;
    for (const glm::vec3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    const Floats in = Floats::fromHost(device_, coordinates, "points");
    Floats out(device_, points.size(), "extinctions");
    device::Kernel<std::uint32_t, std::uint32_t, Floats, Floats, device::ArgumentList> kernel(
        device_, sceneTestProgram(device_, scene_, kText), "extinctions");
    kernel({"extinctions", {points.size()}, {kGroup}}, medium, std::uint32_t(points.size()), in, out,
           scene_.arguments(scene_.allObjects(), around_));
    return out.download();
  }

  Cells cells(unsigned medium, const glm::uvec3& size) {
    const glm::uvec3 counts = build::cellCounts({VoxelType::UInt8, size, {}, glm::mat4(1.0f)});
    const std::size_t count = std::size_t(counts.x) * counts.y * counts.z;
    device::Buffer<shared::int4> deviceCounts(device_, 1, "counts");
    Uints values(device_, count, "reaches");
    device::Kernel<std::uint32_t, device::Buffer<shared::int4>, Uints, device::ArgumentList> kernel(
        device_, sceneTestProgram(device_, scene_, kText), "reaches");
    kernel({"reaches", {count}, {kGroup}}, medium, deviceCounts, values,
           scene_.arguments(scene_.allObjects(), around_));
    const shared::int4 n = deviceCounts.read(0);
    EXPECT_EQ(glm::ivec3(n.x, n.y, n.z), glm::ivec3(counts));
    return {glm::ivec3(counts), values.download()};
  }

 private:
  device::Device& device_;
  build::DeviceScene scene_;
  device::Buffer<std::uint32_t> around_;
};

using Opacities = std::vector<TransferFunction::OpacityPoint>;

/// Curves over [low, high]; widths in parts of it. Points stay ascending and differ as floats.
TransferFunction curve(int kind, double low, double high, reference::Random& random) {
  const double span = high - low, at = low + span * random.uniform(0.1, 0.9);
  const auto point = [&](double value, double opacity) {
    return TransferFunction::OpacityPoint{float(value), float(opacity)};
  };
  TransferFunction transfer = reference::constantOpacity(0.0f, 0.7f);
  switch (kind) {
    case 0:  // a thin peak between whole values
      transfer.opacity = {point(low, 0), point(at - span / 900, 0), point(at, 0.9), point(at + span / 900, 0),
                          point(high, 0)};
      break;
    case 1:  // a peak on whole values
      transfer.opacity = {point(std::round(at) - 1, 0), point(std::round(at), 0.5), point(std::round(at) + 1, 0)};
      break;
    case 2:  // a step
      transfer.opacity = {point(low, 0), point(at, 0), point(at, 0.3), point(high, 0.3)};
      break;
    case 3:  // nothing between two ramps
      transfer.opacity = {point(low, 0.4), point(low + 0.05 * span, 0), point(high - 0.05 * span, 0), point(high, 1.0)};
      break;
    case 4:  // the last value alone
      transfer.opacity = {point(high - span / 300, 0), point(high, 0.8)};
      break;
    default:  // the first value alone
      transfer.opacity = {point(low, 0.8), point(low + span / 300, 0)};
  }
  return transfer;
}
constexpr int kCurves = 6;

/// Patches of nearly constant value, so that many cells are empty under most curves.
TestGrid patchyGrid(const TypeRange& range, const glm::uvec3& size, reference::Random& random) {
  const double span = range.high - range.low;
  std::vector<double> levels, voxels;
  for (int i = 0; i < 64; ++i) levels.push_back(range.low + span * random.uniform(0.0, 1.0));
  for (unsigned z = 0; z < size.z; ++z)
    for (unsigned y = 0; y < size.y; ++y)
      for (unsigned x = 0; x < size.x; ++x) {
        const double level = levels[(x / 11 + 4 * (y / 13) + 16 * (z / 9)) % 64];
        const double noisy = level + span * 0.004 * random.uniform(-1.0, 1.0);
        voxels.push_back(storable(range.type, std::clamp(noisy, range.low, range.high)));
      }
  return makeGrid(range.type, size, voxels);
}

/// Samples of every cell: on its faces, in its corners, anywhere, and beyond the grid.
std::vector<glm::vec3> samplesOf(const glm::uvec3& size, reference::Random& random) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 6000; ++i) {
    glm::vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      const float n = float(size[axis]);
      p[axis] = float(random.uniform(-0.5, n - 0.5));
      if (random.integer(0, 3) == 0) p[axis] = std::round(p[axis] / 8.0f) * 8.0f;
      if (random.integer(0, 3) == 0) p[axis] = std::round(p[axis]);
    }
    points.push_back(p);
  }
  return points;
}

glm::ivec3 cellOf(const glm::vec3& p, const glm::ivec3& counts) {
  return glm::clamp(glm::ivec3(glm::floor(p / 8.0f)), glm::ivec3(0), counts - 1);
}

/// Rounding takes interpolated values a little beyond the voxels' own, where a steep curve may just begin: parts of the
/// largest extinction that no shadow shows.
double roundingOf(const std::vector<float>& extinctions) {
  return 1e-4 * *std::max_element(extinctions.begin(), extinctions.end());
}

void expectEmptyCellsEmpty(const Cells& cells, const std::vector<glm::vec3>& points, const std::vector<float>& values,
                           const std::string& what) {
  const double rounding = roundingOf(values);
  int wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::ivec3 cell = cellOf(points[i], cells.counts);
    if (cells.at(cell) == 0 || values[i] <= rounding || ++wrong > 3) continue;
    ADD_FAILURE() << what << ": cell " << cell.x << ", " << cell.y << ", " << cell.z << " is called empty, but at "
                  << points[i].x << ", " << points[i].y << ", " << points[i].z << " the extinction is " << values[i];
  }
}

/// A reach of c needs all cells up to c - 1 away to be empty; growing must not change which cells are empty.
void expectReachesEmpty(const Cells& cells, const std::string& what) {
  const glm::ivec3 n = cells.counts;
  for (int i = 0; i < n.x * n.y * n.z; ++i) {
    const glm::ivec3 at(i % n.x, i / n.x % n.y, i / (n.x * n.y));
    const int out = int(cells.reach[i]) - 1;
    for (int z = std::max(at.z - out, 0); z <= std::min(at.z + out, n.z - 1); ++z)
      for (int y = std::max(at.y - out, 0); y <= std::min(at.y + out, n.y - 1); ++y)
        for (int x = std::max(at.x - out, 0); x <= std::min(at.x + out, n.x - 1); ++x)
          ASSERT_GT(cells.at({x, y, z}), 0u) << what << ": the reach " << out + 1 << " of cell " << at.x << ", " << at.y
                                             << ", " << at.z << " takes in cell " << x << ", " << y << ", " << z;
  }
}

class Macrocells : public ::testing::TestWithParam<std::tuple<std::size_t, const char*>> {};

TEST_P(Macrocells, calledEmptyAreEmpty) {
  const TypeRange& range = kTypes[std::get<0>(GetParam())];
  const std::string fetch = std::get<1>(GetParam());
  if (!canFetch(fetch)) GTEST_SKIP() << "the device has no images";
  reference::Random random(std::uint32_t(41 + std::get<0>(GetParam())));
  std::size_t empty = 0, solid = 0;
  for (int kind = 0; kind < kCurves; ++kind)
    for (const glm::uvec3& size : {glm::uvec3(33, 20, 17), glm::uvec3(64, 8, 9), glm::uvec3(1, 40, 3)}) {
      const TestGrid grid = patchyGrid(range, size, random);
      Scene scene = reference::emptyScene();
      reference::addVolume(scene, grid.data, curve(kind, range.low, range.high, random));
      OnDevice onDevice(deviceOf(fetch), scene);
      const Cells cells = onDevice.cells(0, size);
      const std::vector<glm::vec3> points = samplesOf(size, random);
      const std::string what = "curve " + std::to_string(kind) + " on " + std::to_string(size.x) + " voxels";
      expectEmptyCellsEmpty(cells, points, onDevice.extinctions(0, points), what);
      expectReachesEmpty(cells, what);
      for (const std::uint32_t reach : cells.reach) ++(reach ? empty : solid);
    }
  EXPECT_GT(empty, 100u);  // else nothing was tested
  EXPECT_GT(solid, 100u);
}

INSTANTIATE_TEST_SUITE_P(Types, Macrocells,
                         ::testing::Combine(::testing::Range<std::size_t>(0, kTypes.size()),
                                            ::testing::Values("buffer", "image")),
                         [](const auto& instance) {
                           return kTypes[std::get<0>(instance.param)].name + std::string(std::get<1>(instance.param));
                         });

/// A single solid voxel in the middle: the cells that see it, and what their neighbours may skip.
TEST(MacrocellReach, growsAwayFromASolidCell) {
  const glm::uvec3 size(120, 72, 40);
  std::vector<double> voxels(std::size_t(size.x) * size.y * size.z, 0.0);
  voxels[(std::size_t(20) * size.y + 36) * size.x + 60] = 255.0;  // cell (7, 4, 2)
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, makeGrid(VoxelType::UInt8, size, voxels).data,
                       reference::linearOpacity(255.0, 0.5f, 1.0f));
  OnDevice onDevice(deviceOf(), scene);
  const Cells cells = onDevice.cells(0, size);
  expectReachesEmpty(cells, "one voxel");
  for (int x = 0; x < cells.counts.x; ++x) {
    const int distance = std::abs(x - 7);
    const std::uint32_t reach = cells.at({x, 4, 2});
    EXPECT_LE(reach, std::uint32_t(distance)) << x;
    EXPECT_GE(reach, std::uint32_t(std::min(distance, 4))) << x << ": nothing to skip is found";
  }
}

/// Several volumes lie behind each other in one buffer: each keeps its own cells.
TEST(MacrocellReach, ofSeveralVolumesStaysApart) {
  reference::Random random(9);
  Scene scene = reference::emptyScene();
  std::vector<TestGrid> grids;
  const glm::uvec3 sizes[] = {{30, 30, 30}, {9, 17, 70}, {8, 8, 8}};
  for (const glm::uvec3& size : sizes) {
    grids.push_back(patchyGrid(kTypes[grids.size()], size, random));
    reference::addVolume(scene, grids.back().data,
                         curve(3, kTypes[grids.size() - 1].low, kTypes[grids.size() - 1].high, random));
  }
  OnDevice onDevice(deviceOf(), scene);
  for (unsigned i = 0; i < 3; ++i) {
    const Cells cells = onDevice.cells(i, sizes[i]);
    const std::vector<glm::vec3> points = samplesOf(sizes[i], random);
    expectEmptyCellsEmpty(cells, points, onDevice.extinctions(i, points), "volume " + std::to_string(i));
    expectReachesEmpty(cells, "volume " + std::to_string(i));
  }
}

}  // namespace
}  // namespace cdsm::kernels
