// SPDX-License-Identifier: Apache-2.0
// Points at which suites look light up.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::cli {

/// World points within a light's reach: in neighbouring order along parallel lines through the box of all objects, and
/// anywhere in it in no order. Each list has `count` points, those in reach repeated if there are fewer; the same ones
/// in every run. Throws Error if hardly a point of the box is in the light's reach.
struct LookupPoints {
  std::vector<glm::vec3> along, anywhere;
};

LookupPoints lookupPoints(Engine& engine, const Scene& scene, const std::string& light, std::size_t count);

}  // namespace cdsm::cli
