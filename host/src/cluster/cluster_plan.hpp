// SPDX-License-Identifier: Apache-2.0
// Which objects cast together, for one light seen by one camera [Knecht 2011, §3.4.1, §4.5].
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "cluster/casters.hpp"
#include "cluster/clustering.hpp"
#include "cluster/light_space.hpp"

namespace cdsm::cluster {

/// Object numbers of each cluster, ascending; clusters by their first objects.
using LightClusters = std::vector<std::vector<unsigned>>;

/// What the clusters are for.
enum class Purpose {
  Image,   ///< objects whose shadow the camera cannot see are left out
  Points,  ///< any point may be asked: all objects that the light reaches
};

/// The clusters of one light, and what they were formed from.
struct LightPlan {
  LightClusters clusters;
  std::vector<ClusterItem> items;
  std::vector<unsigned> objects;  ///< of each item
};

/// At most scene.shadows.clusters clusters of the objects that cast. `shapes`: of all objects.
LightPlan planLight(const Scene& scene, const Light& light, const std::vector<Caster>& shapes,
                    const VisibleSpace& visible, Purpose purpose);

/// All objects that cast in one cluster, whatever the light and the camera see of them.
LightPlan planWithoutClusters(const Scene& scene, const std::vector<Caster>& shapes);

/// expectedError() of other clusters of the plan's objects; infinite if they are not the same objects.
double errorOf(const LightPlan& plan, const LightClusters& clusters);

}  // namespace cdsm::cluster
