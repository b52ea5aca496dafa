// SPDX-License-Identifier: Apache-2.0
// Transfer tables as the device reads them against the exact curves: opacity linear between its points, as extinction;
// colour linear between its points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "build/transfer_table.hpp"
#include "kernel_test.hpp"
#include "reference/grid.hpp"
#include "test_volumes.hpp"

namespace cdsm::kernels {
namespace {

const char* const kText = R"(
#include "common/medium.clh"
/// An item per value: extinction alone, and colour with extinction in w.
__kernel void lookUp(uint count, __global const float* values, __global float* extinctions, __global float4* colors,
                     CDSM_SCENE_PARAMS) {
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  MediumData m = media[0];
  extinctions[i] = lutExtinction(extinctionLut, &m, values[i]);
  colors[i] = lutColor(colorLut, &m, values[i]);
}
)";

using Floats = device::Buffer<float>;

struct LookedUp {
  std::vector<float> extinctions;
  std::vector<shared::float4> colors;
};

LookedUp lookUp(const TransferFunction& transfer, const std::vector<float>& values) {
  device::Device& device = deviceOf();
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, makeGrid(VoxelType::UInt8, {1, 1, 1}, {0.0}).data, transfer);
  build::DeviceScene onDevice(device);
  onDevice.update(scene);
  const Floats in = Floats::fromHost(device, values, "values");
  Floats extinctions(device, values.size(), "extinctions");
  device::Buffer<shared::float4> colors(device, values.size(), "colours");
  const device::Buffer<std::uint32_t> around(device, 0, "around");
  device::Kernel<std::uint32_t, Floats, Floats, device::Buffer<shared::float4>, device::ArgumentList> kernel(
      device, sceneTestProgram(device, onDevice, kText), "lookUp");
  kernel({"look up", {values.size()}, {kGroup}}, std::uint32_t(values.size()), in, extinctions, colors,
         onDevice.arguments(onDevice.allObjects(), around));
  return {extinctions.download(), colors.download()};
}

double exactExtinction(const TransferFunction& transfer, double value) {
  return -std::log1p(-std::min(reference::opacityAt(transfer, value), 0.9999)) / transfer.unitDistance;
}

/// The points themselves, beside them, beyond the ends, and evenly between.
std::vector<float> probes(const TransferFunction& transfer) {
  const float low = transfer.opacity.front().value, high = transfer.opacity.back().value, span = high - low;
  std::vector<float> values{low - 1000.0f, high + 1000.0f, low - span, high + span};
  for (const auto& point : transfer.opacity)
    for (const float beside : {0.0f, -1e-4f, 1e-4f}) values.push_back(point.value + beside * span);
  for (int i = 0; i <= 3000; ++i) values.push_back(low - 0.05f * span + 1.1f * span * float(i) / 3000.0f);
  return values;
}

/// Least and greatest exact extinction within one entry of the table around a value; the curve's points are looked at,
/// between them it rises or falls.
std::pair<double, double> rangeAround(const TransferFunction& transfer, double value, double entry) {
  double least = exactExtinction(transfer, value - entry), most = least;
  const auto add = [&](double at) {
    const double extinction = exactExtinction(transfer, at);
    least = std::min(least, extinction);
    most = std::max(most, extinction);
  };
  add(value + entry);
  for (const auto& point : transfer.opacity)
    if (std::abs(point.value - value) <= entry) {
      add(point.value);
      add(std::nextafter(double(point.value), -1e30));
    }
  return {least, most};
}

struct Curve {
  std::string name;
  TransferFunction transfer;
};

Curve curve(const std::string& name, float unit, std::vector<TransferFunction::OpacityPoint> points) {
  Curve result{name, reference::constantOpacity(0.0f, unit)};
  result.transfer.opacity = std::move(points);
  return result;
}

