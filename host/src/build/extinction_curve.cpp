// SPDX-License-Identifier: Apache-2.0
#include "build/extinction_curve.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "build/transfer_table.hpp"

namespace cdsm::build {

namespace {

using Point = TransferFunction::OpacityPoint;
using Colors = std::vector<TransferFunction::ColorPoint>;

constexpr float kRelativeError = 2e-4f;
constexpr float kOpaque = 0.9999f;  ///< opacities are capped here [INTERFACE, 4.2]
constexpr int kMostHalvings = 20;

/// Opacity at a value, and the part of the light absorbed where it interacts; both linear up to the next one.
struct Corner {
  float value, opacity, absorbed;
};

Corner between(const Corner& from, const Corner& to, float part) {
  const auto mix = [part](float a, float b) { return a + part * (b - a); };
  return {mix(from.value, to.value), mix(from.opacity, to.opacity), mix(from.absorbed, to.absorbed)};
}

float attenuationOf(const Corner& corner, float unitDistance) {
  return corner.absorbed * extinctionOf(corner.opacity, unitDistance);
}

/// Opacity is linear between two corners, extinction is not: halves until it is nearly so. Adds all corners but the
/// first.
void addEdge(ExtinctionCurve& curve, const Corner& from, const Corner& to, float unitDistance, int halvings) {
  const Corner middle = between(from, to, 0.5f);
  const float first = attenuationOf(from, unitDistance), last = attenuationOf(to, unitDistance);
  const float bend = std::abs(attenuationOf(middle, unitDistance) - 0.5f * (first + last));
  const bool apart = middle.value > from.value && middle.value < to.value;
  if (!apart || halvings == 0 || bend <= kRelativeError * std::max(first, last)) {
    curve.push_back({to.value, last});
    return;
  }
  addEdge(curve, from, middle, unitDistance, halvings - 1);
  addEdge(curve, middle, to, unitDistance, halvings - 1);
}

/// The corners, with one more wherever an edge gets to the cap.
std::vector<Corner> cappedCorners(const std::vector<Corner>& corners) {
  std::vector<Corner> capped;
  for (const Corner& corner : corners) {
    if (!capped.empty() && (capped.back().opacity > kOpaque) != (corner.opacity > kOpaque)) {
      const Corner before = capped.back();
      capped.push_back(between(before, corner, (kOpaque - before.opacity) / (corner.opacity - before.opacity)));
      capped.back().opacity = kOpaque;
    }
    capped.push_back(corner);
  }
  return capped;
}

ExtinctionCurve curveOf(const std::vector<Corner>& corners, float unitDistance) {
  const std::vector<Corner> capped = cappedCorners(corners);
  ExtinctionCurve curve{{capped[0].value, attenuationOf(capped[0], unitDistance)}};
  for (std::size_t i = 1; i < capped.size(); ++i) addEdge(curve, capped[i - 1], capped[i], unitDistance, kMostHalvings);
  return curve;
}

/// The points on both sides of the one where a function of points gets to `value`: from below, or (`behind`) from
/// above.
template <class Made>
std::pair<Made, Made> around(const std::vector<Made>& points, float value, bool behind) {
  const auto next = std::find_if(points.begin(), points.end(), [=](const Made& point) {
    return behind ? point.value > value : point.value >= value;
  });
  if (next == points.end()) return {points.back(), points.back()};
  return {next == points.begin() ? *next : *(next - 1), *next};
}

/// How far `value` is on the way between two points.
template <class Made>
float partOf(const std::pair<Made, Made>& ends, float value) {
  const float span = ends.second.value - ends.first.value;
  return span > 0.0f ? std::clamp((value - ends.first.value) / span, 0.0f, 1.0f) : 0.0f;
}

Corner cornerAt(const std::vector<Point>& opacity, const Colors& transmission, int channel, float value, bool behind) {
  const auto opacities = around(opacity, value, behind);
  const auto colors = around(transmission, value, behind);
  const auto mix = [](float a, float b, float part) { return a + part * (b - a); };
  return {value, mix(opacities.first.opacity, opacities.second.opacity, partOf(opacities, value)),
          1.0f - mix(colors.first.color[channel], colors.second.color[channel], partOf(colors, value))};
}

/// For each corner what kernels/build/curve.clh says. The first float of an integral lacks what rounding took, the
/// second is that.
void addSums(std::vector<shared::float4>& sums, const ExtinctionCurve& curve) {
  double integral = 0.0, variation = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (i > 0) {
      const double first = curve[i - 1].y, last = curve[i].y;
      integral += 0.5 * (first + last) * (double(curve[i].x) - double(curve[i - 1].x));
      variation += std::abs(last - first);
    }
    const auto whole = float(integral);
    sums.push_back({whole, float(integral - double(whole)), float(variation), 0.0f});
  }
}

}  // namespace

ExtinctionCurve makeExtinctionCurve(const std::vector<Point>& opacity, float unitDistance) {
  std::vector<Corner> corners;
  for (const Point& point : opacity) corners.push_back({point.value, point.opacity, 1.0f});
  return curveOf(corners, unitDistance);
}

ExtinctionCurve makeAttenuationCurve(const TransferFunction& transfer, int channel) {
  const std::vector<Point>& opacity = transfer.towardsLights();
  if (transfer.transmission.empty()) return makeExtinctionCurve(opacity, transfer.unitDistance);
  std::set<float> values;
  for (const Point& point : opacity) values.insert(point.value);
  for (const TransferFunction::ColorPoint& point : transfer.transmission) values.insert(point.value);
  std::vector<Corner> corners;
  for (const float value : values)
    for (const bool behind : {false, true})
      corners.push_back(cornerAt(opacity, transfer.transmission, channel, value, behind));
  return curveOf(corners, transfer.unitDistance);
}

ExtinctionCurves::ExtinctionCurves(device::Device& device, const std::vector<ExtinctionCurve>& curves) {
  std::vector<shared::uint2> ranges;
  std::vector<shared::float2> corners;
  std::vector<shared::float4> sums;
  for (const ExtinctionCurve& curve : curves) {
    const auto first = shared::uint(corners.size());
    corners.insert(corners.end(), curve.begin(), curve.end());
    addSums(sums, curve);
    ranges.push_back({first, shared::uint(corners.size())});
  }
  ranges_ = device::Buffer<shared::uint2>::fromHost(device, ranges, "ranges of extinction curves");
  corners_ = device::Buffer<shared::float2>::fromHost(device, corners, "extinction curves");
  sums_ = device::Buffer<shared::float4>::fromHost(device, sums, "sums of extinction curves");
}

}  // namespace cdsm::build
