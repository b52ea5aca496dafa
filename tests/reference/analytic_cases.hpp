// SPDX-License-Identifier: Apache-2.0
// Scenes whose transmittance is a formula. One table for the reference's own test and for every technique of the
// engine.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::reference {

struct AnalyticCase {
  std::string name;
  Scene scene;                                     ///< with one light
  std::function<double(const glm::dvec3&)> exact;  ///< transmittance at a world point inside the cone
  std::vector<glm::vec3> points;                   ///< inside the cone, away from silhouettes and surfaces
  double discrete = 1e-5;  ///< what the formula leaves out: tessellation, midpoint rule at half a voxel
  double perTexel = 5e-3;  ///< how far T may differ within one texel of a map of 96 texels
};

std::vector<AnalyticCase> analyticCases();

/// Points that a case's light does not reach: outside of a spot's cone, behind it, in the plane of the light. None is
/// the light itself; none for other lights.
std::vector<glm::vec3> unlitPoints(const Light& light);

}  // namespace cdsm::reference
