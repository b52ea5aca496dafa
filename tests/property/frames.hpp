// SPDX-License-Identifier: Apache-2.0
// What the tests of frames after frames share: pictures compared, a scene of objects far apart.
#pragma once

#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::property {

/// Four cubes "mesh0" .. "mesh3" and a cloud "volume0" in a row above a floor "mesh4", the spot light "key" above.
Scene rowScene();

/// A matrix that moves.
glm::mat4 movedTo(const glm::vec3& position);

bool sameBytes(const Image& a, const Image& b);

/// The largest difference of any channel of any pixel.
float largestStep(const Image& a, const Image& b);

/// Root of the mean square over all channels.
double rmsDifference(const Image& a, const Image& b);

}  // namespace cdsm::property
