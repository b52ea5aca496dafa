// SPDX-License-Identifier: Apache-2.0
#include "build/extinction_curve.hpp"

#include <algorithm>
#include <cmath>

#include "build/transfer_table.hpp"

namespace cdsm::build {

namespace {

using Point = TransferFunction::OpacityPoint;

constexpr float kRelativeError = 2e-4f;
constexpr float kOpaque = 0.9999f;  ///< opacities are capped here [INTERFACE, 4.2]
constexpr int kMostHalvings = 20;

/// Opacity is linear between two points, extinction is not: halves until it is nearly so. Adds all corners but the
/// first.
void addEdge(ExtinctionCurve& curve, const Point& from, const Point& to, float unitDistance, int halvings) {
  const Point middle{0.5f * from.value + 0.5f * to.value, 0.5f * (from.opacity + to.opacity)};
  const float first = extinctionOf(from.opacity, unitDistance), last = extinctionOf(to.opacity, unitDistance);
  const float bend = std::abs(extinctionOf(middle.opacity, unitDistance) - 0.5f * (first + last));
  const bool apart = middle.value > from.value && middle.value < to.value;
  if (!apart || halvings == 0 || bend <= kRelativeError * std::max(first, last)) {
    curve.push_back({to.value, last});
    return;
  }
  addEdge(curve, from, middle, unitDistance, halvings - 1);
  addEdge(curve, middle, to, unitDistance, halvings - 1);
}

/// The points, with one more wherever an edge gets to the cap.
std::vector<Point> cappedPoints(const std::vector<Point>& points) {
  std::vector<Point> capped;
  for (const Point& point : points) {
    if (!capped.empty() && (capped.back().opacity > kOpaque) != (point.opacity > kOpaque)) {
      const Point& before = capped.back();
      const float share = (kOpaque - before.opacity) / (point.opacity - before.opacity);
      capped.push_back({before.value + share * (point.value - before.value), kOpaque});
    }
    capped.push_back(point);
  }
  return capped;
}

}  // namespace

ExtinctionCurve makeExtinctionCurve(const std::vector<Point>& opacity, float unitDistance) {
  const std::vector<Point> points = cappedPoints(opacity);
  ExtinctionCurve curve{{points[0].value, extinctionOf(points[0].opacity, unitDistance)}};
  for (std::size_t i = 1; i < points.size(); ++i) addEdge(curve, points[i - 1], points[i], unitDistance, kMostHalvings);
  return curve;
}

ExtinctionCurves::ExtinctionCurves(device::Device& device, const std::vector<ExtinctionCurve>& curves) {
  std::vector<shared::uint2> ranges;
  std::vector<shared::float2> corners;
  for (const ExtinctionCurve& curve : curves) {
    const auto first = shared::uint(corners.size());
    corners.insert(corners.end(), curve.begin(), curve.end());
    ranges.push_back({first, shared::uint(corners.size())});
  }
  ranges_ = device::Buffer<shared::uint2>::fromHost(device, ranges, "ranges of extinction curves");
  corners_ = device::Buffer<shared::float2>::fromHost(device, corners, "extinction curves");
}

}  // namespace cdsm::build
