// SPDX-License-Identifier: Apache-2.0
// Curves of presets as points; see preset_file.hpp.
#include "io/preset_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <cdsm/error.hpp>

#include "io/color_space.hpp"
#include "io/input_file.hpp"
#include "io/preset_points.hpp"
#include "io/srgb.hpp"
#include "io/text_numbers.hpp"
#include "scene/range.hpp"

namespace cdsm::io {

namespace {

using scene::formatNumber;

/// Greatest difference between a curve and its points, in a channel of linear RGB or in opacity.
constexpr double kExactness = 1.0 / 2048.0;
constexpr int kMostHalvings = 8;

/// A curve over 0 .. 1: a colour, or an opacity in all three channels.
using Curve = std::function<glm::dvec3(double)>;

/// Calls put(part, value) for points between, but not at, 0 and 1: halves until the middle and the quarters of each
/// stretch are met.
template <typename Put>
void follow(const Curve& curve, double from, double to, int halvings, const Put& put) {
  const glm::dvec3 first = curve(from), last = curve(to);
  double error = 0.0;
  for (const double part : {0.25, 0.5, 0.75}) {
    const glm::dvec3 gap = glm::abs(curve(glm::mix(from, to, part)) - glm::mix(first, last, part));
    error = std::max({error, gap.x, gap.y, gap.z});
  }
  if (error <= kExactness || halvings == kMostHalvings) return;
  const double middle = 0.5 * (from + to);
  follow(curve, from, middle, halvings + 1, put);
  put(middle, curve(middle));
  follow(curve, middle, to, halvings + 1, put);
}

/// How a preset's values become those of the volume.
struct Stretch {
  double low = 0.0, scale = 1.0, offset = 0.0;

