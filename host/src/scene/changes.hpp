// SPDX-License-Identifier: Apache-2.0
// What differs between two scenes, in the terms of what has to be made again [Knecht 2011, §3.2, §3.4.3].
#pragma once

#include <cdsm/scene.hpp>

namespace cdsm::scene {

/// Meshes, volumes, spheres and materials, and what of the settings goes into them.
bool sameObjects(const Scene& a, const Scene& b);

/// Meshes, volumes and spheres of the same names in the same order.
bool sameObjectNames(const Scene& a, const Scene& b);

/// How an object attenuates light; what only colours it does not count.
enum class CasterChange { None, TransferFunction, Other };

/// Of an object, by its number, of two scenes with the same names. The mesh that cuts a volume
/// belongs to the volume.
CasterChange casterChange(const Scene& a, const Scene& b, unsigned object);

/// Where a light is and where it shines; not its colour.
enum class LightChange { None, Moved, Turned, Cone, Other };

LightChange lightChange(const Light& a, const Light& b);

/// Settings that go into maps.
bool sameMapSettings(const ShadowSettings& a, const ShadowSettings& b);

/// True if light arrives at points as before: the same lights, but for their colours, casters and technique.
bool sameTransmittance(const Scene& a, const Scene& b);

/// True if spheres occlude each other as before, by the same settings.
bool sameOcclusion(const Scene& a, const Scene& b);

/// True if volumes are seen where they were before: with the same opacities.
bool sameVisibility(const Scene& a, const Scene& b);

}  // namespace cdsm::scene
