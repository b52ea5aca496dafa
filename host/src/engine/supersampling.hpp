// SPDX-License-Identifier: Apache-2.0
// Rays -> pixels: averages the rays of each pixel and puts the background behind them.
#pragma once

#include <vector>

#include <cdsm/cdsm.hpp>

#include "shared/types.h"

namespace cdsm::engine {

/// `rays`: supersampling^2 per pixel, row after row, colours weighted by their opacity in w.
Image resolve(const std::vector<shared::float4>& rays, const ImageSettings& settings);
/// The same into width * height pixels.
void resolve(const std::vector<shared::float4>& rays, const ImageSettings& settings, glm::vec4* pixels);

}  // namespace cdsm::engine
