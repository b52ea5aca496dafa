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

/// Points between which nothing changes, at either end, say nothing that the next ones don't.
template <class Point, class Value>
std::vector<Point> withoutConstantEnds(std::vector<Point> points, Value Point::*value) {
  while (points.size() > 1 && points[0].*value == points[1].*value) points.erase(points.begin());
  while (points.size() > 1 && points.back().*value == points[points.size() - 2].*value) points.pop_back();
  return points;
}

/// The function jumps at its lowest value.
template <class Point>
bool startsWithStep(const std::vector<Point>& points, float low) {
  return points.size() > 1 && points[0].value == low && points[1].value == low;
}

/// Intervals of the table: a multiple of the span where all points have whole values, so that none falls in between.
int intervals(const TransferFunction& transfer, float span) {
  if (!wholeValues(transfer.opacity) || !wholeValues(transfer.shadowOpacity) || !wholeValues(transfer.color) ||
      !wholeValues(transfer.transmission))
    return kMostEntries;
  if (span > kMostWhole) return kMostWhole;
  const int whole = int(span);
  return whole * std::max(1, (kLeastEntries + whole - 1) / whole);
}

}  // namespace

float extinctionOf(float opacity, float unitDistance) {
  // times any way in the world it stays a float
  return std::min(-std::log1p(-std::min(opacity, kMostOpacity)) / unitDistance, 1e28f);
}

TransferTable makeTransferTable(const TransferFunction& given) {
  TransferFunction transfer = given;
  transfer.opacity = withoutConstantEnds(given.opacity, &TransferFunction::OpacityPoint::opacity);
  transfer.shadowOpacity = withoutConstantEnds(given.towardsLights(), &TransferFunction::OpacityPoint::opacity);
  transfer.color = withoutConstantEnds(given.color, &TransferFunction::ColorPoint::color);
  if (given.transmission.empty()) transfer.transmission = {{transfer.color.front().value, glm::vec3(0.0f)}};
  transfer.transmission = withoutConstantEnds(transfer.transmission, &TransferFunction::ColorPoint::color);
  float low = std::min({transfer.opacity.front().value, transfer.shadowOpacity.front().value,
                        transfer.color.front().value, transfer.transmission.front().value});
  const float high = std::max({transfer.opacity.back().value, transfer.shadowOpacity.back().value,
                               transfer.color.back().value, transfer.transmission.back().value});
  int count = high > low ? intervals(transfer, high - low) : 1;
  const float width = high > low ? (high - low) / float(count) : std::max(1e-3f, 1e-5f * std::abs(low));
  const bool step = startsWithStep(transfer.opacity, low) || startsWithStep(transfer.shadowOpacity, low) ||
                    startsWithStep(transfer.color, low) || startsWithStep(transfer.transmission, low);
  if (step) low -= width;  // one entry in front of it
  if (step && high > low + width) ++count;
  TransferTable table;
  table.scale = high > low ? float(count) / (high - low) : 0.0f;
  table.bias = -low * table.scale;
  const auto extinctionAt = [&](const std::vector<TransferFunction::OpacityPoint>& points, float value) {
    return extinctionOf(interpolate(points, value, &TransferFunction::OpacityPoint::opacity), transfer.unitDistance);
  };
  for (int i = 0; i <= count; ++i) {
    const float value = i == count ? high : low + (high - low) * float(i) / float(count);
    const glm::vec3 color = interpolate(transfer.color, value, &TransferFunction::ColorPoint::color);
    table.entries.emplace_back(color, extinctionAt(transfer.opacity, value));
    const float extinction = extinctionAt(transfer.shadowOpacity, value);
    const glm::vec3 absorbed = 1.0f - interpolate(transfer.transmission, value, &TransferFunction::ColorPoint::color);
    table.towardsLights.emplace_back(absorbed * extinction, extinction);
  }
  return table;
}

}  // namespace cdsm::build