  float operator()(double value) const { return static_cast<float>(offset + (value - low) * scale); }
};

glm::dvec3 linearColor(const glm::dvec3& srgb) {
  return {linearOfSrgb(srgb.r), linearOfSrgb(srgb.g), linearOfSrgb(srgb.b)};
}

/// What VTK makes of midpoint and sharpness: straight at 0, a Hermite curve up to nearly a step at 1. `part` is 0 .. 1
/// of the way from one opacity to the next; so is the answer.
double sharpened(double part, double midpoint, double sharpness) {
  const double bent = part < midpoint ? 0.5 * part / midpoint : 0.5 + 0.5 * (part - midpoint) / (1.0 - midpoint);
  if (sharpness < 0.01) return bent;
  const double power = 1.0 + 10.0 * sharpness;
  const double s = bent < 0.5 ? 0.5 * std::pow(2.0 * bent, power) : 1.0 - 0.5 * std::pow(2.0 - 2.0 * bent, power);
  const double tangent = 1.0 - sharpness;
  const double hermite = s * s * (3.0 - 2.0 * s) + tangent * (s * (1.0 - s) * (1.0 - s) - s * s * (1.0 - s));
  return std::clamp(hermite, 0.0, 1.0);
}

void addColors(const PresetPoints& points, ColorBlend blend, bool step, const Stretch& stretch,
               TransferFunction& transfer) {
  const auto put = [&](double value, const glm::dvec3& linear) {
    transfer.color.push_back({stretch(value), glm::vec3(linear)});
  };
  for (std::size_t i = 0; i < points.color.size(); ++i) {
    const auto& to = points.color[i];
    const auto& from = points.color[i == 0 ? 0 : i - 1];
    const Curve curve = [&](double part) { return linearColor(blend(from.srgb, to.srgb, part)); };
    if (step && i > 0)
      put(from.value, linearColor(to.srgb));
    else
      follow(curve, 0.0, 1.0, 0, [&](double part, const auto& c) { put(glm::mix(from.value, to.value, part), c); });
    put(to.value, linearColor(to.srgb));
  }
}

void addOpacities(const PresetPoints& points, const Stretch& stretch, TransferFunction& transfer) {
  const auto put = [&](double value, double opacity) {
    transfer.opacity.push_back({stretch(value), static_cast<float>(opacity)});
  };
  for (std::size_t i = 0; i < points.opacity.size(); ++i) {
    const auto& from = points.opacity[i];
    put(from.value, from.opacity);
    if (i + 1 == points.opacity.size()) break;
    const auto& to = points.opacity[i + 1];
    const Curve curve = [&](double part) {
      return glm::dvec3(glm::mix(from.opacity, to.opacity, sharpened(part, from.midpoint, from.sharpness)));
    };
    const auto putPart = [&](double part, const glm::dvec3& opacity) {
      put(glm::mix(from.value, to.value, part), opacity.x);
    };
    follow(curve, 0.0, from.midpoint, 0, putPart);
    if (from.midpoint != 0.5 || from.sharpness >= 0.01) putPart(from.midpoint, curve(from.midpoint));
    follow(curve, from.midpoint, 1.0, 0, putPart);
  }
}

void checkNumber(const std::string& path, const char* what, double value, const scene::Range& range) {
  if (!range.contains(value))
    throw Error(Location{path}, std::string(what) + " is " + formatNumber(value) + ", must be " + range.text());
}

template <typename Points>
void checkAscending(const std::string& path, const char* what, const Points& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    checkNumber(path, what, points[i].value, scene::kAnyNumber);
    if (i > 0 && points[i].value < points[i - 1].value)
      throw Error(Location{path}, std::string(what) + " " + formatNumber(points[i].value) + " follows " +
                                      formatNumber(points[i - 1].value) + ", must be ascending");
  }
}

void checkPoints(const std::string& path, const PresetPoints& points) {
  if (points.color.empty()) throw Error(Location{path}, "has no points of colour, must have at least one");
  checkAscending(path, "value of a colour", points.color);
  checkAscending(path, "value of an opacity", points.opacity);
  for (const auto& point : points.color)
    for (int channel = 0; channel < 3; ++channel)
      checkNumber(path, "colour", point.srgb[channel], scene::kUnitInterval);
  for (const auto& point : points.opacity) {
    checkNumber(path, "opacity", point.opacity, scene::kUnitInterval);
    checkNumber(path, "sharpness", point.sharpness, scene::kUnitInterval);
    checkNumber(path, "midpoint", point.midpoint, scene::kUnitInterval);
    if (point.midpoint == 0.0 || point.midpoint == 1.0)
      throw Error(Location{path}, "midpoint is " + formatNumber(point.midpoint) + ", must be between 0 and 1");
  }
}

Stretch stretchOf(const std::string& path, const PresetPoints& points,
                  const std::optional<std::pair<double, double>>& range) {
  if (!range) return {};
  const double low = points.color.front().value, high = points.color.back().value;
  if (low == high) throw Error(Location{path}, "has one value of colour alone, which no range can stretch");
  return {low, (range->second - range->first) / (high - low), range->first};
}

}  // namespace

TransferFunction readPreset(const std::string& path, const std::optional<std::pair<double, double>>& range) {
  const bool json = hasEnding(path, ".json");
  if (!json && !hasEnding(path, ".xml"))
    throw Error(Location{path}, "is not known as a preset by its ending; ParaView's are .json or .xml");
  const PresetPoints points = json ? readPresetJson(path) : readPresetXml(path);
  checkPoints(path, points);
  const std::optional<ColorBlend> blend = colorBlendOf(points.space);
  if (!blend)
    throw Error(Location{path}, "has the colour space " + quoted(points.space) +
                                    "; RGB, HSV, Wrapped, Lab, CIELAB, Diverging and Step are read");
  const Stretch stretch = stretchOf(path, points, range);
  TransferFunction transfer;
  addColors(points, *blend, points.space == "Step", stretch, transfer);
  addOpacities(points, stretch, transfer);
  return transfer;
}

}  // namespace cdsm::io
