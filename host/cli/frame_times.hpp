// SPDX-License-Identifier: Apache-2.0
// How long frames and maps take, by the wall clock.
#pragma once

#include <cstddef>

#include <cdsm/cdsm.hpp>

namespace cdsm::cli {

/// Of all maps of all lights.
std::size_t mapCount(const FrameStats& stats);
std::size_t builtMaps(const FrameStats& stats);

/// A frame, whatever it has to build.
double renderMs(Engine& engine, const Scene& scene);

/// Changes all lights by too little to be seen; `nudged` is false the first time and remembers whether they are to go
/// back the next time.
void nudgeLights(Scene& scene, bool& nudged);

/// Building all maps of all lights: an image of 3 x 2 pixels after nudgeLights(), less another one with the maps kept.
/// Throws Error if a map was not built.
double buildMs(Engine& engine, Scene& scene, bool& nudged);

/// The same scene at 3 x 2 pixels, which is the shape of most images: clusters depend on that.
Scene shrunk(Scene scene);

}  // namespace cdsm::cli
