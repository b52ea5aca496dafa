// SPDX-License-Identifier: Apache-2.0
// What holds in every scene: visibility starts at 1 and never rises; memory, fetch, order of the input and repetition
// do not matter; nor does the unit of length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::Random;
using reference::randomScene;

constexpr int kMapSize = 128;
constexpr float kTolerance = 0.005f;

std::vector<glm::vec3> randomPoints(std::uint32_t seed, int count) {
  Random random(seed + 500u);
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 2.0)) * random.direction());
  return points;
}

/// Scenes with at most two volumes: sums of two extinctions do not depend on their order, of three they do in the last
/// bit, and that bit may move a node of the compression by as much as the tolerance.
Scene sceneOfTwoVolumes(std::uint32_t seed) {
  Scene scene = randomScene(seed);
  if (scene.volumes.size() > 2) scene.volumes.resize(2);
  return scene;
}

class Laws : public ::testing::TestWithParam<std::uint32_t> {
 protected:
  std::uint32_t seed_ = GetParam();
  Scene scene_ = randomScene(seed_);
};

/// Transmittances along the ray through a texel's centre, from close to the light to behind everything.
std::vector<Transmittance> alongTexel(const Path& path, const Scene& scene, int column, int row) {
  const Light& light = scene.lights.front();
  const reference::Ray ray = LightFrame(scene, light, kMapSize).texelRay(column, row);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 300; ++i) points.emplace_back(ray.at(0.01 + 0.036 * i));
  return query(path, scene, points, light.name);
}

void expectFalling(const std::vector<Transmittance>& result, double slack) {
  EXPECT_NEAR(result.front().transmittance, 1.0, 1e-6);
  for (std::size_t i = 0; i < result.size(); ++i) {
    EXPECT_EQ(result[i].lit, 1);
    EXPECT_GE(result[i].transmittance, 0.0f);
    EXPECT_LE(result[i].transmittance, 1.0f);
  }
  for (std::size_t i = 1; i < result.size(); ++i) {
    EXPECT_LE(result[i].transmittance, result[i - 1].transmittance + slack) << "point " << i;
  }
}

TEST_P(Laws, visibilityStartsAtOneAndNeverRises) {
  // Single precision moves the point across the ray: nearest does not see that, bilinear by its weights.
  const std::vector<std::pair<Path, double>> paths{
      {mapPath("chunked", "nearest"), 1e-5}, {mapPath("atlas", "nearest"), 1e-5},
      {mapPath("exact", "nearest"), 1e-5},   {mapPath("tiled", "nearest"), 1e-5},
      {mapPath("fixed", "nearest"), 1e-5},   {mapPath("chunked", "bilinear"), 5e-4}};
  for (const auto& [path, slack] : paths) {
    SCOPED_TRACE("seed " + std::to_string(seed_) + ", " + path.name());
    const Scene scene = along(path, scene_, kMapSize, kTolerance);
    for (int texel = 40; texel <= 88; texel += 8) {
      expectFalling(alongTexel(path, scene, texel, texel + 3), slack);
      expectFalling(alongTexel(path, scene, texel, kMapSize - texel), slack);
    }
  }
}

TEST_P(Laws, memoryDoesNotMatter) {
  const std::vector<glm::vec3> points = randomPoints(seed_, 2000);
  for (const char* filter : {"nearest", "bilinear"}) {
    const Path chunked = mapPath("chunked", filter);
    const auto expected = query(chunked, along(chunked, scene_, kMapSize, kTolerance), points);
    for (const char* memory : {"atlas", "exact", "tiled"}) {
      const Path path = mapPath(memory, filter);
      const auto found = query(path, along(path, scene_, kMapSize, kTolerance), points);
      EXPECT_LE(largestDifference(found, expected), 1e-5) << "seed " << seed_ << ", " << path.name();
    }
  }
}

std::vector<std::uint32_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = count; i > 1; --i) {
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  }
  return order;
}

Mesh shuffledTriangles(const Mesh& mesh, Random& random) {
  reference::MeshParts data = reference::partsOf(*mesh.data);
  const std::vector<std::uint32_t> order = shuffled(data.triangles.size(), random);
  for (std::size_t i = 0; i < order.size(); ++i) data.triangles[i] = mesh.data->triangles[order[i]];
  Mesh result = mesh;
  result.data = std::make_shared<const MeshData>(std::move(data));
  return result;
}

Scene shuffledScene(const Scene& scene, Random& random) {
  Scene result = scene;
  const std::vector<std::uint32_t> meshes = shuffled(scene.meshes.size(), random);
  std::vector<int> newIndex(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    result.meshes[i] = shuffledTriangles(scene.meshes[meshes[i]], random);
    newIndex[meshes[i]] = static_cast<int>(i);
  }
  const std::vector<std::uint32_t> volumes = shuffled(scene.volumes.size(), random);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    Volume volume = scene.volumes[volumes[i]];
    if (volume.boundary >= 0) volume.boundary = newIndex[static_cast<std::size_t>(volume.boundary)];
    result.volumes[i] = volume;
  }
  std::reverse(result.lights.begin(), result.lights.end());
  return result;
}

