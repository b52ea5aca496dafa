// SPDX-License-Identifier: Apache-2.0
// A cluster -> the light cameras that see it, narrowed and turned so that its maps waste few texels
// [Knecht 2011, §3.4.2; after Low and Ilie as named there: the smallest rectangle around the cluster, in any turn].
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "cluster/casters.hpp"
#include "shared/map_data.h"
#include "shared/view_data.h"

namespace cdsm::cluster {

/// The camera of one map.
struct MapView {
  shared::ViewData view;
  shared::uint face = CDSM_FACE_ANY;  ///< of an omni light: only points on this side of it are looked up in the map
  double nearDepth = 0.0, farDepth = 0.0;  ///< of what casts in it, world units along the axis
  double fovX = 0.0, fovY = 0.0;           ///< full angles in degrees; 0 for parallel light
};

/// The cameras of a cluster's maps: one; of an omni light with objects on several sides of it, one for each side that
/// has any. None if the light reaches none of the objects. Each is a texel wider on every side than the cluster.
/// `shapes`: of all objects of the scene; `objects`: the numbers of those in the cluster; `mapSize`: texels per side.
std::vector<MapView> focusedViews(const Scene& scene, const Light& light, const std::vector<Caster>& shapes,
                                  const std::vector<unsigned>& objects, int mapSize);

/// The cameras of a light without clusters, made for everything that it reaches: a spot's whole cone, six sides of an
/// omni light, all of the objects in parallel light.
std::vector<MapView> wholeViews(const Light& light, const std::vector<Caster>& shapes,
                                const std::vector<unsigned>& objects, int mapSize);

}  // namespace cdsm::cluster
