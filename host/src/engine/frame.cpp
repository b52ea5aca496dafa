// SPDX-License-Identifier: Apache-2.0
#include "engine/frame.hpp"

#include <numeric>

#include "cluster/light_camera.hpp"
#include "device/host_step.hpp"
#include "engine/supersampling.hpp"
#include "scene/changes.hpp"
#include "scene/light_names.hpp"
#include "scene/validate.hpp"
#include "scene/view.hpp"
#include "technique/registry.hpp"

namespace cdsm::engine {

FrameState::FrameState(const EngineOptions& options, std::unique_ptr<device::Device> device)
    : options_(options),
      device_(std::move(device)),
      deviceScene_(*device_),
      raster_(*device_),
      shade_(*device_),
      query_(*device_),
      cache_(*device_),
      occlusion_(*device_),
      debug_(*device_),
      mapReader_(*device_) {
  device_->profiler().setTrace(options_.trace);
}

FrameState::~FrameState() {
  try {
    device_->finish();
  } catch (const Error&) {  // nothing is left to be told
  }
}

device::HostStep FrameState::step(const char* name) const { return {device_->profiler().trace(), name}; }

void FrameState::check(const Scene& scene) {
  ready_ = false;
  if (!current_ || !scene::sameObjects(*current_, scene)) return scene::validateScene(scene, dataChecks_);
  scene::validateCamera(scene.camera);
  scene::validateImage(scene.image);
  scene::validateShadows(scene.shadows);
  scene::validateTechnique(scene);
  scene::validateOcclusion(scene);
  for (const Light& light : scene.lights) scene::validateLight(light);
}

void FrameState::render(const Scene& scene, glm::vec4* pixels) {
  const device::HostStep traced = step("render image");
  beginStats();
  prepare(scene, cluster::Purpose::Image);
  prepareOcclusion(scene);

  progress("render", 0.0f);
  device_->profiler().beginGroup("render");
  resolve(shade(scene).pixels, scene.image, pixels);

  finishStats(scene);
  progress("render", 1.0f);
}

build::Layers& FrameState::rasterizeCamera(const Scene& scene) {
  const int rays = scene.image.supersampling;
  const float nearDepth = scene::cameraNearDepth(scene.camera, deviceScene_.bounds());
  const shared::ViewData view =
      scene::cameraView(scene.camera, scene.image.width * rays, scene.image.height * rays, nearDepth);
  return raster_.run(deviceScene_, deviceScene_.allObjects(), view, [this](const std::string& what) { report(what); });
}

render::ShadedView FrameState::shade(const Scene& scene) {
  const device::HostStep traced = step("shade view");
  render::ShadedView shaded =
      shade_.run(scene, deviceScene_, rasterizeCamera(scene), lights_, *technique_, cache_, occlusion_);
  stats_.shadedSamples = std::accumulate(shaded.samples.begin(), shaded.samples.end(), std::uint64_t(0));
  return shaded;
}

std::vector<LightMap> FrameState::lightMaps(const Scene& scene, std::size_t light) {
  const device::HostStep traced = step("read maps");
  beginStats();
  prepare(scene, cluster::Purpose::Points);
  device_->profiler().beginGroup("read maps");
  std::vector<LightMap> maps = technique_->lightMaps(scene, light);
  shared::LightData data{};
  technique_->describeLight(light, data);
  for (std::size_t i = 0; i < maps.size(); ++i)
    mapReader_.run(scene, deviceScene_, *technique_, data.firstMap + i, maps[i]);
  finishStats(scene);
  return maps;
}

void FrameState::prepare(const Scene& scene, cluster::Purpose purpose) {
  prepared_ = true;
  const std::optional<Scene> before = std::exchange(current_, std::nullopt);
  purpose_ = purpose;
  const bool objects = before && scene::sameObjects(*before, scene);
  if (!objects) uploadObjects(scene);
  const bool technique = before && before->shadows.technique == scene.shadows.technique &&
                         before->shadows.memory == scene.shadows.memory &&
                         before->shadows.maxNodes == scene.shadows.maxNodes &&
                         before->shadows.nodeFormat == scene.shadows.nodeFormat &&
                         before->shadows.transmittance == scene.shadows.transmittance;
  const bool cache = before && before->shadows.cache == scene.shadows.cache;
  if (!objects || !technique || !cache) query_.forgetKernel();
  if (!technique) {
    technique_.reset();
    technique_ = technique::makeTechnique(scene.shadows, *device_);
  }
  // a shadow volume is to serve all cameras, so maps may not be made for this one
  const bool anyCamera = scene.shadows.cache == "volume";
  prepareTechnique(scene, anyCamera ? cluster::Purpose::Points : purpose, !objects || !technique);
  uploadLights(scene);
  cache_.prepare(scene, deviceScene_, lights_, *technique_,
                 [this](const char* step, float done) { progress(step, done); });
  current_ = scene;
  ready_ = true;
}

void FrameState::uploadObjects(const Scene& scene) {
  const device::HostStep traced = step("upload objects");
  progress("upload", 0.0f);
  device_->profiler().beginGroup("upload");
  device_->finish();  // a query may still read memory of the host's that nobody keeps from here on
  deviceScene_.update(scene);
}

void FrameState::prepareTechnique(const Scene& scene, cluster::Purpose purpose, bool objectsChanged) {
  const device::HostStep traced = step("prepare shadows");
  progress("shadows", 0.0f);
  device_->profiler().beginGroup("build maps");
  const build::RasterPass::Report report = [this](const std::string& what) { this->report(what); };
  technique_->prepare({scene, deviceScene_, raster_, report, purpose, objectsChanged});
}

void FrameState::prepareOcclusion(const Scene& scene) {
  const device::HostStep traced = step("prepare ambient occlusion");
  occluded_ = true;
  device_->profiler().beginGroup("ambient occlusion");
  occlusion_.prepare(scene, deviceScene_, [this](const char* step, float done) { progress(step, done); });
}

void FrameState::uploadLights(const Scene& scene) {
  std::vector<shared::LightData> lights;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    lights.push_back(cluster::lightData(scene.lights[i], deviceScene_.bounds()));
    technique_->describeLight(i, lights.back());
    lights.back().firstShadowBlock = shared::uint(i * deviceScene_.shadowBlocks() * channelsOf(scene));
    lights.back().mediumCount = shared::uint(deviceScene_.mediumCount());
  }
  lights_.follow(*device_, lights, "lights");
}

