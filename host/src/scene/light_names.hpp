// SPDX-License-Identifier: Apache-2.0
// Names of the types of lights, in scene files, messages and statistics.
#pragma once

#include <cdsm/scene.hpp>

namespace cdsm::scene {

inline const char* nameOf(LightType type) {
  switch (type) {
    case LightType::Omni:
      return "omni";
    case LightType::Directional:
      return "directional";
    default:
      return "spot";
  }
}

}  // namespace cdsm::scene
