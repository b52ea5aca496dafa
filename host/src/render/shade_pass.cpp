// SPDX-License-Identifier: Apache-2.0
#include "render/shade_pass.hpp"

namespace cdsm::render {

namespace {

shared::ShadeParams shadeParams(const Scene& scene, const build::DeviceScene& deviceScene, const shared::ViewData& view,
                                float lookupTolerance) {
  shared::ShadeParams params{};
  params.view = view;
  params.ambient = {scene.image.ambient, 0.0f};
  params.interiorStep = deviceScene.allObjects().interiorStep;
  params.bias = surfaceBias(scene, deviceScene);
  params.lightCount = shared::uint(scene.lights.size());
  params.lookupTolerance = lookupTolerance;
  return params;
}

}  // namespace

float surfaceBias(const Scene& scene, const build::DeviceScene& deviceScene) {
  // of the scene's size: more than the rounding of depths, less than anybody sees
  constexpr float kBiasPart = 2e-5f;
  return scene.shadows.bias > 0.0f ? scene.shadows.bias : kBiasPart * deviceScene.bounds().diagonal();
}

ShadedView ShadePass::run(const Scene& scene, const build::DeviceScene& deviceScene, build::Layers& layers,
                          const device::Buffer<shared::LightData>& lights, const technique::ShadowTechnique& technique,
                          const ShadowVolume& cache, const OcclusionPass& occlusion) {
  using ShadeKernel = device::Kernel<shared::ShadeParams, device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>,
                                     device::Buffer<shared::LightData>, OcclusionPass::Seen,
                                     device::Buffer<shared::float4>, device::Buffer<std::uint32_t>,
                                     shared::TechniqueParams, device::ArgumentList, device::ArgumentList>;
  const shared::ViewData& view = layers.view;
  const std::size_t pixels = std::size_t(view.width) * view.height;
  if (image_.size() != pixels || samples_.size() != pixels) {
    image_ = {};
    samples_ = {};
    image_ = device::Buffer<shared::float4>(device_, pixels, "image");
    samples_ = device::Buffer<std::uint32_t>(device_, pixels, "samples per pixel");
  }
  ShadeKernel shadePixels(device_,
                          build::sceneProgram(device_, deviceScene, "render/shade.cl", cache.kernelFiles(technique)),
                          "shadePixels");
  shared::ShadeParams params = shadeParams(scene, deviceScene, view, technique.lookupTolerance(scene));
  params.occlusion = occlusion.grid();
  const std::size_t items = std::size_t(view.tilesX) * view.tilesY * CDSM_TILE_PIXELS;
  shadePixels({"shade pixels", {items}, {CDSM_TILE_PIXELS}}, params, layers.fragments, layers.ranges, lights,
              occlusion.seen(), image_, samples_, technique.params(scene), cache.arguments(technique),
              deviceScene.arguments(deviceScene.allObjects(), layers.initialObjects));
  ShadedView shaded;
  shaded.pixels = image_.download();
  shaded.samples = samples_.download();
  return shaded;
}

}  // namespace cdsm::render
