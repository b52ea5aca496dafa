// SPDX-License-Identifier: Apache-2.0
#include "compare_variants.hpp"

namespace cdsm::cli {
namespace {

constexpr auto kTechnique = &ShadowSettings::technique;
constexpr auto kRays = &ShadowSettings::rays;
constexpr auto kCache = &ShadowSettings::cache;
constexpr auto kTransmittance = &ShadowSettings::transmittance;

}  // namespace

/// The first one is the reference. Those of all or nothing are grey in coloured light, too.
const std::vector<ShadowVariant>& shadowVariants() {
  static const std::vector<ShadowVariant> variants{
      {"shadow-rays",
       "a ray to the light for each sample, exact up to its steps",
       {{"technique", kTechnique, "shadow-rays"}, {"rays", kRays, "exact"}, {"cache", kCache, "none"}}},
      {"none", "all is lit", {{"technique", kTechnique, "none"}, {"cache", kCache, "none"}}},
      {"shadow-rays-opaque",
       "the first sample above the threshold stops all light",
       {{"technique", kTechnique, "shadow-rays"},
        {"rays", kRays, "opaque"},
        {"cache", kCache, "none"},
        {"transmittance", kTransmittance, "grey"}}},
      {"shadow-map",
       "the depth of the first opaque hit in each texel",
       {{"technique", kTechnique, "shadow-map"}, {"cache", kCache, "none"}, {"transmittance", kTransmittance, "grey"}}},
      {"stochastic",
       "depths at which photons were stopped by chance",
       {{"technique", kTechnique, "stochastic"}, {"cache", kCache, "none"}}},
      {"implicit-sphere",
       "the nearest sphere of each texel, met by a ray to the light",
       {{"technique", kTechnique, "implicit-sphere"},
        {"cache", kCache, "none"},
        {"transmittance", kTransmittance, "grey"}}},
      {"deep-shadow-map",
       "the light that is left at each depth, compressed",
       {{"technique", kTechnique, "deep-shadow-map"}, {"cache", kCache, "none"}}},
      {"deep-shadow-map-cached",
       "the same, kept at every voxel of the volumes",
       {{"technique", kTechnique, "deep-shadow-map"}, {"cache", kCache, "volume"}}},
  };
  return variants;
}

const ShadowVariant& referenceVariant() { return shadowVariants().front(); }

ShadowSettings ShadowVariant::applied(ShadowSettings shadows) const {
  for (const ShadowSetting& setting : settings) shadows.*setting.member = setting.value;
  return shadows;
}

std::string ShadowVariant::options() const {
  std::string text;
  for (const ShadowSetting& setting : settings)
    text += (text.empty() ? "" : " ") + std::string("--set shadows.") + setting.key + "=" + setting.value;
  return text;
}

std::set<std::string> comparisonFiles() {
  std::set<std::string> names{"index.html", "compare.json"};
  for (const ShadowVariant& variant : shadowVariants()) names.insert({pictureName(variant), differenceName(variant)});
  return names;
}

}  // namespace cdsm::cli
