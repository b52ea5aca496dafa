// SPDX-License-Identifier: Apache-2.0
// Means and variations of build/curve.clh against sums over all edges in double precision.
#include "build/extinction_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::kernels {
namespace {

using build::ExtinctionCurve;
using shared::float2;
using shared::float4;

const char* const kText = R"(
#include "build/curve.clh"
/// An item per interval of values: mean over the inner, variation over the outer one, of curve number 1.
__kernel void cutCurve(uint count, __global const float4* intervals, __global float2* results,
                       __global const uint2* ranges, __global const float2* corners, __global const float4* sums) {
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  ExtinctionCurve curve = {corners, sums, ranges[1]};
  float4 v = intervals[i];
  CurvePart part = curvePart(&curve, v.x, v.y, v.z, v.w);
  results[i] = (float2)(part.mean, part.variation);
}
)";

/// A wide ramp up to where floats are coarse, and thin peaks and steps behind it.
ExtinctionCurve wideCurve() {
  return build::makeExtinctionCurve({{-3.0f, 0.3f},
                                     {0.0f, 0.0f},
                                     {4000.0f, 0.9f},
                                     {4000.0f, 0.0f},
                                     {4000.5f, 0.99f},
                                     {4001.0f, 0.0f},
                                     {4001.0f, 0.4f},
                                     {4001.25f, 0.4f},
                                     {4002.0f, 0.2f}},
                                    0.5f);
}

/// Lowest, low, high, highest: anywhere or near the thin peaks, wide or narrow, often at corners or of no width.
std::vector<float4> intervals(const ExtinctionCurve& curve) {
  reference::Random random(8);
  const auto anywhere = [&](double width) {
    if (random.integer(0, 3) == 0) return curve[std::size_t(random.integer(0, int(curve.size()) - 1))].x;
    switch (random.integer(0, 2)) {
      case 0:
        return float(random.uniform(-5.0, 4004.0));
      case 1:
        return float(random.uniform(-5.0, 1.0));
      default:
        return float(4000.0 + random.uniform(-width, 2.0 + width));
    }
  };
  std::vector<float4> result;
  for (int i = 0; i < 4000; ++i) {
    const double width = std::exp2(-random.integer(0, 12));
    float ends[4];
    ends[0] = anywhere(width);
    for (int k = 1; k < 4; ++k)
      ends[k] = random.integer(0, 3) == 0 ? ends[k - 1] : ends[k - 1] + float(random.uniform(0.0, width));
    if (random.integer(0, 3) == 0) ends[3] = std::max(ends[3], anywhere(width));
    result.push_back({ends[0], ends[1], ends[2], ends[3]});
  }
  return result;
}

/// Of the edges of a curve within an interval; where it has no width, steps are behind it.
struct Edges {
  double integral = 0.0, variation = 0.0, first = 0.0;
};

Edges edgesWithin(const ExtinctionCurve& curve, double low, double high) {
  const auto at = [&](double value) {  // behind a step
    const auto next = std::find_if(curve.begin(), curve.end(), [=](const float2& c) { return double(c.x) > value; });
    if (next == curve.begin() || next == curve.end()) return double(next == curve.begin() ? next->y : (next - 1)->y);
    const float2 a = *(next - 1), b = *next;
    return a.y + (double(b.y) - a.y) * (value - a.x) / (double(b.x) - a.x);
  };
  Edges edges;
  double from = low, extinction = at(low);
  edges.first = extinction;
  const auto goTo = [&](double value, double reached) {
    edges.integral += 0.5 * (extinction + reached) * (value - from);
    edges.variation += std::abs(reached - extinction);
    from = value;
    extinction = reached;
  };
  for (const float2& corner : curve)
    if (double(corner.x) > low && double(corner.x) <= high) goTo(corner.x, corner.y);
  goTo(high, at(high));
  return edges;
}

std::vector<float2> cutOnDevice(const ExtinctionCurve& curve, const std::vector<float4>& cuts) {
  device::Device& device = deviceOf();
  const build::ExtinctionCurves curves(device, {{{0.0f, 7.0f}, {1.0f, 9.0f}}, curve, {{0.0f, 1.0f}, {2.0f, 3.0f}}});
  const auto in = device::Buffer<float4>::fromHost(device, cuts, "intervals");
  device::Buffer<float2> results(device, cuts.size(), "results");
  device::Kernel<std::uint32_t, device::Buffer<float4>, device::Buffer<float2>, device::ArgumentList> kernel(
      device, testProgram(device, kText), "cutCurve");
  kernel({"cut curve", {cuts.size()}, {kGroup}}, std::uint32_t(cuts.size()), in, results, curves.arguments());
  return results.download();
}

TEST(ExtinctionCurves, haveMeansAndVariationsOfAllTheirEdges) {
  const ExtinctionCurve curve = wideCurve();
  const std::vector<float4> cuts = intervals(curve);
  const std::vector<float2> found = cutOnDevice(curve, cuts);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Edges inner = edgesWithin(curve, cuts[i].y, cuts[i].z), outer = edgesWithin(curve, cuts[i].x, cuts[i].w);
    const double width = double(cuts[i].z) - double(cuts[i].y);
    const double mean = width > 0.0 ? inner.integral / width : inner.first;
    const std::string where = std::to_string(cuts[i].y) + " to " + std::to_string(cuts[i].z);
    // of extinctions up to 9, and of sums of some 50 rises
    ASSERT_NEAR(found[i].x, mean, 2e-5) << where;
    ASSERT_NEAR(found[i].y, outer.variation, 5e-5) << where;
  }
}

}  // namespace
}  // namespace cdsm::kernels
