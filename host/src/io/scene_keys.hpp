// SPDX-License-Identifier: Apache-2.0
// The tables a scene file may have. Their keys stand where they are read, in scene_settings.cpp and scene_objects.cpp.
#pragma once

#include <string>
#include <vector>

namespace cdsm::io {

inline const std::vector<std::string> kSceneTables{"camera", "image", "shadows"};
inline const std::vector<std::string> kSceneArrays{"light", "material", "mesh", "volume"};
/// Of the contract, but refused by this version.
inline const std::vector<std::string> kLaterSceneTables{"ambient_occlusion", "animate", "spheres"};

}  // namespace cdsm::io
