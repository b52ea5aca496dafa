// SPDX-License-Identifier: Apache-2.0
#include "technique/map_cluster.hpp"

#include "scene/changes.hpp"
#include "scene/objects.hpp"

namespace cdsm::technique {

namespace {

/// What of the light makes all of its maps wrong; empty if nothing does.
std::string lightReason(const Scene& before, const Scene& now, std::size_t light) {
  if (light >= before.lights.size() || before.lights[light].name != now.lights[light].name) return "light";
  switch (scene::lightChange(before.lights[light], now.lights[light])) {
    case scene::LightChange::None:
      return "";
    case scene::LightChange::Moved:
      return "light moved";
    case scene::LightChange::Turned:
      return "light turned";
    case scene::LightChange::Cone:
      return "cone";
    case scene::LightChange::Other:
      break;
  }
  return "light";
}

std::string objectReason(const Scene& before, const Scene& now, const std::vector<unsigned>& objects) {
  for (const unsigned object : objects) {
    const scene::CasterChange change = scene::casterChange(before, now, object);
    if (change == scene::CasterChange::TransferFunction)
      return "transfer function of " + scene::objectName(now, object);
    if (change == scene::CasterChange::Other) return "object " + scene::objectName(now, object);
  }
  return "";
}

}  // namespace

std::optional<std::size_t> keptCluster(const std::optional<Scene>& before, const Scene& now,
                                       const std::vector<MapCluster>& built, MapCluster& wanted) {
  if (!before)
    wanted.reason = "first";
  else if (!scene::sameMapSettings(before->shadows, now.shadows))
    wanted.reason = "settings";
  else if (!scene::sameObjectNames(*before, now))
    wanted.reason = "objects";
  else
    wanted.reason = lightReason(*before, now, wanted.light);
  if (wanted.reason.empty()) wanted.reason = objectReason(*before, now, wanted.objects);
  if (!wanted.reason.empty()) return std::nullopt;
  for (std::size_t i = 0; i < built.size(); ++i)
    if (built[i].light == wanted.light && built[i].focused == wanted.focused && built[i].objects == wanted.objects)
      return i;
  wanted.reason = "cluster";
  return std::nullopt;
}

}  // namespace cdsm::technique
