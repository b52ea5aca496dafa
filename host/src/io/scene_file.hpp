// SPDX-License-Identifier: Apache-2.0
// Scene files: TOML in, a valid Scene with its meshes and volumes out. docs/scene-file.md is the reference of the keys.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::io {

/// Reads a scene file and all files that it names, relative to its own folder; a file used twice is read once and
/// shared. `overrides` are KEY=VALUE with dotted keys (see toml_overrides.hpp), applied in their order before reading.
/// The scene returned passes validate(). Throws Error with file, line and column of the key or value at fault, or with
/// the override's text; an Error of a mesh's or volume's reader keeps the place that the reader gave it.
/// Of an animated scene, this is frame 0.
Scene readScene(const std::string& path, const std::vector<std::string>& overrides = {});

/// The same scene at several frames: the text is parsed and each file read once, and meshes and volumes keep their data
/// from frame to frame, whatever the order. For one thread.
class SceneReader {
 public:
  /// Checks what readScene() checks of the text alone, and the [[animate]] tables' keys and numbers of values. An
  /// override of an animated key is an Error.
  explicit SceneReader(const std::string& path, const std::vector<std::string>& overrides = {});
  ~SceneReader();
  SceneReader(SceneReader&&) noexcept;
  SceneReader& operator=(SceneReader&&) noexcept;

  bool animated() const;

  /// The scene at a frame from 0 on. Throws what readScene() throws; where an animated value is at fault, with the
  /// place of its [[animate]] table and the frame.
  Scene frame(int number);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cdsm::io
