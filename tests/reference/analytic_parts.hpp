// SPDX-License-Identifier: Apache-2.0
// What the tables of closed forms share: slabs and sheets across the y axis, and points around it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analytic_cases.hpp"

namespace cdsm::reference {

constexpr float kWide = 3.0f;  ///< half width of the slabs: the cone is narrower everywhere

inline const std::vector<float> kHeights{3.0f, 1.25f, 0.45f, 0.2f, -0.1f, -0.45f, -0.75f, -1.5f};

/// -ln(1 - opacity) / unitDistance, of numbers that a Scene stores as floats.
double sigmaOf(float opacity, float unitDistance);

/// 1 / cosine between the light ray to p and the y axis.
double slant(const Scene& scene, const glm::dvec3& p);

/// World length of the light ray to p between the heights low and high.
double lengthInSlab(const Scene& scene, const glm::dvec3& p, double low, double high);

/// Points at these heights, at six distances and directions from the axis, none on a symmetry plane of the objects.
std::vector<glm::vec3> pointsAt(const std::vector<float>& heights, float largestRadius);

/// A field that is 1 everywhere.
double filled(const glm::dvec3& point);

/// A grid of that field, as wide as the slabs.
VolumeData slabVolume(VoxelType type, const glm::uvec3& size, float low, float high,
                      const std::function<double(const glm::dvec3&)>& field);

/// A case with one constant slab; what a test changes in the scene must keep the formula true.
AnalyticCase slabCase(const std::string& name, VoxelType type, const glm::uvec3& size, float opacity, float unit);

/// Sheets of that opacity from y = 1.5 down.
AnalyticCase stackedSheets(const std::string& name, int count, float spacing, float opacity);

/// Cases with one omni or directional light.
std::vector<AnalyticCase> casesOfOtherLights();

}  // namespace cdsm::reference
