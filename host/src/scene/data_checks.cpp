// SPDX-License-Identifier: Apache-2.0
#include "scene/data_checks.hpp"

#include "scene/closed_mesh.hpp"
#include "scene/validate.hpp"

namespace cdsm::scene {

namespace {

/// Whether somebody could have written to them without a word so that reading them is no longer safe.
bool isWrittenUnseen(const MeshData& data) { return data.triangles.isView(); }
bool isWrittenUnseen(const VolumeData&) { return false; }
bool isWrittenUnseen(const SphereData&) { return false; }

}  // namespace

DataChecks::Known* DataChecks::find(const std::shared_ptr<const void>& data) {
  const auto entry = known_.find(data.get());
  return entry != known_.end() && !entry->second.owner.expired() ? &entry->second : nullptr;
}

void DataChecks::remember(const std::shared_ptr<const void>& data, std::uint64_t revision) {
  for (auto entry = known_.begin(); entry != known_.end();) {
    entry = entry->second.owner.expired() ? known_.erase(entry) : std::next(entry);
  }
  known_[data.get()] = {data, std::nullopt, revision};
}

template <class Data>
void DataChecks::require(const std::shared_ptr<const Data>& data, void (*validate)(const Data&, const std::string&),
                         const std::string& what, std::uint64_t revision) {
  const Known* known = find(data);
  const bool same = known && known->revision == revision;
  if (same && !isWrittenUnseen(*data)) return;
  validate(*data, what);
  if (!same) remember(data, revision);
}

void DataChecks::requireValid(const std::shared_ptr<const MeshData>& data, const std::string& what,
                              std::uint64_t revision) {
  require(data, validateMeshData, what, revision);
}

void DataChecks::requireValid(const std::shared_ptr<const VolumeData>& data, const std::string& what,
                              std::uint64_t revision) {
  require(data, validateVolumeData, what, revision);
}

void DataChecks::requireValid(const std::shared_ptr<const SphereData>& data, const std::string& what,
                              std::uint64_t revision) {
  require(data, validateSphereData, what, revision);
}

std::size_t DataChecks::openEdges(const std::shared_ptr<const MeshData>& data) {
  Known* known = find(data);
  if (known && known->openEdges) return *known->openEdges;
  const std::size_t open = scene::openEdges(*data);
  if (known) known->openEdges = open;
  return open;
}

}  // namespace cdsm::scene
