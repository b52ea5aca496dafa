// SPDX-License-Identifier: Apache-2.0
// What cdsm.hpp promises.
#include <cdsm/cdsm.hpp>

#include "engine/frame.hpp"

namespace cdsm {

namespace {

/// Throws Error for an unknown light.
std::size_t lightOf(const Scene& scene, const std::string& name) {
  std::string known;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (scene.lights[i].name == name) return i;
    known += (known.empty() ? "" : ", ") + scene.lights[i].name;
  }
  throw Error("there is no light '" + name + "'; " + (known.empty() ? "the scene has none" : "known: " + known));
}

}  // namespace

std::vector<DeviceDescription> listDevices() { return device::Device::list(); }

struct Engine::Impl {
  explicit Impl(const EngineOptions& options) : frame(options) {}
  engine::FrameState frame;
};

Engine::Engine(const EngineOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

const DeviceDescription& Engine::device() const { return impl_->frame.device(); }
const FrameStats& Engine::stats() const { return impl_->frame.stats(); }

Image Engine::render(const Scene& scene) {
  impl_->frame.check(scene);
  return impl_->frame.render(scene);
}

std::vector<Transmittance> Engine::transmittance(const Scene& scene, const std::string& light,
                                                 const std::vector<glm::vec3>& points) {
  impl_->frame.check(scene);
  return impl_->frame.transmittance(scene, lightOf(scene, light), points);
}

std::vector<LightMap> Engine::lightMaps(const Scene& scene, const std::string& light) {
  impl_->frame.check(scene);
  return impl_->frame.lightMaps(scene, lightOf(scene, light));
}

}  // namespace cdsm
