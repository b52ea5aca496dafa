// SPDX-License-Identifier: Apache-2.0
// Files of a scene, each read once; see scene_parts.hpp.
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "io/mesh_file.hpp"
#include "io/scene_parts.hpp"
#include "io/volume_file.hpp"

namespace cdsm::io {
namespace {

namespace fs = std::filesystem;

/// Reads through `cache`, where names that lead to the same file, and to the same `part` of it, share an entry.
template <typename Data, typename Read>
std::shared_ptr<const Data> readOnce(std::map<AssetKey, std::shared_ptr<const Data>>& cache, const std::string& folder,
                                     const std::string& file, const std::string& part, Read read) {
  const fs::path path = fs::path(folder) / file;
  std::error_code failed;
  const fs::path canonical = fs::weakly_canonical(path, failed);
  std::shared_ptr<const Data>& entry = cache[{failed ? path.string() : canonical.string(), part}];
  if (!entry) entry = read(path.string());
  return entry;
}

}  // namespace

std::string AssetCache::pathOf(const std::string& file) const { return (fs::path(folder_) / file).string(); }

std::shared_ptr<const MeshData> AssetCache::mesh(const std::string& file) {
  return readOnce(meshes_, folder_, file, "", [](const std::string& path) { return readMesh(path); });
}

std::shared_ptr<const VolumeData> AssetCache::volume(const std::string& file, const VolumePart& part) {
  return readOnce(volumes_, folder_, file, part.grid + part.array,
                  [&](const std::string& path) { return readVolume(path, part); });
}

std::shared_ptr<const SphereData> AssetCache::spheres(const std::string& file, const SphereLook& look) {
  const auto molecule =
      readOnce(molecules_, folder_, file, "", [](const std::string& path) { return readMolecule(path); });
  std::weak_ptr<const SphereData>& entry = spheres_[{molecule.get(), look.key()}];
  std::shared_ptr<const SphereData> spheres = entry.lock();
  if (!spheres) entry = spheres = makeSpheres(*molecule, look);
  return spheres;
}

}  // namespace cdsm::io
