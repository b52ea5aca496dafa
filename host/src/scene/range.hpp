// SPDX-License-Identifier: Apache-2.0
// Allowed ranges of the scene's numbers: one list for the scene file's reader and for scenes made in code.
#pragma once

#include <cfloat>
#include <cstddef>
#include <string>

namespace cdsm::scene {

/// An interval of numbers; NaN lies in none.
struct Range {
  double low;
  double high;
  bool lowOpen = false;   ///< `low` itself is not allowed
  bool highOpen = false;  ///< `high` itself is not allowed
  const char* unit = "";

  bool contains(double value) const {
    return (lowOpen ? value > low : value >= low) && (highOpen ? value < high : value <= high);
  }
  /// "in [1, 8]", "at least 0", "above 0", "a finite number", each with its unit.
  std::string text() const;
};

inline constexpr Range kAnyNumber{-FLT_MAX, FLT_MAX};
/// Wide enough for any scene, narrow enough that the square of a squared length is still a float.
inline constexpr Range kCoordinate{-1e9, 1e9, false, false, "world units"};
inline constexpr Range kNotNegative{0.0, FLT_MAX};
inline constexpr Range kPositive{0.0, FLT_MAX, true};
inline constexpr Range kUnitInterval{0.0, 1.0};
inline constexpr Range kFov{0.0, 180.0, true, true, "degrees"};
inline constexpr Range kCutoff{0.0, 90.0, true, true, "degrees"};
inline constexpr Range kImageSide{1, 16384, false, false, "pixels"};
inline constexpr Range kMapSize{8, 16384, false, false, "texels"};
inline constexpr Range kMaxNodes{2, 256, false, false, "nodes"};
inline constexpr Range kSupersampling{1, 8};
inline constexpr Range kTolerance{0.0, 1.0, false, true};
/// Numbers of triangles and spheres have two bits for other things, numbers of vertices none.
constexpr std::size_t kMostPrimitives = std::size_t(1) << 30, kMostVertices = std::size_t(1) << 32;

/// With tolerance mode "everywhere": single precision could not keep less.
inline constexpr Range kToleranceEverywhere{0.001, 1.0, false, true};
/// With node format "unorm16": transmittances are stored to 1 / 65535, and what is left must be worth compressing to.
inline constexpr Range kToleranceUnorm16{double(2e-5f), 1.0, false, true};
/// Nothing is more opaque than 1.
inline constexpr Range kThreshold{0.0, 1.0, false, true};
inline constexpr Range kPcf{0, 16, false, false, "texels"};
inline constexpr Range kSamples{7, 21};
inline constexpr Range kPatch{0, 64, false, false, "texels"};
inline constexpr Range kSeed{0, 999999};
inline constexpr Range kClusters{1, 64};
/// Up to the diagonal of the square [-1, 1], 2 sqrt(2), rounded up: nothing in it is farther apart.
inline constexpr Range kClusterDistance{0.0, 2.83, true};
inline constexpr Range kClusterWeight{0.0, 1000.0, true};

inline constexpr Range kDirections{4, 256};
inline constexpr Range kOcclusionDistance{0.0, 2.0, true, false, "longest sides of the box around the spheres"};
/// Cells along the longest side; 0: chosen by the engine.
inline constexpr Range kOcclusionResolution{8, 256, false, false, "cells"};

/// A number as messages show it: seven significant digits.
std::string formatNumber(double value);

/// Throws Error "WHAT is VALUE, must be RANGE".
void requireRange(double value, const Range& range, const std::string& what);

}  // namespace cdsm::scene
