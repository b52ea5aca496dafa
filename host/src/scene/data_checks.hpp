// SPDX-License-Identifier: Apache-2.0
// Checks of meshes, volumes and spheres that look at each of them once, however many scenes it is part of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <cdsm/scene.hpp>

namespace cdsm::scene {

/// Remembers what has been found out about data for as long as they live: they are immutable once they are shared, but
/// for memory that they only show, of which another revision tells. Does not keep them alive. For one thread.
class DataChecks {
 public:
  /// validateMeshData(), validateVolumeData() and validateSphereData(), unless the same data of the same revision
  /// passed before. Indices in somebody else's memory are looked at each time.
  void requireValid(const std::shared_ptr<const MeshData>& data, const std::string& what, std::uint64_t revision = 0);
  void requireValid(const std::shared_ptr<const VolumeData>& data, const std::string& what, std::uint64_t revision = 0);
  void requireValid(const std::shared_ptr<const SphereData>& data, const std::string& what, std::uint64_t revision = 0);

  /// openEdges() of valid data.
  std::size_t openEdges(const std::shared_ptr<const MeshData>& data);

 private:
  struct Known {
    std::weak_ptr<const void> owner;  ///< expired: another may have the address by now
    std::optional<std::size_t> openEdges;
    std::uint64_t revision = 0;  ///< of what they show
  };

  template <class Data>
  void require(const std::shared_ptr<const Data>& data, void (*validate)(const Data&, const std::string&),
               const std::string& what, std::uint64_t revision);
  Known* find(const std::shared_ptr<const void>& data);
  void remember(const std::shared_ptr<const void>& data, std::uint64_t revision);

  std::map<const void*, Known> known_;
};

}  // namespace cdsm::scene
