// SPDX-License-Identifier: Apache-2.0
// Whose memory voxels lie in, what of them is copied, and what is uploaded again after a change.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "given_place.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::embedding {
namespace {

const VoxelType kTypes[] = {VoxelType::UInt8, VoxelType::Int8, VoxelType::UInt16, VoxelType::Int16, VoxelType::Float32};

/// Whether kernels read a volume where it lies in the host's memory.
bool readsInPlace(const Engine& engine) {
  const cl::Device device(opencl::placeOf(engine).device, true);
  return device.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>() && engine.device().fetch == "buffer";
}

std::uint64_t totalUploaded(const FrameStats& stats) {
  std::uint64_t sum = 0;
  for (const KernelTime& kernel : stats.kernels)
    if (kernel.name.rfind("upload ", 0) == 0) sum += kernel.bytes;
  return sum;
}

/// A view of voxels that lie in `memory`, x and z exchanged and every voxel between two others.
VolumeData stridedView(const VolumeData& data, std::vector<std::byte>& memory) {
  const std::size_t bytes = voxelBytes(data.type);
  const glm::uvec3 n = data.size;
  memory.assign(2 * data.voxels.size(), std::byte(0x5a));
  VolumeData view;
  view.type = data.type;
  view.size = n;
  view.objectFromIndex = data.objectFromIndex;
  view.view.strides = {std::ptrdiff_t(2 * bytes * n.z * n.y), std::ptrdiff_t(2 * bytes * n.z),
                       -std::ptrdiff_t(2 * bytes)};
  std::byte* first = memory.data() + 2 * bytes * (n.z - 1);
  view.view.data = first;
  for (unsigned z = 0; z < n.z; ++z)
    for (unsigned y = 0; y < n.y; ++y)
      for (unsigned x = 0; x < n.x; ++x)
        std::memcpy(first + std::ptrdiff_t(x) * view.view.strides[0] + std::ptrdiff_t(y) * view.view.strides[1] +
                        std::ptrdiff_t(z) * view.view.strides[2],
                    data.voxels.data() + ((std::size_t(z) * n.y + y) * n.x + x) * bytes, bytes);
  return view;
}

VolumeData denseView(const VolumeData& data) {
  VolumeData view;
  view.type = data.type;
  view.size = data.size;
  view.objectFromIndex = data.objectFromIndex;
  view.view.data = data.voxels.data();
  return view;
}

TEST(VoxelViews, AnswerAsVoxelsOfTheirOwn) {
  const auto points = somePoints(300);
  for (const VoxelType type : kTypes) {
    const VolumeData data = cloud(type);
    std::vector<std::byte> memory, odd(data.voxels.size() + 1);
    const std::vector<float> wanted = answers(sceneOf(std::make_shared<VolumeData>(data)), points);
    EXPECT_EQ(answers(sceneOf(std::make_shared<VolumeData>(denseView(data))), points), wanted) << int(type);
    EXPECT_EQ(answers(sceneOf(std::make_shared<VolumeData>(stridedView(data, memory))), points), wanted) << int(type);
    std::memcpy(odd.data() + 1, data.voxels.data(), data.voxels.size());
    VolumeData misaligned = denseView(data);
    misaligned.view.data = odd.data() + 1;
    EXPECT_EQ(answers(sceneOf(std::make_shared<VolumeData>(misaligned)), points), wanted) << int(type);
  }
}

TEST(VoxelViews, AnswerFromABufferOfTheDevice) {
  const Given given;
  const auto points = somePoints(300);
  for (const VoxelType type : kTypes) {
    const VolumeData data = cloud(type);
    const std::vector<float> wanted = answers(sceneOf(std::make_shared<VolumeData>(data)), points);
    Engine engine = opencl::makeEngine(given.place());
    {
      const cl::Buffer buffer = given.buffer(data.voxels);
      engine.prepare(sceneOf(opencl::volumeData(buffer(), type, data.size, data.objectFromIndex)));
    }
    if (engine.device().fetch == "buffer") EXPECT_EQ(uploaded(engine.stats(), "voxels"), 0u);
    EXPECT_EQ(answers(engine, points), wanted) << int(type);
  }
}

TEST(VoxelViews, AreCopiedOnlyWhereTheyMustBe) {
  const VolumeData data = cloud(VoxelType::Float32);
  std::vector<std::byte> memory;
  Engine engine;
  engine.prepare(sceneOf(std::make_shared<VolumeData>(denseView(data))));
  EXPECT_EQ(engine.stats().copiedBytes, 0u);
  EXPECT_EQ(uploaded(engine.stats(), "voxels"), readsInPlace(engine) ? 0u : data.voxels.size());
  EXPECT_EQ(engine.stats().uploadedBytes, totalUploaded(engine.stats()));
  engine.prepare(sceneOf(std::make_shared<VolumeData>(stridedView(data, memory))));
  EXPECT_EQ(engine.stats().copiedBytes, data.voxels.size());
}

TEST(VoxelViews, KeepTheirOwnerUntilTheSceneIsDropped) {
  Engine engine;
  std::weak_ptr<const void> owner;
  const auto give = [&] {
    auto data = std::make_shared<VolumeData>(cloud(VoxelType::UInt8));
    VolumeData view = denseView(*data);
    view.view.owner = data;
    owner = data;
    engine.prepare(sceneOf(std::make_shared<VolumeData>(view)));
  };
  expectKeptUntilDropped(engine, owner, give);
}

TEST(TimeSteps, AreReadInPlace) {
  const auto points = somePoints(300);
  auto now = std::make_shared<VolumeData>(cloud(VoxelType::UInt8));
  const VolumeData later = cloud(VoxelType::UInt8, 5.0f);
  Scene scene = sceneOf(std::make_shared<VolumeData>(denseView(*now)));
  Engine engine;
  engine.prepare(scene);
  const std::vector<float> before = answers(engine, points);
  std::memcpy(now->voxels.data(), later.voxels.data(), later.voxels.size());
  ++scene.volumes.front().revision;
  engine.prepare(scene);
  EXPECT_EQ(engine.stats().copiedBytes, 0u);
  EXPECT_EQ(uploaded(engine.stats(), "voxels"), readsInPlace(engine) ? 0u : later.voxels.size());
  EXPECT_EQ(uploaded(engine.stats(), "vertex positions") + uploaded(engine.stats(), "extinction tables"), 0u);
  const std::vector<float> after = answers(engine, points);
  EXPECT_NE(after, before);
  EXPECT_EQ(after, answers(sceneOf(std::make_shared<VolumeData>(later)), points));
  engine.prepare(scene);
  EXPECT_EQ(engine.stats().uploadedBytes, 0u) << "nothing has changed";
}

TEST(TimeSteps, AreCheckedAnew) {
  auto now = std::make_shared<VolumeData>(cloud(VoxelType::Float32));
  Scene scene = sceneOf(std::make_shared<VolumeData>(denseView(*now)));
  Engine engine;
  engine.prepare(scene);
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(now->voxels.data() + 5 * sizeof bad, &bad, sizeof bad);
  ++scene.volumes.front().revision;
  EXPECT_NE(errorOf([&] { engine.prepare(scene); }).find("voxel 5 is not finite"), std::string::npos);
}

/// Ten meshes of which every second one casts through its opacity, and the cloud.
Scene tenObjects() {
  Scene scene = cloudScene();
  const int glass = reference::addMaterial(scene, glm::vec3(0.5f), 0.5f);
  for (int i = 0; i < 8; ++i) {
    glm::mat4 place(1.0f);
    place[3] = glm::vec4(0.3f * float(i) - 1.0f, 0.8f, 0.0f, 1.0f);
    reference::addMesh(scene, reference::sphereMesh(0.1f, 12, 8, true), glass, place);
  }
  return scene;
}

TEST(MovedObject, BringsItsMatrixAlong) {
  const auto points = somePoints(300);
  constexpr std::uint64_t kRecord = 128, kMedium = 176;  // bytes of an object, of a medium
  constexpr std::uint64_t kMaps = 2 * 208;               // of a map with its list
  Scene scene = tenObjects();
  Engine engine;
  engine.prepare(scene);
  EXPECT_GT(uploaded(engine.stats(), "vertex positions"), 10 * kRecord);
  scene.meshes[4].worldFromObject[3].x += 0.1f;
  engine.prepare(scene);
  EXPECT_EQ(uploaded(engine.stats(), "objects"), 2 * kRecord) << "as what is seen, and as what casts";
  EXPECT_LE(engine.stats().uploadedBytes, 2 * kRecord + kMaps);
  EXPECT_EQ(answers(engine, points), answers(scene, points));
  scene.volumes.front().worldFromObject[3].x += 0.1f;
  engine.prepare(scene);
  EXPECT_EQ(uploaded(engine.stats(), "voxels") + uploaded(engine.stats(), "vertex positions"), 0u);
  EXPECT_EQ(uploaded(engine.stats(), "media"), kMedium);
  EXPECT_EQ(answers(engine, points), answers(scene, points));
}

TEST(WrongViews, OfTheDeviceAreLookedAtThere) {
  const Given given;
  Engine engine = opencl::makeEngine(given.place());
  const VolumeData data = cloud(VoxelType::Float32);
  std::vector<std::byte> voxels = data.voxels;
  const float bad[] = {INFINITY, 0.0f, std::numeric_limits<float>::quiet_NaN()};
  std::memcpy(voxels.data() + 70 * sizeof(float), bad, sizeof bad);
  const cl::Buffer wrong = given.buffer(voxels), right = given.buffer(data.voxels);
  const auto says = [&](const cl::Buffer& buffer) {
    return errorOf([&] { engine.prepare(sceneOf(opencl::volumeData(buffer(), data.type, data.size))); });
  };
  EXPECT_NE(says(wrong).find("voxel 70 is not finite"), std::string::npos);
  EXPECT_EQ(says(right), "");
}

TEST(WrongViews, AreRefusedWithARemedy) {
  const Given given, other;
  Engine engine = opencl::makeEngine(given.place());
  const VolumeData data = cloud(VoxelType::UInt8);
  const auto says = [&](const std::shared_ptr<const VolumeData>& wrong) {
    return errorOf([&] { engine.prepare(sceneOf(wrong)); });
  };
  VolumeData both = data;
  both.view.data = data.voxels.data();
  EXPECT_NE(says(std::make_shared<VolumeData>(both)).find("must have one"), std::string::npos);
  VolumeData none = data;
  none.voxels.clear();
  EXPECT_NE(says(std::make_shared<VolumeData>(none)).find("0 bytes"), std::string::npos);
  const cl::Buffer foreign = other.buffer(data.voxels), right = given.buffer(data.voxels);
  EXPECT_NE(says(opencl::volumeData(foreign(), data.type, data.size)).find("another context"), std::string::npos);
  EXPECT_NE(says(opencl::volumeData(right(), VoxelType::Float32, data.size)).find("at least"), std::string::npos);
  EXPECT_NE(errorOf([] { opencl::volumeData(nullptr, VoxelType::UInt8, {1, 1, 1}); }).find("null"), std::string::npos);
  const cl::Image2D image(given.context, CL_MEM_READ_ONLY, cl::ImageFormat(CL_RGBA, CL_FLOAT), 64, 64);
  EXPECT_NE(errorOf([&] { opencl::volumeData(image(), data.type, data.size); }).find("must be a buffer"),
            std::string::npos);
  EXPECT_EQ(says(opencl::volumeData(right(), data.type, data.size, data.objectFromIndex)), "");
  EXPECT_EQ(answers(engine, somePoints(50)), answers(cloudScene(), somePoints(50)));
}

}  // namespace
}  // namespace cdsm::embedding
