// SPDX-License-Identifier: Apache-2.0
// Clusters, texels and counts as colours: what debug pictures look like.
#pragma once

#include <cstdint>
#include <vector>

#include <cdsm/scene.hpp>

#include "shared/debug_data.h"
#include "technique/map_cluster.hpp"

namespace cdsm::engine {

/// Linear RGB of cluster `number` of a light, told apart with any kind of colour vision; repeated after the eighth.
glm::vec3 clusterColor(unsigned number);

/// Linear RGB of `part` (0..1) of a scale from dark violet over green to bright yellow, in steps that look equal.
glm::vec3 scaleColor(float part);

/// The scene with each object in the colour of its cluster of that light and without highlights. Objects that cast in
/// none are grey.
Scene inClusterColors(Scene scene, const std::vector<technique::MapCluster>& clusters, std::size_t light);

/// Where there is nothing to count.
constexpr std::int64_t kNothing = -1;

/// Rays as resolve() takes them, of counts on a scale up to `greatest`; black and transparent where there is nothing.
std::vector<shared::float4> countColors(const std::vector<std::int64_t>& counts, std::uint64_t greatest);

/// Draws the texels of the maps over the rays of a picture, in the colours of the maps' clusters.
void tintTexels(std::vector<shared::float4>& rays, const std::vector<shared::MapProbe>& probes,
                const std::vector<technique::MapCluster>& clusters);

}  // namespace cdsm::engine
