// SPDX-License-Identifier: Apache-2.0
// Arrays of meshes and spheres in somebody else's memory: answers do not depend on how they lie there, and a new
// revision brings along what has changed and nothing else.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "given_place.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::embedding {
namespace {

using reference::MeshParts;
using reference::SphereParts;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const char* const kTechniques[] = {"deep-shadow-map", "shadow-rays", "stochastic", "shadow-map", "implicit-sphere"};

MeshParts ball() { return reference::partsOf(reference::sphereMesh(0.4f, 12, 8, true)); }

/// Large ones in front, so that walls of spheres hide others.
SphereParts atoms() {
  SphereParts parts;
  for (int i = 0; i < 40; ++i)
    parts.centers.emplace_back(0.05f * float(i) - 1.0f, 0.02f * float(i % 7), 0.04f * float(i % 11));
  parts.radii.assign(parts.centers.size(), 0.08f);
  parts.colors.assign(parts.centers.size(), {0.9f, 0.5f, 0.2f});
  return parts;
}

/// The cloud between the lamp and a floor, beside it a ball filled with a medium and spheres.
Scene sceneOf(const std::shared_ptr<const MeshData>& mesh, const std::shared_ptr<const SphereData>& spheres) {
  Scene scene = cloudScene();
  glm::mat4 above(1.0f);
  above[3].y = 0.9f;
  const int glass = reference::addMaterial(scene, {0.6f, 0.7f, 0.8f}, 0.3f);
  reference::addMesh(scene, {}, glass, above);
  scene.meshes.back().data = mesh;
  scene.meshes.back().interiorExtinction = 1.5f;
  reference::addSpheres(scene, {}, reference::addMaterial(scene, glm::vec3(0.5f), 1.0f), above);
  scene.spheres.back().data = spheres;
  scene.ambientOcclusion.emplace();
  return scene;
}

Scene sceneOf(const MeshData& mesh, const SphereData& spheres) {
  return sceneOf(std::make_shared<MeshData>(mesh), std::make_shared<SphereData>(spheres));
}

/// Values `stride` bytes apart and not aligned, in `memory`, backwards if the stride is negative.
template <class T>
Array<T> scattered(const std::vector<T>& values, std::ptrdiff_t stride, std::vector<std::byte>& memory) {
  const auto step = std::size_t(std::abs(stride));
  memory.assign(1 + values.size() * step, std::byte(0x5a));
  std::byte* const first = memory.data() + 1 + (stride < 0 ? (values.size() - 1) * step : 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(first + std::ptrdiff_t(i) * stride, &values[i], sizeof(T));
  return Array<T>::view(first, values.size(), stride);
}

template <class T>
Array<T> shown(const std::vector<T>& values) {
  return Array<T>::view(values.data(), values.size());
}

MeshData shown(const MeshParts& parts) {
  return {shown(parts.positions), shown(parts.normals), shown(parts.triangles)};
}
SphereData shown(const SphereParts& parts) { return {shown(parts.centers), shown(parts.radii), shown(parts.colors)}; }

void expectSame(const Scene& scene, const Scene& wanted) {
  const auto points = somePoints(300);
  Engine engine, other;
  for (const char* technique : kTechniques) {
    Scene a = scene, b = wanted;
    a.shadows.technique = b.shadows.technique = technique;
    EXPECT_EQ(engine.render(a).pixels, other.render(b).pixels) << technique;
    EXPECT_EQ(answers(engine, points), answers(other, points)) << technique;
  }
}

/// That the engine, which has been given the scene before it changed, answers as a new one.
void expectAsNew(Engine& engine, const Scene& scene) {
  const auto points = somePoints(300);
  engine.prepare(scene);
  EXPECT_EQ(answers(engine, points), answers(scene, points));
  Engine fresh;
  EXPECT_EQ(engine.render(scene).pixels, fresh.render(scene).pixels);
}

TEST(ArrayViews, AnswerAsArraysOfTheirOwn) {
  const MeshParts mesh = ball();
  const SphereParts spheres = atoms();
  std::vector<std::byte> memory[6];
  const MeshData views{scattered(mesh.positions, 40, memory[0]), scattered(mesh.normals, -12, memory[1]),
                       scattered(mesh.triangles, 16, memory[2])};
  const SphereData sphereViews{scattered(spheres.centers, -17, memory[3]), scattered(spheres.radii, 16, memory[4]),
                               scattered(spheres.colors, 13, memory[5])};
  const Scene own = sceneOf(MeshData(mesh), SphereData(spheres));
  expectSame(sceneOf(views, sphereViews), own);
  expectSame(sceneOf(shown(mesh), shown(spheres)), own);
}

TEST(ArrayViews, CanShowOneValueForAll) {
  const SphereParts spheres = atoms();
  const std::size_t count = spheres.centers.size();
  const SphereData views{shown(spheres.centers), Array<float>::view(spheres.radii.data(), count, 0),
                         Array<glm::vec3>::view(spheres.colors.data(), count, 0)};
  expectSame(sceneOf(ball(), views), sceneOf(ball(), SphereData(spheres)));
}

TEST(ArrayViews, KeepTheirOwnerUntilTheSceneIsDropped) {
  Engine engine;
  std::weak_ptr<const void> owner;
  const auto give = [&] {
    const auto values = std::make_shared<std::vector<glm::vec3>>(ball().positions);
    owner = values;
    MeshData mesh = ball();
    mesh.positions = Array<glm::vec3>::view(values->data(), values->size(), sizeof(glm::vec3), values);
    engine.render(sceneOf(mesh, atoms()));
  };
  expectKeptUntilDropped(engine, owner, give);
}

TEST(ArrayTimeSteps, OfAMeshBringItsVerticesAlong) {
  MeshParts mesh = ball();
  const SphereParts spheres = atoms();
  Scene scene = sceneOf(shown(mesh), shown(spheres));
  Engine engine;
  engine.prepare(scene);
  for (glm::vec3& p : mesh.positions) p = p * glm::vec3(1.3f, 0.6f, 1.1f) + glm::vec3(0.2f, 0.0f, 0.0f);
  ++scene.meshes.back().revision;
  engine.prepare(scene);
  EXPECT_EQ(uploaded(engine.stats(), "vertex positions"), mesh.positions.size() * sizeof(glm::vec3));
  EXPECT_EQ(uploaded(engine.stats(), "triangles"), mesh.triangles.size() * 16);
  EXPECT_EQ(uploaded(engine.stats(), "spheres") + uploaded(engine.stats(), "voxels"), 0u);
  engine.prepare(scene);
  EXPECT_EQ(engine.stats().uploadedBytes, 0u) << "nothing has changed";
  expectAsNew(engine, scene);
}

TEST(ArrayTimeSteps, OfSpheresBringThemAlong) {
  const MeshParts mesh = ball();
  SphereParts spheres = atoms();
  Scene scene = sceneOf(shown(mesh), shown(spheres));
  Engine engine;
  engine.render(scene);
  for (glm::vec3& p : spheres.centers) p = glm::vec3(p.z, p.x, p.y);
  ++scene.spheres.back().revision;
  engine.prepare(scene);
  EXPECT_EQ(uploaded(engine.stats(), "spheres"), spheres.centers.size() * 32);
  EXPECT_EQ(uploaded(engine.stats(), "vertex positions") + uploaded(engine.stats(), "voxels"), 0u);
  expectAsNew(engine, scene);
}

TEST(ArrayTimeSteps, AreSeenByAllTechniquesAndClusters) {
  for (const char* technique : kTechniques) {
    MeshParts mesh = ball();
    SphereParts spheres = atoms();
    Scene scene = sceneOf(shown(mesh), shown(spheres));
    scene.shadows.technique = technique;
    scene.shadows.clusters = scene.shadows.technique == "deep-shadow-map" ? 3 : 1;
    scene.shadows.cache = scene.shadows.technique == "stochastic" ? "volume" : "none";
    Engine engine;
    engine.render(scene);
    for (glm::vec3& p : mesh.positions) p.x += 1.5f;
    for (glm::vec3& p : spheres.centers) p.z = 3.0f * p.z - 2.0f;
    ++scene.meshes.back().revision;
    ++scene.spheres.back().revision;
    expectAsNew(engine, scene);
  }
}

TEST(ArrayTimeSteps, OfTheMeshThatCutsAVolumeAreSeen) {
  MeshParts mesh = ball();
  Scene scene = sceneOf(shown(mesh), atoms());
  scene.meshes.back().interiorExtinction = 0.0f;
  scene.meshes.back().worldFromObject = glm::mat4(1.0f);
  scene.meshes.back().shadow.casts = false;  // only what it cuts out of the cloud does
  scene.volumes.front().boundary = 1;
  Engine engine;
  engine.prepare(scene);
  for (glm::vec3& p : mesh.positions) p *= 0.7f;
  ++scene.meshes.back().revision;
  expectAsNew(engine, scene);
}

TEST(ArrayTimeSteps, MayHaveOtherCounts) {
  auto data = std::make_shared<MeshData>(ball());
  Scene scene = sceneOf(data, std::make_shared<SphereData>(atoms()));
  Engine engine;
  engine.prepare(scene);
  *data = reference::boxMesh(glm::vec3(-0.3f), glm::vec3(0.3f));
  ++scene.meshes.back().revision;
  expectAsNew(engine, scene);
}

TEST(WrongArrays, AreRefusedAndTheEngineStaysUsable) {
  MeshParts mesh = ball();
  SphereParts spheres = atoms();
  Scene scene = sceneOf(shown(mesh), shown(spheres));
  Engine engine;
  engine.prepare(scene);
  const auto says = [&](const std::string& text) {
    const std::string error = errorOf([&] { engine.prepare(scene); });
    EXPECT_NE(error.find(text), std::string::npos) << error;
  };
  const glm::vec3 before = mesh.positions[5];
  mesh.positions[5].y = kNan;
  ++scene.meshes.back().revision;
  says("position 5 is not finite");
  mesh.positions[5] = before;
  mesh.triangles[2].z = 1000000;
  ++scene.meshes.back().revision;
  says("triangle 2 has the index 1000000");
  mesh.triangles[2] = ball().triangles[2];
  spheres.radii[3] = -1.0f;
  ++scene.meshes.back().revision;
  ++scene.spheres.back().revision;
  says("radius 3 is -1, must be above 0");
  spheres.radii[3] = 0.1f;
  ++scene.spheres.back().revision;
  MeshData nowhere = ball();
  nowhere.normals = Array<glm::vec3>::view(nullptr, nowhere.positions.size());
  const auto right = scene.meshes.back().data;
  scene.meshes.back().data = std::make_shared<MeshData>(nowhere);
  says("normals show memory at null, must point to ");
  nowhere.normals = Array<glm::vec3>::view(mesh.normals.data(), nowhere.positions.size(), 3);
  scene.meshes.back().data = std::make_shared<MeshData>(nowhere);
  says("normals of 12 bytes lie at a stride of 3 bytes, must be at least as many or 0");
  scene.meshes.back().data = right;
  expectAsNew(engine, scene);
}

TEST(WrongArrays, ThatMeshesShareHaveOneRevision) {
  Scene scene = sceneOf(ball(), atoms());
  scene.meshes.push_back(scene.meshes.back());
  scene.meshes.back().name = "twin";
  scene.meshes.back().revision = 3;
  Engine engine;
  EXPECT_NE(errorOf([&] { engine.prepare(scene); }).find("'twin' with the same data the revision 3, must be the same"),
            std::string::npos);
  scene.meshes.back().revision = 0;
  expectAsNew(engine, scene);
}

/// Not a change that counts, but one that must not lead out of the arrays.
TEST(WrongArrays, WrittenWithoutAWordAreFoundWhenReadAgain) {
  MeshParts mesh = ball();
  Scene scene = sceneOf(shown(mesh), atoms());
  scene.shadows.technique = "shadow-rays";
  Engine engine;
  engine.prepare(scene);
  mesh.triangles[7].x = 0x7fffffff;
  scene.meshes.back().worldFromObject[3].x += 0.1f;
  EXPECT_NE(errorOf([&] { engine.prepare(scene); }).find("triangle 7 has the index 2147483647"), std::string::npos);
  mesh.triangles[7] = ball().triangles[7];
  expectAsNew(engine, scene);
}

TEST(WrongArrays, AreNotCountedThrough) {
  Scene scene = sceneOf(ball(), atoms());
  const float radius = 0.1f;
  const glm::vec3 center(0.0f);
  const std::size_t many = std::size_t(1) << 40;
  scene.spheres.back().data = std::make_shared<SphereData>(
      SphereData{Array<glm::vec3>::view(&center, many, 0), Array<float>::view(&radius, many, 0), {}});
  EXPECT_NE(errorOf([&] { Engine().prepare(scene); }).find("must be below 1073741824"), std::string::npos);
}

}  // namespace
}  // namespace cdsm::embedding
