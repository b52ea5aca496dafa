// SPDX-License-Identifier: Apache-2.0
// The parts of a scene file, one function per table; scene_file.cpp puts them together.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <toml++/toml.h>

#include <cdsm/scene.hpp>

#include "io/molecule_file.hpp"
#include "io/sphere_look.hpp"
#include "io/toml_reader.hpp"
#include "io/volume_file.hpp"
#include "scene/data_checks.hpp"

namespace cdsm::io {

/// A file, and what of it.
using AssetKey = std::pair<std::string, std::string>;

/// Mesh, volume and molecule files by what they really are on disk: each is read once.
class AssetCache {
 public:
  /// `folder` is what relative names start from: the scene file's.
  explicit AssetCache(std::string folder) : folder_(std::move(folder)) {}

  /// Where a file of the scene lies.
  std::string pathOf(const std::string& file) const;

  std::shared_ptr<const MeshData> mesh(const std::string& file);
  std::shared_ptr<const VolumeData> volume(const std::string& file, const VolumePart& part);
  /// The same data as long as they are in use for a file and a look, which may change from frame to frame.
  std::shared_ptr<const SphereData> spheres(const std::string& file, const SphereLook& look);

  /// Of these files' data.
  scene::DataChecks& checks() { return checks_; }

 private:
  std::string folder_;
  std::map<AssetKey, std::shared_ptr<const MeshData>> meshes_;
  std::map<AssetKey, std::shared_ptr<const VolumeData>> volumes_;
  std::map<AssetKey, std::shared_ptr<const Molecule>> molecules_;
  std::map<std::pair<const Molecule*, std::array<float, 6>>, std::weak_ptr<const SphereData>> spheres_;  ///< by look
  scene::DataChecks checks_;
};

Camera readCamera(const toml::table& table);
ImageSettings readImageSettings(const toml::table& table);
ShadowSettings readShadows(const toml::table& table);
AmbientOcclusion readOcclusion(const toml::table& table);

Light readLight(const toml::table& table);
Material readMaterial(const toml::table& table);
/// `scene` has its materials.
Mesh readMeshTable(const toml::table& table, const Scene& scene, AssetCache& assets);
/// `scene` has its meshes.
Volume readVolumeTable(const toml::table& table, const Scene& scene, AssetCache& assets);
/// `scene` has its materials.
Spheres readSpheresTable(const toml::table& table, const Scene& scene, AssetCache& assets);

}  // namespace cdsm::io
