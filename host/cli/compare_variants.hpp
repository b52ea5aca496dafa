// SPDX-License-Identifier: Apache-2.0
// What `cdsm compare` compares: the shadow techniques, each with the settings that make it one of the published ways.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::cli {

/// A key of [shadows] and the value that it gets.
struct ShadowSetting {
  const char* key;
  std::string ShadowSettings::*member;
  const char* value;
};

struct ShadowVariant {
  std::string name;  ///< of files and in messages: letters and dashes
  std::string what;  ///< one line for a reader
  std::vector<ShadowSetting> settings;

  ShadowSettings applied(ShadowSettings shadows) const;
  /// "--set shadows.technique=none": how to render the same.
  std::string options() const;
};

/// In the order in which they are shown.
const std::vector<ShadowVariant>& shadowVariants();

/// Exact shadow rays: what all others are held against.
const ShadowVariant& referenceVariant();

inline std::string pictureName(const ShadowVariant& variant) { return variant.name + ".png"; }
inline std::string differenceName(const ShadowVariant& variant) { return variant.name + "_difference.png"; }

/// All files that a comparison may consist of.
std::set<std::string> comparisonFiles();

}  // namespace cdsm::cli
