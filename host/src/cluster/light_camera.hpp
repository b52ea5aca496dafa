// SPDX-License-Identifier: Apache-2.0
// Lights -> the views of their maps [Knecht 2011, §3.2: the scene seen from the light's point of view].
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "scene/view.hpp"
#include "shared/map_data.h"
#include "shared/view_data.h"

namespace cdsm::cluster {

/// The views of a light's maps, each one texel wider on every side than what is looked up in it, so that the filter
/// never reaches out of it. Spot: its cone. Omni: six of 90 degrees, in the order of CDSM_LIGHT_OMNI. Directional: all
/// of `bounds` in parallel, from a plane in front of it; the outermost texels see nothing, as does every point outside.
/// `bounds`: of all that casts; `mapSize`: texels per side.
std::vector<shared::ViewData> lightViews(const Light& light, const scene::Bounds& bounds, int mapSize);

/// The light for the kernels, without its maps.
shared::LightData lightData(const Light& light, const scene::Bounds& bounds);

/// Where points land in the map of a view, those on one side of an omni light or all. Offsets into memory are the
/// memory strategy's to fill in.
shared::MapData mapData(const shared::ViewData& view, shared::uint face);

/// Nothing nearer to a spot or omni light than this casts a shadow, world units. `bounds`: of what casts.
float lightNearDepth(const Light& light, const scene::Bounds& bounds);

/// What half a map has to cover -> half of it, with a texel more on each side.
float withMargin(float half, int mapSize);

/// How far the plane of a parallel camera lies in front of what it sees, which reaches from depth `nearest` to
/// `farthest`.
double planeMargin(double nearest, double farthest);

/// Depth of the farthest corner of the bounds; the near plane's where all of them lie in front of it.
float farthestDepth(const shared::ViewData& view, const scene::Bounds& bounds);

/// Full field of view of a map with square texels in degrees; 0 for parallel light.
double mapFov(const shared::ViewData& view);

}  // namespace cdsm::cluster
