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
#include "device/mirror.hpp"
#include "render/debug_pass.hpp"
#include "render/map_reader.hpp"
#include "render/occlusion_pass.hpp"
#include "render/query_pass.hpp"
#include "render/shade_pass.hpp"
#include "render/shadow_volume.hpp"
#include "scene/data_checks.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::engine {

/// For kernels of others: kernels/device/lookup.clh in the scene's variant, and its arguments.
struct Lookup {
  std::string source;
  device::LookupArguments arguments;
  std::vector<std::string> lights;                      ///< names, by number
  std::vector<std::shared_ptr<const VolumeData>> data;  ///< that the arguments may lie in
};

/// Number of the light of that name. Throws Error that lists those there are.
std::size_t lightNumber(const std::vector<std::string>& lights, const std::string& light);
std::vector<std::string> lightNames(const Scene& scene);
/// Values of a point's transmittance.
std::size_t channelsOf(const Scene& scene);

/// Everything behind Engine: the device, what is on it, and what it was made for.
class FrameState {
 public:
  FrameState(const EngineOptions& options, std::unique_ptr<device::Device> device);
  /// Waits for the device: what it still works on may be the host's.
  ~FrameState();

  /// validate(), without looking again at objects that the last scene had too, or at data that was valid before.
  void check(const Scene& scene);

  /// Into image.width * image.height pixels.
  void render(const Scene& scene, glm::vec4* pixels);
  /// `light`: number of the one whose maps are shown.
  Image renderView(const Scene& scene, DebugView view, std::size_t light);
  /// Brings the device up to date for queries about a scene; those that follow are about it.
  void prepareQueries(const Scene& scene);
  /// Throws Error if none is ready.
  const Scene& readyScene() const;
  /// values: channelsOf() the scene for each of the `count` points, -1 where not lit.
  void query(std::size_t light, const glm::vec3* points, std::size_t count, float* values);
  /// The same for a scene that may be another one.
  void query(const Scene& scene, std::size_t light, const glm::vec3* points, std::size_t count, float* values);
  /// On the device. `done`: gets an event for the end; null: waits for it.
  void query(std::size_t light, const render::DevicePoints& points, const device::Buffer<float>& values,
             const std::vector<cl_event>& after, cl_event* done);
  Lookup lookup();
  /// Forgets the scene and frees what was made for it.
  void drop();
  std::vector<LightMap> lightMaps(const Scene& scene, std::size_t light);

  device::Device& device() const { return *device_; }
  const FrameStats& stats() const { return stats_; }

 private:
  /// Brings the device up to date with a scene: objects, then maps, each only if it changed.
  void prepare(const Scene& scene, cluster::Purpose purpose);
  void answer(std::size_t light, const glm::vec3* points, std::size_t count, float* values);
  /// Makes maps for points, if those there are for an image.
  void readyForPoints();
  render::QueryScene queryScene() const { return {*current_, deviceScene_, lights_, *technique_, cache_}; }
  void uploadObjects(const Scene& scene);
  void prepareTechnique(const Scene& scene, cluster::Purpose purpose, bool objectsChanged);
  /// Pictures alone ask for it.
  void prepareOcclusion(const Scene& scene);
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
  /// What the statistics say of maps and memory.
  void forgetBuilding();
  void addMapStats(const Scene& scene);
  void report(const std::string& what);
  void progress(const char* step, float done) const;

  EngineOptions options_;
  std::unique_ptr<device::Device> device_;
  build::DeviceScene deviceScene_;
  build::RasterPass raster_;
  render::ShadePass shade_;
  render::QueryPass query_;
  render::ShadowVolume cache_;
  render::OcclusionPass occlusion_;
  render::DebugPass debug_;
  render::MapReader mapReader_;
  std::unique_ptr<technique::ShadowTechnique> technique_;
  device::Mirror<shared::LightData> lights_;
  scene::DataChecks dataChecks_;
  std::optional<Scene> current_;                        ///< what all of it was made for; empty after an error
  cluster::Purpose purpose_ = cluster::Purpose::Image;  ///< that its maps serve
  FrameStats stats_;
  bool ready_ = false;     ///< it is the scene that was given last
  bool prepared_ = false;  ///< in this call
  bool occluded_ = false;  ///< likewise, ambient occlusion
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace cdsm::engine
