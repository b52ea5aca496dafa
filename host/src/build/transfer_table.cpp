// SPDX-License-Identifier: Apache-2.0
#include "build/transfer_table.hpp"

#include <algorithm>
#include <cmath>

namespace cdsm::build {

namespace {

constexpr int kLeastEntries = 1024;
constexpr int kMostEntries = 8192;
constexpr int kMostWhole = 65536;  ///< of 16-bit data every value has an entry

/// Linear between the points, constant outside; at a step the value after it.
template <class Point, class Value>
Value interpolate(const std::vector<Point>& points, float at, Value Point::*value) {
  const auto after =
      std::upper_bound(points.begin(), points.end(), at, [](float v, const Point& point) { return v < point.value; });
  if (after == points.begin()) return points.front().*value;
  if (after == points.end()) return points.back().*value;
  const Point& low = *(after - 1);
  const Point& high = *after;
  return low.*value + (high.*value - low.*value) * ((at - low.value) / (high.value - low.value));
}

template <class Point>
bool wholeValues(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point& p) { return p.value == std::floor(p.value); });
}

/// Intervals of the table: a multiple of the span where all points have whole values, so that none falls in between.
int intervals(const TransferFunction& transfer, float span) {
  if (!wholeValues(transfer.opacity) || !wholeValues(transfer.color)) return kMostEntries;
  if (span > kMostWhole) return kMostWhole;
  const int whole = int(span);
  return whole * std::max(1, (kLeastEntries + whole - 1) / whole);
}

}  // namespace

float extinctionOf(float opacity, float unitDistance) {
  return -std::log1p(-std::min(opacity, 0.9999f)) / unitDistance;
}

TransferTable makeTransferTable(const TransferFunction& transfer) {
  const float low = std::min(transfer.opacity.front().value, transfer.color.front().value);
  const float high = std::max(transfer.opacity.back().value, transfer.color.back().value);
  const int count = high > low ? intervals(transfer, high - low) : 1;
  TransferTable table;
  table.scale = high > low ? float(count) / (high - low) : 0.0f;
  table.bias = -low * table.scale;
  for (int i = 0; i <= count; ++i) {
    const float value = low + (high - low) * float(i) / float(count);
    const float opacity = interpolate(transfer.opacity, value, &TransferFunction::OpacityPoint::opacity);
    const glm::vec3 color = interpolate(transfer.color, value, &TransferFunction::ColorPoint::color);
    table.entries.emplace_back(color, extinctionOf(opacity, transfer.unitDistance));
  }
  return table;
}

}  // namespace cdsm::build
