// SPDX-License-Identifier: Apache-2.0
// What `cdsm compare` found out about a scene, and how it is told: as JSON and as a page.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

#include "compare_variants.hpp"
#include "io/image_difference.hpp"

namespace cdsm::cli {

/// What a difference of luminances is multiplied by before it gets a colour: the scale ends at 1 / kDifferenceFactor.
inline constexpr double kDifferenceFactor = 10.0;

struct VariantResult {
  ShadowVariant variant;
  std::string reason;  ///< why there is no picture; empty if there is one
  io::ImageDifference difference;
  double buildMs = 0.0;  ///< 0 where nothing is built
  double frameMs = 0.0;  ///< median, with maps that are there
  int frames = 0;        ///< timed
  std::size_t maps = 0;
  std::uint64_t bytes = 0;  ///< of finished maps and of the cache
  std::vector<std::string> warnings;
};

struct Comparison {
  std::string scene;                  ///< the file, as it was named
  std::vector<std::string> settings;  ///< KEY=VALUE of the command line
  DeviceDescription device;
  ImageSettings image;
  ShadowSettings shadows;              ///< the scene's own
  std::vector<VariantResult> results;  ///< one for each of shadowVariants()
};

std::string comparisonJson(const Comparison& comparison);

/// HTML that needs nothing but itself; `pictures` are data URIs by the pictures' names.
std::string comparisonPage(const Comparison& comparison, const std::map<std::string, std::string>& pictures);

}  // namespace cdsm::cli
