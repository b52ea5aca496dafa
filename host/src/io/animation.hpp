// SPDX-License-Identifier: Apache-2.0
// [[animate]] of a scene file: a key's numbers as a function of the frame, linear between those given and constant
// outside.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "io/scene_keys.hpp"
#include "io/scene_path.hpp"

namespace cdsm::io {

/// What a key's numbers are at one frame.
struct Keyframe {
  int frame;  ///< in [0, kLastFrame]
  std::vector<double> values;
};

/// `keyframes` ascend, are not empty and have as many values each. At a keyframe exactly its values.
std::vector<double> valuesAt(const std::vector<Keyframe>& keyframes, int frame);

/// One [[animate]] table. What its numbers may be is known only when the scene of a frame is read.
class Animation {
 public:
  /// Checks that `scene` has the key and that the key has as many numbers as the frames. Throws Error with the place.
  Animation(const toml::table& table, toml::table& scene);

  const ScenePath& path() const { return path_; }
  const std::string& pathText() const { return pathText_; }
  /// Of the key's path in the scene file.
  const Location& place() const { return place_; }
  /// The file in the places of the values that apply() makes.
  std::string source() const;

  /// Gives the key its value at that frame.
  void apply(toml::table& scene, int frame) const;

 private:
  std::string pathText_;
  Location place_;
  ScenePath path_;
  KeyShape shape_;
  std::vector<Keyframe> keyframes_;
};

}  // namespace cdsm::io