TEST_P(Laws, orderOfTheInputDoesNotMatter) {
  Random random(seed_);
  const Scene ordered = sceneOfTwoVolumes(seed_);
  const Scene mixed = shuffledScene(ordered, random);
  const std::vector<glm::vec3> points = randomPoints(seed_, 2000);
  for (const Path& path : {mapPath("chunked"), mapPath("atlas"), mapPath("exact"), mapPath("tiled"), rayPath()}) {
    const auto a = query(path, along(path, ordered, kMapSize, kTolerance), points);
    const auto b = query(path, along(path, mixed, kMapSize, kTolerance), points);
    EXPECT_LE(largestDifference(a, b), 1e-5) << "seed " << seed_ << ", " << path.name();
  }
}

/// The same scene in a unit of length three times smaller.
Scene enlarged(Scene scene, float factor) {
  glm::mat4 scale(factor);
  scale[3][3] = 1.0f;
  for (Light& light : scene.lights) {
    light.position *= factor;
    light.target *= factor;
  }
  for (Mesh& mesh : scene.meshes) {
    mesh.worldFromObject = scale * mesh.worldFromObject;
    mesh.interiorExtinction /= factor;
  }
  for (Volume& volume : scene.volumes) {
    volume.worldFromObject = scale * volume.worldFromObject;
    volume.transfer.unitDistance *= factor;
  }
  return scene;
}

TEST_P(Laws, unitOfLengthDoesNotMatter) {
  const std::vector<glm::vec3> points = randomPoints(seed_, 1000);
  std::vector<glm::vec3> farther = points;
  for (glm::vec3& p : farther) p *= 4.0f;  // a power of two: the same numbers but for their exponents
  for (const Path& path : {mapPath(), rayPath()}) {
    const auto a = query(path, along(path, scene_, kMapSize, kTolerance), points);
    const auto b = query(path, along(path, enlarged(scene_, 4.0f), kMapSize, kTolerance), farther);
    EXPECT_LE(largestDifference(a, b), 2e-3 + 2.0 * static_cast<double>(kTolerance)) << path.name();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Laws, ::testing::Values(1u, 2u, 11u));

/// Smooth volumes: where an image sampler interpolates with 8 bits of fraction, the values stay close.
Scene smoothScene() {
  Scene scene = reference::emptyScene();
  for (const VoxelType type : {VoxelType::UInt8, VoxelType::Int16, VoxelType::Float32}) {
    glm::mat4 move(1.0f);
    move[3] = {0.3f * static_cast<float>(scene.volumes.size()), 0.2f, 0.0f, 1.0f};
    reference::addVolume(
        scene, reference::makeVolume(type, {16, 14, 12}, glm::vec3(-1), glm::vec3(1), reference::gaussianBlob),
        reference::linearOpacity(reference::largestValue(type), 0.5f, 0.5f), move);
  }
  return scene;
}

TEST(Fetch, buffersEqualImages) {
  if (!canFetch("image")) GTEST_SKIP() << "the device has no images";
  const std::vector<glm::vec3> points = randomPoints(1, 2000);
  for (Path path : {mapPath("chunked"), mapPath("atlas"), mapPath("exact"), mapPath("tiled"), rayPath()}) {
    const Scene scene = along(path, smoothScene(), kMapSize, 5e-4f);
    const auto buffers = query(path, scene, points);
    path.fetch = "image";
    EXPECT_LE(largestDifference(buffers, query(path, scene, points)), 2e-3) << path.name();
  }
}

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

bool sameAnswers(const std::vector<Transmittance>& a, const std::vector<Transmittance>& b) {
  return a.size() == b.size() && largestDifference(a, b) == 0.0;
}

TEST(Repetition, givesTheSameBytes) {
  const std::vector<glm::vec3> points = randomPoints(5, 2000);
  for (const Path& path :
       {mapPath("chunked"), mapPath("atlas"), mapPath("exact"), mapPath("tiled"), mapPath("fixed"), rayPath()}) {
    const Scene scene = along(path, randomScene(5), kMapSize, kTolerance);
    const auto first = query(path, scene, points);
    const Image image = engineOf(path.fetch).render(scene);
    query(path, along(path, randomScene(6), kMapSize, kTolerance), points);  // so that all is built anew
    EXPECT_TRUE(sameAnswers(first, query(path, scene, points))) << path.name();
    EXPECT_TRUE(sameBytes(image.pixels, engineOf(path.fetch).render(scene).pixels)) << path.name();
    EngineOptions options;
    options.fetch = path.fetch;
    Engine another(options);
    EXPECT_TRUE(sameAnswers(first, another.transmittance(scene, "key", points))) << path.name();
    EXPECT_TRUE(sameBytes(image.pixels, another.render(scene).pixels)) << path.name();
  }
}

TEST(Invisible, objectsCastNoShadow) {
  Scene scene = reference::emptyScene();
  reference::addMesh(scene, reference::sphereMesh(0.8f, 16, 8, true),
                     reference::addMaterial(scene, glm::vec3(1), 0.0f));
  reference::addVolume(
      scene, reference::makeVolume(VoxelType::UInt8, glm::uvec3(8), glm::vec3(-1), glm::vec3(1), reference::smoke),
      reference::constantOpacity(0.0f, 1.0f));
  for (const Path& path : {mapPath(), rayPath()}) {
    for (const Transmittance& t :
         query(path, along(path, scene, kMapSize, kTolerance), {{0, -2, 0}, {0.1f, 0.1f, 0}})) {
      EXPECT_EQ(t.transmittance, 1.0f) << path.name();
    }
  }
}

}  // namespace
}  // namespace cdsm::property
