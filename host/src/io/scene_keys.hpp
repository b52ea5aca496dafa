// SPDX-License-Identifier: Apache-2.0
// The tables a scene file may have and the keys of each: the one list of names, which readers, --set and [[animate]]
// share.
#pragma once

#include <string>
#include <vector>

namespace cdsm::io {

inline const std::vector<std::string> kSceneTables{"camera", "image", "shadows", "ambient_occlusion"};
inline const std::vector<std::string> kSceneArrays{"light", "material", "mesh", "volume", "spheres"};
/// Not of the scene itself: how its numbers change from frame to frame.
inline const std::string kAnimateArray = "animate";

/// What a key's value looks like.
enum class KeyShape {
  Text,
  Flag,
  Number,
  Integer,
  Interval,  ///< 2 numbers
  Vector,    ///< 3 numbers
  Rotation,  ///< axis and angle, 4 numbers
  Matrix,    ///< 16 numbers
  Scale,     ///< a number or 3
  Pairs,     ///< rows [value, opacity]
  Quads,     ///< rows [value, r, g, b]
};

struct SceneKey {
  std::string name;
  KeyShape shape;
};

/// Of the tables [kind] or [[kind]], where `kind` is one of kSceneTables or kSceneArrays.
const std::vector<SceneKey>& keysOf(const std::string& kind);
std::vector<std::string> keyNamesOf(const std::string& kind);

}  // namespace cdsm::io
