// SPDX-License-Identifier: Apache-2.0
// Interpolation in RGB, HSV, CIELAB and Msh [Moreland 2009, Diverging Color Maps for Scientific Visualization].
#include "io/color_space.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "io/srgb.hpp"

namespace cdsm::io {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// XYZ of the white of sRGB (D65).
const glm::dvec3 kWhite(0.9505, 1.0, 1.0890);
/// IEC 61966-2-1, by columns.
const glm::dmat3 kXyzFromRgb(0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722, 0.9505);

double labRoot(double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; }
double labCube(double t) { return t * t * t > 0.008856 ? t * t * t : (t - 16.0 / 116.0) / 7.787; }

glm::dvec3 labOf(const glm::dvec3& srgb) {
  const glm::dvec3 linear(linearOfSrgb(srgb.r), linearOfSrgb(srgb.g), linearOfSrgb(srgb.b));
  const glm::dvec3 xyz = kXyzFromRgb * linear / kWhite;
  const double x = labRoot(xyz.x), y = labRoot(xyz.y), z = labRoot(xyz.z);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Colours that no display shows are clamped.
glm::dvec3 srgbOfLab(const glm::dvec3& lab) {
  const double y = (lab.x + 16.0) / 116.0;
  const glm::dvec3 xyz = glm::dvec3(labCube(lab.y / 500.0 + y), labCube(y), labCube(y - lab.z / 200.0)) * kWhite;
  const glm::dvec3 linear = glm::clamp(glm::inverse(kXyzFromRgb) * xyz, 0.0, 1.0);
  return {srgbOfLinear(linear.r), srgbOfLinear(linear.g), srgbOfLinear(linear.b)};
}

/// Hue, saturation and value, each 0 .. 1.
glm::dvec3 hsvOf(const glm::dvec3& rgb) {
  const double most = std::max({rgb.r, rgb.g, rgb.b}), least = std::min({rgb.r, rgb.g, rgb.b});
  const double range = most - least;
  if (range <= 0.0) return {0.0, 0.0, most};
  double hue = rgb.r == most   ? (rgb.g - rgb.b) / range
               : rgb.g == most ? 2.0 + (rgb.b - rgb.r) / range
                               : 4.0 + (rgb.r - rgb.g) / range;
  if (hue < 0.0) hue += 6.0;
  return {hue / 6.0, range / most, most};
}

glm::dvec3 rgbOfHsv(const glm::dvec3& hsv) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hsv.x * 6.0, 6.0);
    return hsv.z - hsv.z * hsv.y * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

glm::dvec3 blendRgb(const glm::dvec3& from, const glm::dvec3& to, double part) { return glm::mix(from, to, part); }

glm::dvec3 blendHsv(const glm::dvec3& from, const glm::dvec3& to, double part) {
  return rgbOfHsv(glm::mix(hsvOf(from), hsvOf(to), part));
}

glm::dvec3 blendWrapped(const glm::dvec3& from, const glm::dvec3& to, double part) {
  glm::dvec3 a = hsvOf(from), b = hsvOf(to);
  if (std::abs(a.x - b.x) > 0.5) (a.x > b.x ? b : a).x += 1.0;
  return rgbOfHsv(glm::mix(a, b, part));
}

glm::dvec3 blendLab(const glm::dvec3& from, const glm::dvec3& to, double part) {
  return srgbOfLab(glm::mix(labOf(from), labOf(to), part));
}

/// Magnitude, saturation angle, hue angle.
glm::dvec3 mshOf(const glm::dvec3& lab) {
  const double m = glm::length(lab);
  return {m, m > 0.001 ? std::acos(lab.x / m) : 0.0, std::atan2(lab.z, lab.y)};
}

glm::dvec3 labOfMsh(const glm::dvec3& msh) {
  return msh.x * glm::dvec3(std::cos(msh.y), std::sin(msh.y) * std::cos(msh.z), std::sin(msh.y) * std::sin(msh.z));
}

/// The hue that a colour without saturation gets so that the way from the saturated one looks even.
double hueBeside(const glm::dvec3& saturated, double magnitude) {
  if (saturated.x >= magnitude) return saturated.z;
  const double spin = saturated.y * std::sqrt(magnitude * magnitude - saturated.x * saturated.x) /
                      (saturated.x * std::sin(saturated.y));
  return saturated.z > -kPi / 3.0 ? saturated.z + spin : saturated.z - spin;
}

glm::dvec3 blendDiverging(const glm::dvec3& from, const glm::dvec3& to, double part) {
  constexpr double kSaturated = 0.05, kWhiteMagnitude = 88.0;
  glm::dvec3 a = mshOf(labOf(from)), b = mshOf(labOf(to));
  const double turn = std::abs(a.z - b.z);
  if (a.y > kSaturated && b.y > kSaturated && std::min(turn, 2.0 * kPi - turn) > kPi / 3.0) {
    const glm::dvec3 middle(std::max({a.x, b.x, kWhiteMagnitude}), 0.0, 0.0);
    (part < 0.5 ? b : a) = middle;
    part = part < 0.5 ? 2.0 * part : 2.0 * part - 1.0;
  }
  if (a.y < kSaturated && b.y > kSaturated) a.z = hueBeside(b, a.x);
  if (b.y < kSaturated && a.y > kSaturated) b.z = hueBeside(a, b.x);
  return srgbOfLab(labOfMsh(glm::mix(a, b, part)));
}

/// Each point's colour holds from the point before it.
glm::dvec3 blendStep(const glm::dvec3& from, const glm::dvec3& to, double part) { return part > 0.0 ? to : from; }

}  // namespace

std::optional<ColorBlend> colorBlendOf(std::string_view space) {
  static const std::map<std::string, ColorBlend, std::less<>> blends = {
      {"RGB", blendRgb},  {"HSV", blendHsv},    {"Wrapped", blendWrapped},
      {"Lab", blendLab},  {"CIELAB", blendLab}, {"Diverging", blendDiverging},
      {"Step", blendStep}};
  const auto at = blends.find(space);
  return at == blends.end() ? std::nullopt : std::optional(at->second);
}

}  // namespace cdsm::io
