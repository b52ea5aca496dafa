// SPDX-License-Identifier: Apache-2.0
// A debug picture as its steps in order. Maps are made as for any picture.
#include <algorithm>

#include "engine/debug_colors.hpp"
#include "engine/frame.hpp"
#include "engine/supersampling.hpp"
#include "engine/view_names.hpp"
#include "technique/none.hpp"

namespace cdsm::engine {

Image FrameState::renderView(const Scene& scene, DebugView view, std::size_t light) {
  const device::HostStep traced = step("render debug picture");
  beginStats();
  prepare(scene, cluster::Purpose::Image);
  prepareOcclusion(scene);
  stats_.view = ViewStats{nameOf(view), {}};

  progress("render", 0.0f);
  device_->profiler().beginGroup("render");
  ImageSettings image = scene.image;
  std::vector<shared::float4> rays;
  if (view == DebugView::Clusters) {
    rays = clusterRays(scene, light);
  } else if (view == DebugView::Texels) {
    rays = texelRays(scene, light);
  } else {
    const std::vector<std::int64_t> counts = viewCounts(scene, view, light);
    stats_.view->scale = std::uint64_t(std::max<std::int64_t>(*std::max_element(counts.begin(), counts.end()), 0));
    rays = countColors(counts, *stats_.view->scale);
    image.background = glm::vec3(0.0f);
  }
  Image result = resolve(rays, image);

  finishStats(scene);
  progress("render", 1.0f);
  return result;
}

std::vector<shared::MapProbe> FrameState::probe(const Scene& scene, std::size_t light) {
  return debug_.probeMaps(scene, deviceScene_, rasterizeCamera(scene), light, lights_, *technique_);
}

/// Maps do not depend on colours: the technique is not told.
std::vector<shared::float4> FrameState::clusterRays(const Scene& scene, std::size_t light) {
  const Scene colored = inClusterColors(scene, *technique_->clusters(), light);
  current_.reset();
  uploadObjects(colored);
  current_ = colored;
  device_->profiler().beginGroup("render");
  return shade(colored).pixels;
}

std::vector<shared::float4> FrameState::texelRays(const Scene& scene, std::size_t light) {
  std::vector<shared::float4> rays = shade(scene).pixels;
  tintTexels(rays, probe(scene, light), *technique_->clusters());
  return rays;
}

std::vector<std::int64_t> FrameState::viewCounts(const Scene& scene, DebugView view, std::size_t light) {
  std::vector<std::int64_t> counts;
  const auto countOrNothing = [&](std::uint32_t count) { counts.push_back(count > 0 ? count : kNothing); };
  if (view == DebugView::Nodes) {
    for (const shared::MapProbe& probe : probe(scene, light)) counts.push_back(probe.seen ? probe.nodes : kNothing);
  } else if (view == DebugView::Layers) {
    for (const std::uint32_t count : render::layerCounts(rasterizeCamera(scene))) countOrNothing(count);
  } else {
    // where samples lie does not depend on the light
    Scene dark = scene;
    dark.lights.clear();
    build::Layers& layers = rasterizeCamera(scene);
    for (const std::uint32_t count :
         shade_.run(dark, deviceScene_, layers, lights_, technique::None(), render::ShadowVolume(*device_), occlusion_)
             .samples)
      countOrNothing(count);
  }
  return counts;
}

}  // namespace cdsm::engine
