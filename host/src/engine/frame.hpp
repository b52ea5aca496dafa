// SPDX-License-Identifier: Apache-2.0
// The engine's state, and a frame as its steps in order.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <cdsm/cdsm.hpp>

#include "build/device_scene.hpp"
#include "build/raster_pass.hpp"
#include "device/device.hpp"
#include "device/host_step.hpp"
#include "render/debug_pass.hpp"
#include "render/map_reader.hpp"
#include "render/query_pass.hpp"
#include "render/shade_pass.hpp"
#include "render/shadow_volume.hpp"
#include "scene/data_checks.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::engine {

/// Everything behind Engine: the device, what is on it, and what it was made for.
class FrameState {
 public:
  explicit FrameState(const EngineOptions& options);

  /// validate(), without looking again at objects that the last scene had too, or at data that was valid before.
  void check(const Scene& scene);

  Image render(const Scene& scene);
  /// `light`: number of the one whose maps are shown.
  Image renderView(const Scene& scene, DebugView view, std::size_t light);
  std::vector<Transmittance> transmittance(const Scene& scene, std::size_t light, const std::vector<glm::vec3>& points);
  std::vector<LightMap> lightMaps(const Scene& scene, std::size_t light);

  const DeviceDescription& device() const { return device_->description(); }
  const FrameStats& stats() const { return stats_; }

 private:
  /// Brings the device up to date with a scene: objects, then maps, each only if it changed.
  void prepare(const Scene& scene, cluster::Purpose purpose);
  void uploadObjects(const Scene& scene);
  void prepareTechnique(const Scene& scene, cluster::Purpose purpose, bool objectsChanged);
  void uploadLights(const Scene& scene);
  /// The camera's fragments. They are used up by the pass that walks them.
  build::Layers& rasterizeCamera(const Scene& scene);
  /// The camera's image, rays in place of pixels.
  render::ShadedView shade(const Scene& scene);
  /// Number of the light whose maps are asked about.
  std::vector<shared::MapProbe> probe(const Scene& scene, std::size_t light);
  std::vector<shared::float4> clusterRays(const Scene& scene, std::size_t light);
  std::vector<shared::float4> texelRays(const Scene& scene, std::size_t light);
  /// Counts of the views that show some, by ray; kNothing where there is nothing.
  std::vector<std::int64_t> viewCounts(const Scene& scene, DebugView view, std::size_t light);
  /// A step of the host for the trace, as long as it lives.
  device::HostStep step(const char* name) const;
  void beginStats();
  void finishStats(const Scene& scene);
  void report(const std::string& what);
  void progress(const char* step, float done) const;

  EngineOptions options_;
  std::unique_ptr<device::Device> device_;
  build::DeviceScene deviceScene_;
  build::RasterPass raster_;
  render::ShadePass shade_;
  render::QueryPass query_;
  render::ShadowVolume cache_;
  render::DebugPass debug_;
  render::MapReader mapReader_;
  std::unique_ptr<technique::ShadowTechnique> technique_;
  device::Buffer<shared::LightData> lights_;
  scene::DataChecks dataChecks_;
  std::optional<Scene> current_;  ///< what all of it was made for; empty after an error
  FrameStats stats_;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace cdsm::engine
