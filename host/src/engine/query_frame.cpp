// SPDX-License-Identifier: Apache-2.0
// Queries as their steps in order. Maps are made when a scene is given, looked up in as often as one likes.
#include "device/program.hpp"
#include "engine/frame.hpp"

namespace cdsm::engine {

std::size_t lightNumber(const std::vector<std::string>& lights, const std::string& light) {
  std::string known;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (lights[i] == light) return i;
    known += (known.empty() ? "" : ", ") + lights[i];
  }
  throw Error("there is no light '" + light + "'; " + (known.empty() ? "the scene has none" : "known: " + known));
}

std::vector<std::string> lightNames(const Scene& scene) {
  std::vector<std::string> names;
  for (const Light& light : scene.lights) names.push_back(light.name);
  return names;
}

std::size_t channelsOf(const Scene& scene) { return memory::spectrumNamed(scene.shadows.transmittance).channels; }

void FrameState::prepareQueries(const Scene& scene) {
  const device::HostStep traced = step("prepare queries");
  beginStats();
  prepare(scene, cluster::Purpose::Points);
  finishStats(scene);
}

const Scene& FrameState::readyScene() const {
  if (!current_ || !ready_)
    throw Error("no scene is ready for queries; prepare() must be called with one, and must succeed");
  return *current_;
}

void FrameState::readyForPoints() {
  if (purpose_ != cluster::Purpose::Points) prepare(Scene(readyScene()), cluster::Purpose::Points);
}

void FrameState::query(std::size_t light, const glm::vec3* points, std::size_t count, float* values) {
  const device::HostStep traced = step("answer query");
  beginStats();
  readyForPoints();
  answer(light, points, count, values);
}

void FrameState::query(const Scene& scene, std::size_t light, const glm::vec3* points, std::size_t count,
                       float* values) {
  const device::HostStep traced = step("answer query");
  beginStats();
  prepare(scene, cluster::Purpose::Points);
  answer(light, points, count, values);
}

void FrameState::answer(std::size_t light, const glm::vec3* points, std::size_t count, float* values) {
  device_->profiler().beginGroup("render");
  query_.run(queryScene(), light, points, count, values);
  finishStats(*current_);
}

void FrameState::query(std::size_t light, const render::DevicePoints& points, const device::Buffer<float>& values,
                       const std::vector<cl_event>& after, cl_event* done) {
  const device::HostStep traced = step("answer query on the device");
  beginStats();
  readyForPoints();
  device_->waitFor(after);  // behind what is still to be built, which may wait for transfers
  device_->profiler().beginGroup("render");
  query_.run(queryScene(), light, points, values);
  if (!done) return finishStats(*current_);
  addMapStats(*current_);
  *done = device_->mark();
}

Lookup FrameState::lookup() {
  readyScene();
  beginStats();
  readyForPoints();
  const render::QueryScene scene = queryScene();
  const device::ProgramSource source =
      build::sceneSource(*device_, deviceScene_, "device/lookup.clh", cache_.kernelFiles(*technique_));
  Lookup lookup{device::joinSource(source), query_.arguments(scene), lightNames(*current_), {}};
  for (const Volume& volume : current_->volumes) lookup.data.push_back(volume.data);
  lookup.source += "#line 1 \"kernels behind cdsm's\"\n";
  finishStats(*current_);
  return lookup;
}

void FrameState::drop() {
  device_->finish();
  current_.reset();
  technique_.reset();
  cache_.drop();
  occlusion_.drop();
  query_.forgetKernel();
  deviceScene_.update(Scene());
}

}  // namespace cdsm::engine
