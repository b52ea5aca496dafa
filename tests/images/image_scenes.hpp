// SPDX-License-Identifier: Apache-2.0
// The small scenes of the image tests, 48 x 32 pixels each.
#pragma once

#include <string>
#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::images {

struct ImageScene {
  std::string name;
  Scene scene;
};

/// Smoke over a floor; spheres under a translucent sheet; overlapping shaded volumes under two lights; a filled sphere
/// beside a volume that a mesh cuts; smoke and spheres under a spot, an omni and a directional light;
/// spheres that are not tessellated among all these. All but the first
/// again with some objects that are not shadowed, and with some that cast no shadow.
std::vector<ImageScene> imageScenes();

}  // namespace cdsm::images