std::vector<Curve> curves() {
  return {curve("Bytes", 0.5f, {{0, 0}, {40, 0}, {41, 0.6f}, {42, 0}, {200, 0.2f}, {255, 0.9f}}),
          curve("Words", 2.0f, {{-32768, 0.3f}, {-100, 0}, {100, 0}, {101, 1.0f}, {32767, 0}}),
          curve("Fractions", 1.0f, {{-0.3f, 0}, {0.1234f, 0.5f}, {0.5678f, 0.1f}, {1.7f, 0.8f}}),
          curve("ThinPeak", 1.0f, {{0.0f, 0}, {0.5f, 0}, {0.50005f, 0.9f}, {0.5001f, 0}, {1.0f, 0}}),
          curve("Step", 1.0f, {{0, 0.1f}, {7, 0.1f}, {7, 0.7f}, {20, 0.7f}}),
          curve("Opaque", 1.0f, {{0, 0}, {10, 1.0f}}),
          curve("OnePoint", 1.0f, {{5, 0.4f}}),
          curve("Hounsfield", 1.0f, {{-1024, 0}, {150, 0}, {151, 0.01f}, {3071, 0.9f}})};
}

class TransferTables : public ::testing::TestWithParam<std::size_t> {
 protected:
  Curve curve_ = curves()[GetParam()];
  std::vector<float> values_ = probes(curve_.transfer);
  LookedUp looked_ = lookUp(curve_.transfer, values_);
};

TEST_P(TransferTables, lieWithinTheCurveAroundAValue) {
  const build::TransferTable table = build::makeTransferTable(curve_.transfer);
  const double entry = table.scale > 0.0f ? 1.0001 / table.scale : 1e-6;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    // the value itself is a float, and its coordinate is rounded at the size of the table
    const double rounding = 2e-7 * std::abs(values_[i]) + 1e-3 * entry;
    const auto [least, most] = rangeAround(curve_.transfer, values_[i], entry + rounding);
    const double slack = 2e-5 * (1.0 + most);  // 1 - 0.9999 has four digits as a float
    EXPECT_GE(looked_.extinctions[i], least - slack) << curve_.name << " at " << values_[i];
    EXPECT_LE(looked_.extinctions[i], most + slack) << curve_.name << " at " << values_[i];
    EXPECT_NEAR(looked_.colors[i].w, looked_.extinctions[i], slack) << curve_.name << " at " << values_[i];
  }
}

TEST_P(TransferTables, areExactAtPointsWithWholeValues) {
  const auto& points = curve_.transfer.opacity;
  const auto isWhole = [](const auto& p) { return p.value == std::floor(p.value); };
  if (!std::all_of(points.begin(), points.end(), isWhole) || points.back().value - points.front().value > 8192.0f)
    return;  // its points lie between entries of the table, which the test above allows for
  std::vector<float> values;
  for (const auto& point : points) values.push_back(point.value);
  const LookedUp looked = lookUp(curve_.transfer, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double exact = exactExtinction(curve_.transfer, values[i]);
    EXPECT_NEAR(looked.extinctions[i], exact, 1e-4 * (1.0 + exact)) << curve_.name << " at " << values[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Curves, TransferTables, ::testing::Range<std::size_t>(0, curves().size()),
                         [](const auto& instance) { return curves()[instance.param].name; });

TEST(TransferColors, areLinearBetweenTheirPoints) {
  TransferFunction transfer = reference::constantOpacity(0.5f, 1.0f);
  transfer.opacity = {{0, 0.5f}, {255, 0.5f}};
  transfer.color = {{10, {1.0f, 0.0f, 0.5f}}, {100, {0.0f, 0.25f, 1.0f}}, {200, {0.5f, 0.5f, 0.0f}}};
  const std::vector<float> values = probes(transfer);
  const LookedUp looked = lookUp(transfer, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::dvec3 exact = reference::colorAt(transfer, values[i]);
    EXPECT_NEAR(looked.colors[i].x, exact.x, 1e-5) << values[i];
    EXPECT_NEAR(looked.colors[i].y, exact.y, 1e-5) << values[i];
    EXPECT_NEAR(looked.colors[i].z, exact.z, 1e-5) << values[i];
  }
}

}  // namespace
}  // namespace cdsm::kernels
