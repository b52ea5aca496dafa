// SPDX-License-Identifier: Apache-2.0
// Statistics and devices as JSON. Times are milliseconds, memory bytes, angles degrees, depths world units.
#include "engine/stats_json.hpp"

#include <charconv>
#include <cstdlib>

#include <nlohmann/json.hpp>

namespace cdsm::engine {
namespace {

using Json = nlohmann::ordered_json;

/// Names from drivers and file systems need not be UTF-8: what is not is replaced rather than an error.
std::string textOf(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// The double with the fewest digits that is still this float: 0.01f becomes 0.01 and not 0.00999999977648258.
double fewestDigits(float value) {
  char digits[32] = {};
  std::to_chars(digits, digits + sizeof digits - 1, value);
  return std::strtod(digits, nullptr);
}

Json mapJson(const MapStats& map) {
  return {{"cluster", map.cluster},    {"objects", map.objects},        {"regenerated", map.regenerated},
          {"reason", map.reason},      {"texels", map.texels},          {"nodes_mean", map.nodesMean},
          {"nodes_max", map.nodesMax}, {"nodes_total", map.nodesTotal}, {"fov_x", map.fovX},
          {"fov_y", map.fovY},         {"near", map.nearDepth},         {"far", map.farDepth}};
}

Json lightsJson(const std::vector<LightStats>& lights) {
  Json list = Json::array();
  for (const LightStats& light : lights) {
    Json maps = Json::array();
    for (const MapStats& map : light.maps) maps.push_back(mapJson(map));
    list.push_back({{"name", light.name}, {"type", light.type}, {"maps", maps}});
  }
  return list;
}

Json memoryJson(const MemoryStats& memory) {
  return {{"strategy", memory.strategy},
          {"bytes_reserved", memory.bytesReserved},
          {"bytes_used", memory.bytesUsed},
          {"bytes_wasted", memory.bytesWasted},
          {"chunks_used", memory.chunksUsed},
          {"chunks_wasted", memory.chunksWasted},
          {"bytes_per_node", memory.bytesPerNode},
          {"merge_error", memory.mergeError},
          {"tolerance", fewestDigits(float(memory.tolerance))},
          {"limit", memory.limit}};
}

Json kernelsJson(const std::vector<KernelTime>& kernels) {
  Json list = Json::array();
  for (const KernelTime& kernel : kernels) {
    list.push_back({{"name", kernel.name}, {"time_ms", kernel.milliseconds}, {"launches", kernel.launches}});
  }
  return list;
}

Json viewJson(const ViewStats& view) {
  Json json = {{"name", view.name}};
  if (view.scale) json["scale"] = *view.scale;
  return json;
}

Json frameJson(const FrameStats& frame) {
  const Json times = {{"cluster", frame.clusterMs},      {"rasterize", frame.rasterizeMs},
                      {"build_maps", frame.buildMapsMs}, {"ambient_occlusion", frame.ambientOcclusionMs},
                      {"render", frame.renderMs},        {"total", frame.totalMs}};
  Json json = {{"frame", frame.frame},
               {"time_ms", times},
               {"lights", lightsJson(frame.lights)},
               {"memory", memoryJson(frame.memory)},
               {"kernels", kernelsJson(frame.kernels)},
               {"shaded_samples", frame.shadedSamples},
               {"warnings", frame.warnings},
               {"reports", frame.reports}};
  if (frame.cache) json["cache"] = {{"bytes", frame.cache->bytes}, {"filled", frame.cache->filled}};
  if (const auto& occlusion = frame.ambientOcclusion)
    json["ambient_occlusion"] = {{"bytes", occlusion->bytes},
                                 {"cells", {occlusion->width, occlusion->height, occlusion->depth}},
                                 {"filled", occlusion->filled}};
  if (frame.view) json["view"] = viewJson(*frame.view);
  return json;
}

Json settingsJson(const ShadowSettings& shadows) {
  return {{"technique", shadows.technique},
          {"memory", shadows.memory},
          {"max_nodes", shadows.maxNodes},
          {"node_format", shadows.nodeFormat},
          {"map_size", shadows.mapSize},
          {"tolerance", fewestDigits(shadows.tolerance)},
          {"tolerance_mode", shadows.toleranceMode},
          {"filter", shadows.filter},
          {"rays", shadows.rays},
          {"transmittance", shadows.transmittance},
          {"threshold", fewestDigits(shadows.threshold)},
          {"pcf", shadows.pcf},
          {"samples", shadows.samples},
          {"seed", shadows.seed},
          {"stratified", shadows.stratified},
          {"patch", shadows.patch == ShadowSettings::kPatchAuto ? Json("auto") : Json(shadows.patch)},
          {"softness", fewestDigits(shadows.softness)},
          {"softness_distance", fewestDigits(shadows.softnessDistance)},
          {"softness_exponent", fewestDigits(shadows.softnessExponent)},
          {"clusters", shadows.clusters},
          {"cluster_distance", fewestDigits(shadows.clusterDistance)},
          {"stable", shadows.stable},
          {"step", fewestDigits(shadows.step)},
          {"memory_limit_mb", fewestDigits(shadows.memoryLimitMb)},
          {"on_overflow", shadows.onOverflow},
          {"cache", shadows.cache},
          {"bias", fewestDigits(shadows.bias)}};
}

Json deviceJson(const DeviceDescription& device) {
  return {{"id", device.id},
          {"platform", device.platform},
          {"name", device.name},
          {"version", device.version},
          {"type", device.type},
          {"compute_units", device.computeUnits},
          {"memory_bytes", device.memoryBytes},
          {"max_allocation_bytes", device.maxAllocationBytes},
          {"local_memory_bytes", device.localMemoryBytes},
          {"images", device.images},
          {"fetch", device.fetch},
          {"unusable", device.unusable}};
}

}  // namespace

std::string statsJson(const DeviceDescription& device, const ShadowSettings& shadows,
                      const std::vector<FrameStats>& frames) {
  Json list = Json::array();
  for (const FrameStats& frame : frames) list.push_back(frameJson(frame));
  const Json deviceEntry = {{"platform", device.platform}, {"name", device.name}, {"version", device.version}};
  return textOf({{"device", deviceEntry}, {"settings", settingsJson(shadows)}, {"frames", list}});
}

std::string devicesJson(const std::vector<DeviceDescription>& devices) {
  Json list = Json::array();
  for (const DeviceDescription& device : devices) list.push_back(deviceJson(device));
  return textOf(list);
}

}  // namespace cdsm::engine
