// SPDX-License-Identifier: Apache-2.0
// Some of the scene's objects for one view: all of them for the camera, those of one cluster for a light's map.
#pragma once

#include <cstdint>
#include <vector>

#include "build/geometry.hpp"
#include "device/mirror.hpp"
#include "shared/scene_data.h"

namespace cdsm::build {

/// Objects as kernels see them in this view, under their numbers in the scene. One that does not take part has no
/// opacity and no media, and none of its triangles or spheres is drawn.
struct ObjectSet {
  device::Mirror<shared::ObjectData> objects;
  device::Mirror<std::uint32_t> lists;    ///< media of all objects, see ObjectData::firstMedium
  std::vector<PrimitiveRange> triangles;  ///< that are drawn, neighbouring ranges joined
  std::vector<PrimitiveRange> spheres;    ///< the same
  std::vector<std::uint32_t> enclosing;   ///< objects of which rays keep track whether they are inside
  float interiorStep = 0.0f;              ///< ray step where a ray is in constant media only, world units
  bool towardsLight = false;              ///< volumes have the extinction that light meets, else that of the picture
};

}  // namespace cdsm::build
