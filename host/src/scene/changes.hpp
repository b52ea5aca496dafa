// SPDX-License-Identifier: Apache-2.0
// What differs between two scenes, in the terms of what has to be made again [Knecht 2011, §3.2, §3.4.3].
#pragma once

#include <cdsm/scene.hpp>

namespace cdsm::scene {

/// Meshes, volumes and materials, and what of the settings goes into them.
bool sameObjects(const Scene& a, const Scene& b);

/// Positions, directions and cones; not the colours.
bool sameLightShapes(const Scene& a, const Scene& b);

/// Settings that go into maps.
bool sameMapSettings(const ShadowSettings& a, const ShadowSettings& b);

}  // namespace cdsm::scene
