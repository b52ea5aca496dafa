// SPDX-License-Identifier: Apache-2.0
// What cdsm.hpp promises.
#include <cdsm/cdsm.hpp>

#include <cmath>

#include "engine/engine_impl.hpp"
#include "engine/view_names.hpp"

namespace cdsm {

namespace {

std::size_t numberOf(const Scene& scene, const std::string& light) {
  return engine::lightNumber(engine::lightNames(scene), light);
}

/// Throws Error if the scene has no maps to show.
void checkView(const Scene& scene, DebugView view) {
  if (view == DebugView::Layers || view == DebugView::Steps) return;
  const std::string start = std::string("view '") + engine::nameOf(view) + "' shows the deep shadow maps of a light, ";
  if (scene.shadows.technique != "deep-shadow-map")
    throw Error(start + "shadows.technique is '" + scene.shadows.technique + "', must be 'deep-shadow-map'");
  if (scene.lights.empty()) throw Error(start + "the scene has no light, must have one");
}

bool isFinite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Throws Error for null arrays and for the first point that is not finite.
void checkPoints(const glm::vec3* points, std::size_t count, const float* values) {
  if (count == 0) return;
  if (!points || !values)
    throw Error(std::string(points ? "values" : "points") + " is null, must be an array of " + std::to_string(count));
  float sum = 0.0f;  // of zeros, or not a number
  for (std::size_t i = 0; i < count; ++i) sum += 0.0f * points[i].x + 0.0f * points[i].y + 0.0f * points[i].z;
  if (sum == 0.0f) return;
  std::size_t bad = 0;
  while (bad + 1 < count && isFinite(points[bad])) ++bad;
  throw Error("point " + std::to_string(bad) + " is not finite, must be numbers");
}

/// From the values of a point.
Transmittance resultOf(const float* values, std::size_t channels) {
  const glm::vec3 color(values[0], values[channels / 2], values[channels - 1]);
  const glm::vec3 passed = glm::max(color, 0.0f);
  const float mean = channels == 1 ? passed.r : (passed.r + passed.g + passed.b) / 3.0f;
  return {std::uint8_t(color.r >= 0.0f), mean, passed};
}

}  // namespace

std::vector<DeviceDescription> listDevices() { return device::Device::list(); }

Engine::Engine(const EngineOptions& options)
    : Engine(std::make_unique<Impl>(options, device::Device::open(options.device, options.fetch))) {}
Engine::Engine(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

Engine::Impl& Engine::impl() const {
  if (!impl_) throw Error("an engine is used that was moved from; use the one that it was moved to");
  return *impl_;
}

const DeviceDescription& Engine::device() const { return impl().frame.device().description(); }
const FrameStats& Engine::stats() const { return impl().frame.stats(); }

Image Engine::render(const Scene& scene) {
  impl().frame.check(scene);
  Image image{scene.image.width, scene.image.height, {}};
  image.pixels.resize(std::size_t(image.width) * std::size_t(image.height));
  impl().frame.render(scene, image.pixels.data());
  return image;
}

void Engine::render(const Scene& scene, glm::vec4* pixels) {
  impl().frame.check(scene);
  if (!pixels) throw Error("pixels is null, must be an array of image.width * image.height");
  impl().frame.render(scene, pixels);
}

Image Engine::render(const Scene& scene, const ViewOptions& options) {
  impl().frame.check(scene);
  checkView(scene, options.view);
  return impl().frame.renderView(scene, options.view, options.light ? numberOf(scene, *options.light) : 0);
}

void Engine::prepare(const Scene& scene) {
  impl().frame.check(scene);
  impl().frame.prepareQueries(scene);
}

void Engine::transmittance(const std::string& light, const glm::vec3* points, std::size_t count, float* values) {
  const std::size_t number = numberOf(impl().frame.readyScene(), light);
  checkPoints(points, count, values);
  impl().frame.query(number, points, count, values);
}

std::vector<Transmittance> Engine::transmittance(const Scene& scene, const std::string& light,
                                                 const std::vector<glm::vec3>& points) {
  impl().frame.check(scene);
  const std::size_t channels = engine::channelsOf(scene);
  std::vector<float> values(channels * points.size());
  checkPoints(points.data(), points.size(), values.data());
  impl().frame.query(scene, numberOf(scene, light), points.data(), points.size(), values.data());
  std::vector<Transmittance> results(points.size());
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = resultOf(&values[channels * i], channels);
  return results;
}

std::vector<LightMap> Engine::lightMaps(const Scene& scene, const std::string& light) {
  impl().frame.check(scene);
  return impl().frame.lightMaps(scene, numberOf(scene, light));
}

std::size_t Engine::channels() const { return engine::channelsOf(impl().frame.readyScene()); }

void Engine::drop() { impl().frame.drop(); }

}  // namespace cdsm
