// SPDX-License-Identifier: Apache-2.0
// The slow truth: transmittance, visibility functions and pixels in double precision, every ray against everything.
// Shares no code with the engine. Where a World is asked for, a Scene may be given.
#pragma once

#include <utility>
#include <vector>

#include <cdsm/scene.hpp>
#include <glm/glm.hpp>

#include "segments.hpp"

namespace cdsm::reference {

/// Steps as the engine takes them: shadows.step, or half the smallest voxel edge among the segment's volumes.
constexpr double kEngineStep = -1.0;
/// Steps of a quarter of the smallest voxel edge among the segment's volumes.
constexpr double kFineStep = 0.0;

/// True inside the cone of a spot light, its surface included; always for other lights.
bool lit(const Light& light, const glm::dvec3& point);

/// The part of the light that reaches the point, whatever the cone: surfaces strictly between times exp(-integral of
/// the extinction), of all that casts a shadow, by the midpoint rule. `step`: world units, kFineStep or kEngineStep.
double transmittance(const World& world, const Light& light, const glm::dvec3& point, double step = kFineStep);

/// The same of red, green and blue light, of which the other has the mean: all alike where shadows.transmittance is
/// grey.
glm::dvec3 colorTransmittance(const World& world, const Light& light, const glm::dvec3& point, double step = kFineStep);

/// 0 if a surface or sample strictly between the light and the point is more opaque than the threshold, else 1. Opacity
/// of a sample: of each volume at its value, per the volume's unit distance; of an interior per world unit.
double opaqueTransmittance(const World& world, const Light& light, const glm::dvec3& point, double threshold,
                           double step = kFineStep);

/// The way from a point to the light, of unit length.
glm::dvec3 towardsLight(const Light& light, const glm::dvec3& point);

/// (depth in world units along the light's axis, transmittance up to there), ascending in depth, first (0, 1): one
/// entry per step of the midpoint rule, two of the same depth at a surface.
using Visibility = std::vector<std::pair<double, double>>;

/// The uncompressed visibility function of a ray from a light; depth is `depthPerT` times the length along the ray.
/// `channel`: 0 red, 1 green, 2 blue.
Visibility visibility(const World& world, const Ray& ray, double depthPerT, double step = kEngineStep, int channel = 0);

/// The same for a spot light; `direction` of any length.
Visibility visibility(const World& world, const Light& light, const glm::dvec3& direction, double step = kEngineStep);

/// The part of the hemisphere around the unit vector `normal` that is seen from a point, weighted by the cosine: no
/// sphere within `distance`. Of so many rays, spread evenly.
double ambientSeen(const World& world, const glm::dvec3& point, const glm::dvec3& normal, double distance, int rays);

/// The ray of the camera through a position on the image: pixels, y down, the centre of the first pixel at 0.5, 0.5.
Ray cameraRay(const Scene& scene, double px, double py);

/// Linear colour over the background and opacity of one camera ray; with technique "none" nothing casts a shadow,
/// with "shadow-map" and opaque rays the threshold decides.
/// Segments with volumes are sampled at the engine's step, interior media alone with 64 samples per segment.
glm::dvec4 pixel(const World& world, double px, double py);

}  // namespace cdsm::reference
