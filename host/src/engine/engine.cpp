// SPDX-License-Identifier: Apache-2.0
// What cdsm.hpp promises.
#include <cdsm/cdsm.hpp>

#include "engine/frame.hpp"
#include "engine/view_names.hpp"

namespace cdsm {

namespace {

/// Number of the light of that name.
std::size_t lightNumber(const Scene& scene, const std::string& light) {
  std::string known;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (scene.lights[i].name == light) return i;
    known += (known.empty() ? "" : ", ") + scene.lights[i].name;
  }
  throw Error("there is no light '" + light + "'; " + (known.empty() ? "the scene has none" : "known: " + known));
}

/// Throws Error if the scene has no maps to show.
void checkView(const Scene& scene, DebugView view) {
  if (view == DebugView::Layers || view == DebugView::Steps) return;
  const std::string start = std::string("view '") + engine::nameOf(view) + "' shows the deep shadow maps of a light, ";
  if (scene.shadows.technique != "deep-shadow-map")
    throw Error(start + "shadows.technique is '" + scene.shadows.technique + "', must be 'deep-shadow-map'");
  if (scene.lights.empty()) throw Error(start + "the scene has no light, must have one");
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

Image Engine::render(const Scene& scene, const ViewOptions& options) {
  impl_->frame.check(scene);
  checkView(scene, options.view);
  return impl_->frame.renderView(scene, options.view, options.light ? lightNumber(scene, *options.light) : 0);
}

std::vector<Transmittance> Engine::transmittance(const Scene& scene, const std::string& light,
                                                 const std::vector<glm::vec3>& points) {
  impl_->frame.check(scene);
  return impl_->frame.transmittance(scene, lightNumber(scene, light), points);
}

std::vector<LightMap> Engine::lightMaps(const Scene& scene, const std::string& light) {
  impl_->frame.check(scene);
  return impl_->frame.lightMaps(scene, lightNumber(scene, light));
}

}  // namespace cdsm
