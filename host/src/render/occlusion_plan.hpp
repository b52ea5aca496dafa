// SPDX-License-Identifier: Apache-2.0
// Where the cells of an ambient occlusion grid lie, and at which places directions are looked along.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "scene/view.hpp"
#include "shared/occlusion_data.h"

namespace cdsm::render {

/// What of the spheres counts: those that are to be seen.
struct SphereExtent {
  scene::Bounds bounds;     ///< world
  double meanRadius = 0.0;  ///< world
  double greatestRadius = 0.0;
};

SphereExtent extentOf(const Scene& scene);

/// So many unit vectors, evenly spread over the sphere, in each of eight sets that are turned against each other. w:
/// factor of the steps along each, so that what they pass over differs.
std::vector<shared::float4> evenDirections(int count);

/// Grid, levels and steps. `extent` is not empty.
shared::OcclusionParams planOcclusion(const AmbientOcclusion& settings, const SphereExtent& extent);

/// Cells of all levels.
std::size_t cellsOf(const shared::OcclusionParams& params);

}  // namespace cdsm::render