void FrameState::beginStats() {
  begun_ = std::chrono::steady_clock::now();
  stats_ = {};
  prepared_ = occluded_ = false;
  device_->profiler().reset();
  device_->profiler().beginGroup("upload");
}

void FrameState::finishStats(const Scene& scene) {
  device::Profiler& profiler = device_->profiler();
  stats_.rasterizeMs = profiler.groupMilliseconds("rasterize");
  stats_.buildMapsMs = profiler.groupMilliseconds("build maps");
  stats_.ambientOcclusionMs = profiler.groupMilliseconds("ambient occlusion");
  stats_.renderMs = profiler.groupMilliseconds("render");
  stats_.kernels = profiler.kernels();
  stats_.uploadedBytes = profiler.uploadedBytes();
  profiler.flushTrace();
  addMapStats(scene);
}

void FrameState::addMapStats(const Scene& scene) {
  stats_.deviceTimes = device_->keepsTimes();
  stats_.copiedBytes = device_->profiler().copiedBytes();
  for (const Light& light : scene.lights) stats_.lights.push_back({light.name, scene::nameOf(light.type), {}});
  technique_->addStats(scene, stats_);
  stats_.cache = cache_.stats();
  if (occluded_) stats_.ambientOcclusion = occlusion_.stats();
  if (!prepared_) forgetBuilding();
  if (options_.warning)
    for (const std::string& warning : stats_.warnings) options_.warning(warning);
  stats_.totalMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun_).count();
}

/// What technique and cache tell of the last call that prepared them.
void FrameState::forgetBuilding() {
  stats_.clusterMs = 0.0;
  if (stats_.cache) stats_.cache->filled = false;
  for (LightStats& light : stats_.lights) {
    for (MapStats& map : light.maps) {
      map.regenerated = false;
      map.reason.clear();
    }
  }
}

void FrameState::report(const std::string& what) { stats_.reports.push_back(what); }

void FrameState::progress(const char* step, float done) const {
  if (options_.progress) options_.progress(step, done);
}

}  // namespace cdsm::engine
