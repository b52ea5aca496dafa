// SPDX-License-Identifier: Apache-2.0
// In: a light's deep shadow maps. Out: a deep EXR file with one part per map, whole or not at all (docs/deep-exr.md).
#pragma once

#include <string>
#include <vector>

#include <cdsm/light_map.hpp>
#include <cdsm/scene.hpp>

namespace cdsm::io {

enum class MapFileLayout { Scanlines, Tiles };

/// Writes channels A, Z and ZBack, and AR, AG and AB where the maps have colours. An earlier file stays if it fails.
/// Throws Error, also if there are no maps.
void writeLightMaps(const std::string& path, const Light& light, const std::vector<LightMap>& maps,
                    MapFileLayout layout);

/// Throws what writeLightMaps() would throw for this path, before there are maps.
void checkMapPath(const std::string& path);

}  // namespace cdsm::io
