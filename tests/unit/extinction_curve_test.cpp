// SPDX-License-Identifier: Apache-2.0
// The polygon of extinctions against -ln(1 - a) / u of the transfer function itself.
#include "build/extinction_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/grid.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::build {
namespace {

double exact(const TransferFunction& transfer, double value) {
  return -std::log1p(-std::min(reference::opacityAt(transfer, value), 0.9999)) /
         static_cast<double>(transfer.unitDistance);
}

double onCurve(const ExtinctionCurve& curve, double value) {
  std::size_t next = 0;
  while (next < curve.size() && double(curve[next].x) <= value) ++next;
  if (next == 0) return double(curve[0].y);
  if (next == curve.size()) return double(curve.back().y);
  const double f = (value - double(curve[next - 1].x)) / (double(curve[next].x) - double(curve[next - 1].x));
  return double(curve[next - 1].y) + f * (double(curve[next].y) - double(curve[next - 1].y));
}

TEST(ExtinctionCurve, FollowsRampsPeaksStepsAndTheCap) {
  TransferFunction transfer = reference::constantOpacity(0.0f, 2.0f);
  transfer.opacity = {{-10.0f, 0.2f}, {0.0f, 0.0f},   {50.0f, 1.0f}, {50.0f, 0.1f},
                      {99.5f, 0.1f},  {100.0f, 0.9f}, {100.5f, 0.0f}};
  const ExtinctionCurve curve = makeExtinctionCurve(transfer.opacity, transfer.unitDistance);
  EXPECT_LT(curve.size(), 600u);
  const double largest = exact(transfer, 49.999);
  for (double value = -12.0; value < 103.0; value += 0.0103)
    EXPECT_NEAR(onCurve(curve, value), exact(transfer, value), 3e-4 * largest) << value;
}

TEST(ExtinctionCurve, AscendsAndKeepsAllPoints) {
  TransferFunction transfer = reference::constantOpacity(0.0f, 1.0f);
  transfer.opacity = {{1.0f, 0.0f}, {1.0000001f, 0.9f}, {1.0000001f, 0.1f}, {3.0f, 0.5f}};
  const ExtinctionCurve curve = makeExtinctionCurve(transfer.opacity, transfer.unitDistance);
  EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a.x < b.x; }));
  for (const TransferFunction::OpacityPoint& point : transfer.opacity)
    EXPECT_TRUE(std::any_of(curve.begin(), curve.end(), [&](const auto& corner) {
      return corner.x == point.value && corner.y == -std::log1p(-point.opacity);
    }));
}

double exactInColor(const TransferFunction& transfer, double value, int channel) {
  return exact(transfer, value) * (1.0 - reference::transmissionAt(transfer, value)[channel]);
}

TEST(AttenuationCurve, FollowsOpacityAndTransmissionTogether) {
  TransferFunction transfer = reference::constantOpacity(0.0f, 2.0f);
  transfer.opacity = {{-10.0f, 0.2f}, {0.0f, 0.0f},   {50.0f, 1.0f}, {50.0f, 0.1f},
                      {99.5f, 0.1f},  {100.0f, 0.9f}, {100.5f, 0.0f}};
  transfer.transmission = {{-12.0f, {0.2f, 1.0f, 0.0f}},
                           {40.0f, {0.9f, 0.0f, 0.0f}},
                           {40.0f, {0.1f, 0.5f, 0.0f}},
                           {102.0f, {1.0f, 0.2f, 0.0f}}};
  TransferFunction steps = reference::constantOpacity(0.0f, 0.4f);
  steps.opacity = {{0.4f, 0.0f}, {0.4f, 0.5f}, {0.7f, 0.1f}};
  steps.transmission = {{0.0f, {0.2f, 0.7f, 1.0f}}, {0.4f, {0.9f, 0.1f, 0.0f}}, {1.0f, {0.3f, 0.6f, 0.5f}}};
  for (int channel = 0; channel < 3; ++channel) {
    const ExtinctionCurve curve = makeAttenuationCurve(transfer, channel), other = makeAttenuationCurve(steps, channel);
    const double largest = exact(transfer, 49.999);
    for (double value = -12.0; value < 103.0; value += 0.0103)
      EXPECT_NEAR(onCurve(curve, value), exactInColor(transfer, value, channel), 3e-4 * largest)
          << value << ", channel " << channel;
    for (double value = -0.1; value < 1.2; value += 0.00103)
      EXPECT_NEAR(onCurve(other, value), exactInColor(steps, value, channel), 5e-4) << value << ", channel " << channel;
    EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a.x < b.x; }));
  }
}

}  // namespace
}  // namespace cdsm::build
