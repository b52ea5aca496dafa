// SPDX-License-Identifier: Apache-2.0
// A cluster of a light with its maps, and the rules by which maps are built again [Knecht 2011, §3.2, §3.4.3].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

#include "cluster/focus.hpp"

namespace cdsm::technique {

/// One cluster of one light; its maps are side by side.
struct MapCluster {
  std::size_t light = 0;
  unsigned number = 0;            ///< among the light's clusters
  bool focused = false;           ///< false: for everything that the light reaches
  bool former = false;            ///< fading out
  std::vector<unsigned> objects;  ///< that cast in it
  std::vector<cluster::MapView> views;
  std::size_t firstMap = 0;
  std::string reason;  ///< why its maps were built for this frame; empty if they were kept
};

/// The cluster of `built` whose maps are still those of `wanted`, or none: then wanted.reason says why.
/// `before`: the scene that they were built for, if there was one.
std::optional<std::size_t> keptCluster(const std::optional<Scene>& before, const Scene& now,
                                       const std::vector<MapCluster>& built, MapCluster& wanted);

}  // namespace cdsm::technique
