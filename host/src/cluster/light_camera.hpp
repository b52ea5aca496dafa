// SPDX-License-Identifier: Apache-2.0
// Lights -> the views of their maps [Knecht 2011, §3.2: the scene seen from the light's point of view].
#pragma once

#include <cdsm/scene.hpp>

#include "shared/map_data.h"
#include "shared/view_data.h"

namespace cdsm::cluster {

/// The view of a spot light's map: along its axis, as wide as its cone and one texel more on each side, so that the
/// filter never reaches out of the map for a lit point. `mapSize` texels per side.
shared::ViewData spotView(const Light& light, int mapSize, float nearDepth);

/// The light for the kernels, with its maps.
shared::LightData lightData(const Light& light, unsigned firstMap, unsigned mapCount);

/// Where points land in the map of a view. Offsets into memory are the memory strategy's to fill in.
shared::MapData mapData(const shared::ViewData& view);

/// Full field of view of a spot's map in degrees.
double mapFov(const Light& light, int mapSize);

}  // namespace cdsm::cluster
