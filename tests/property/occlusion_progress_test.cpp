// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion is made in parts: progress is told before each of them, and the work may be given up there.
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include <cdsm/cdsm.hpp>

#include "frames.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

/// Some spheres in a grid of some 64 x 64 x 254 cells, nearly four times what one launch looks at.
Scene rowOfSpheres() {
  Scene scene = reference::emptyScene();
  scene.lights.clear();
  scene.shadows.technique = "none";
  scene.image.width = scene.image.height = 32;
  scene.image.ambient = glm::vec3(1.0f);
  reference::SphereParts data;
  for (int i = 0; i < 8; ++i) {
    data.centers.emplace_back(0.0f, 0.0f, 0.5f * float(i) - 1.75f);
    data.radii.push_back(0.5f);
  }
  reference::addSpheres(scene, std::move(data), reference::addMaterial(scene, glm::vec3(1.0f), 1.0f));
  scene.ambientOcclusion = AmbientOcclusion{4, 0.7f, 256, 1.0f};
  return scene;
}

struct GivenUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Gives up when told of ambient occlusion for the `last` time, counted from 1.
struct Progress {
  std::vector<float> told;
  std::size_t last = 1000;

  EngineOptions options() {
    EngineOptions options;
    options.progress = [this](const std::string& step, float done) {
      if (step != "ambient occlusion") return;
      told.push_back(done);
      if (told.size() >= last) throw GivenUp(step);
    };
    return options;
  }
};

TEST(OcclusionProgress, risesWithEachPart) {
  Progress run;
  Engine engine(run.options());
  engine.render(rowOfSpheres());
  const OcclusionStats stats = *engine.stats().ambientOcclusion;
  const int cells = stats.width * stats.height * stats.depth;
  ASSERT_GT(cells, 3 << 18);
  EXPECT_GE(run.told.size(), 8u) << "four parts, gathered and smoothed";
  EXPECT_EQ(run.told.front(), 0.0f);
  EXPECT_LT(run.told.back(), 1.0f);
  for (std::size_t i = 1; i < run.told.size(); ++i) EXPECT_GT(run.told[i], run.told[i - 1]) << i;
}

TEST(OcclusionProgress, canBeGivenUpAtEachPart) {
  Scene scene = rowOfSpheres();
  Progress run;
  Engine engine(run.options()), undisturbed;
  engine.render(scene);
  const std::size_t parts = run.told.size();
  for (const std::size_t part : {std::size_t(1), parts / 2, parts / 2 + 1, parts}) {
    scene.ambientOcclusion->strength += 0.1f;
    run.told.clear();
    run.last = part;
    EXPECT_THROW(engine.render(scene), GivenUp) << part;
    run.last = 1000;
    EXPECT_TRUE(sameBytes(engine.render(scene), undisturbed.render(scene))) << "after part " << part;
    EXPECT_TRUE(engine.stats().ambientOcclusion->filled);
  }
}

}  // namespace
}  // namespace cdsm::property
