// SPDX-License-Identifier: Apache-2.0
#include "stats.hpp"

#include <pybind11/stl.h>

namespace cdsm::python {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

py::dict mapDict(const MapStats& map) {
  return py::dict("cluster"_a = map.cluster, "objects"_a = map.objects, "regenerated"_a = map.regenerated,
                  "reason"_a = map.reason, "texels"_a = map.texels, "nodes_mean"_a = map.nodesMean,
                  "nodes_max"_a = map.nodesMax, "nodes_total"_a = map.nodesTotal, "fov_x"_a = map.fovX,
                  "fov_y"_a = map.fovY, "near"_a = map.nearDepth, "far"_a = map.farDepth);
}

py::list lightList(const std::vector<LightStats>& lights) {
  py::list list;
  for (const LightStats& light : lights) {
    py::list maps;
    for (const MapStats& map : light.maps) maps.append(mapDict(map));
    list.append(py::dict("name"_a = light.name, "type"_a = light.type, "maps"_a = maps));
  }
  return list;
}

py::dict memoryDict(const MemoryStats& memory) {
  return py::dict("strategy"_a = memory.strategy, "bytes_reserved"_a = memory.bytesReserved,
                  "bytes_used"_a = memory.bytesUsed, "bytes_wasted"_a = memory.bytesWasted,
                  "chunks_used"_a = memory.chunksUsed, "chunks_wasted"_a = memory.chunksWasted,
                  "bytes_per_node"_a = memory.bytesPerNode, "merge_error"_a = memory.mergeError,
                  "tolerance"_a = memory.tolerance, "limit"_a = memory.limit);
}

py::list kernelList(const std::vector<KernelTime>& kernels) {
  py::list list;
  for (const KernelTime& kernel : kernels)
    list.append(py::dict("name"_a = kernel.name, "time_ms"_a = kernel.milliseconds, "launches"_a = kernel.launches,
                         "bytes"_a = kernel.bytes));
  return list;
}

}  // namespace

py::dict statsDict(const FrameStats& stats) {
  py::dict times("cluster"_a = stats.clusterMs, "rasterize"_a = stats.rasterizeMs, "build_maps"_a = stats.buildMapsMs,
                 "ambient_occlusion"_a = stats.ambientOcclusionMs, "render"_a = stats.renderMs,
                 "total"_a = stats.totalMs);
  py::dict dict("time_ms"_a = times, "lights"_a = lightList(stats.lights), "memory"_a = memoryDict(stats.memory),
                "kernels"_a = kernelList(stats.kernels), "device_times"_a = stats.deviceTimes,
                "uploaded_bytes"_a = stats.uploadedBytes, "copied_bytes"_a = stats.copiedBytes,
                "shaded_samples"_a = stats.shadedSamples, "warnings"_a = stats.warnings, "reports"_a = stats.reports);
  if (stats.cache) dict["cache"] = py::dict("bytes"_a = stats.cache->bytes, "filled"_a = stats.cache->filled);
  if (const auto& occlusion = stats.ambientOcclusion)
    dict["ambient_occlusion"] =
        py::dict("bytes"_a = occlusion->bytes, "filled"_a = occlusion->filled,
                 "cells"_a = py::make_tuple(occlusion->width, occlusion->height, occlusion->depth));
  if (stats.view) dict["view"] = py::dict("name"_a = stats.view->name, "scale"_a = stats.view->scale);
  return dict;
}

py::dict deviceDict(const DeviceDescription& device) {
  return py::dict("id"_a = device.id, "platform"_a = device.platform, "name"_a = device.name,
                  "version"_a = device.version, "type"_a = device.type, "compute_units"_a = device.computeUnits,
                  "memory_bytes"_a = device.memoryBytes, "max_allocation_bytes"_a = device.maxAllocationBytes,
                  "local_memory_bytes"_a = device.localMemoryBytes, "images"_a = device.images,
                  "fetch"_a = device.fetch, "unusable"_a = device.unusable);
}

}  // namespace cdsm::python
