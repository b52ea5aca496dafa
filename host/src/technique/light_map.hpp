// SPDX-License-Identifier: Apache-2.0
// The camera of a map, for those who look at the map from outside.
#pragma once

#include <cdsm/light_map.hpp>

#include "technique/map_cluster.hpp"

namespace cdsm::technique {

/// Map number `number` of a cluster, without its nodes.
LightMap describeMap(const Scene& scene, const MapCluster& cluster, std::size_t number);

}  // namespace cdsm::technique
