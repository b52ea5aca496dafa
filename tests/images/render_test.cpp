// SPDX-License-Identifier: Apache-2.0
// Rendered images against the reference, every scene by every technique; a failure leaves render, reference,
// difference.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "image_compare.hpp"
#include "image_scenes.hpp"
#include "property/engine_paths.hpp"
#include "reference/reference.hpp"

namespace cdsm::images {
namespace {

struct Technique {
  std::string label;
  property::Path path;
  float limit;  ///< of a channel, linear
  double part;  ///< of the pixels that must be within; the others are silhouettes and edges of shadows
  const char* rays = "exact";
};

std::vector<Technique> techniques() {
  return {{"None", {"none", "chunked", "bilinear", "buffer"}, 2.0f / 255.0f, 0.99},
          {"ShadowRays", property::rayPath(), 2.0f / 255.0f, 0.99},
          {"MapChunked", property::mapPath("chunked"), 6.0f / 255.0f, 0.97},
          {"MapAtlas", property::mapPath("atlas"), 6.0f / 255.0f, 0.97},
          {"MapExact", property::mapPath("exact"), 6.0f / 255.0f, 0.97},
          {"MapTiled", property::mapPath("tiled"), 6.0f / 255.0f, 0.97},
          {"OpaqueRays", property::rayPath(), 6.0f / 255.0f, 0.9, "opaque"},
          {"ShadowMap", {"shadow-map", "chunked", "bilinear", "buffer"}, 6.0f / 255.0f, 0.9, "opaque"}};
}

Image referenceImage(const Scene& scene) {
  const reference::World world(scene);
  Image image{scene.image.width, scene.image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) image.pixels.emplace_back(reference::pixel(world, x + 0.5, y + 0.5));
  }
  return image;
}

/// Rendered once per scene: without shadows, with those of the threshold, with all.
const Image& cachedReference(const ImageScene& scene, const Scene& settings) {
  static std::map<std::string, Image> images;
  const std::string key = scene.name + (settings.shadows.technique == "none" ? "/none" : "/" + settings.shadows.rays);
  const auto found = images.find(key);
  return found != images.end() ? found->second : images.emplace(key, referenceImage(settings)).first->second;
}

/// Those of all or nothing know no colours; that all memory strategies agree on these, other tests tell.
bool isRendered(const ImageScene& scene, const Technique& technique) {
  const bool carriesColors = technique.label == "ShadowRays" || technique.label == "MapExact";
  return scene.scene.shadows.transmittance == "grey" || carriesColors;
}

struct Case {
  ImageScene scene;
  Technique technique;
};

/// Every scene by every technique.
const std::vector<Case>& cases() {
  static const std::vector<Case> list = [] {
    std::vector<Case> pairs;
    for (const ImageScene& scene : imageScenes())
      for (const Technique& technique : techniques())
        if (isRendered(scene, technique)) pairs.push_back({scene, technique});
    return pairs;
  }();
  return list;
}

class Render : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Render, matchesTheReference) {
  const auto& [scene, technique] = cases()[GetParam()];
  Scene settings = property::along(technique.path, scene.scene, 512, 0.005f);
  settings.shadows.rays = technique.rays;
  settings.shadows.threshold = 0.25f;
  const Image render = property::engineOf(technique.path.fetch).render(settings);
  const Image& expected = cachedReference(scene, settings);
  const double part = partWithin(render, expected, technique.limit);
  EXPECT_GE(part, technique.part) << "of the pixels within " << technique.limit;
  if (part < technique.part) writeFailure(scene.name + technique.label, render, expected);
}

/// Stochastic shadows by many seeds: what is left of the noise, and the width of the lookups at edges of shadows.
TEST(RenderStochastic, matchesTheReferenceInTheMean) {
  constexpr int kSeeds = 4;
  for (const ImageScene& scene : imageScenes()) {
    if (scene.name.find("Some") != std::string::npos) continue;  // roles are those of other techniques
    Scene settings = property::along({"stochastic", "chunked", "bilinear", "buffer"}, scene.scene, 512, 0.005f);
    settings.shadows.stratified = true;
    settings.shadows.samples = 7;
    Image mean{settings.image.width, settings.image.height, {}};
    mean.pixels.resize(std::size_t(mean.width) * std::size_t(mean.height), glm::vec4(0.0f));
    for (int seed = 1; seed <= kSeeds; ++seed) {
      settings.shadows.seed = seed;
      const Image render = property::engineOf("buffer").render(settings);
      for (std::size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] += render.pixels[i] / float(kSeeds);
    }
    const Image& expected = cachedReference(scene, settings);
    const double part = partWithin(mean, expected, 6.0f / 255.0f);
    std::cout << scene.name << ": " << part << " of the pixels\n";
    EXPECT_GE(part, 0.9) << scene.name;
    if (part < 0.9) writeFailure(scene.name + "Stochastic", mean, expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Render, ::testing::Range<std::size_t>(0, cases().size()), [](const auto& instance) {
  return cases()[instance.param].scene.name + cases()[instance.param].technique.label;
});

}  // namespace
}  // namespace cdsm::images
