// SPDX-License-Identifier: Apache-2.0
// An embedder's own OpenCL, as the tests of opencl.hpp use it: the device of the other tests, a context, a queue.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <CL/opencl.hpp>
#include <cdsm/opencl.hpp>

namespace cdsm::embedding {

/// The device that an engine would choose.
cl::Device chosenDevice();

struct Given {
  explicit Given(cl_command_queue_properties properties = CL_QUEUE_PROFILING_ENABLE)
      : device(chosenDevice()), context(device), queue(context, device, properties) {}

  opencl::Place place() const { return {context(), device(), queue()}; }
  template <class T>
  cl::Buffer buffer(const std::vector<T>& values) const {
    const cl_mem_flags flags = CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR;
    return cl::Buffer(context, flags, values.size() * sizeof(T), const_cast<T*>(values.data()));
  }
  template <class T>
  std::vector<T> read(const cl::Buffer& buffer) const {
    std::vector<T> values(buffer.getInfo<CL_MEM_SIZE>() / sizeof(T));
    queue.enqueueReadBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(T), values.data());
    return values;
  }

  cl::Device device;
  cl::Context context;
  cl::CommandQueue queue;
};

/// A cloud between a lamp "key" and a floor.
Scene cloudScene();
/// The cloud's voxels; t: how far it has drifted.
VolumeData cloud(VoxelType type, float t = 0.0f);
/// The same scene with other voxels, whose largest value is of most opacity.
Scene sceneOf(const std::shared_ptr<const VolumeData>& data);
/// Points all over the scene, in shadow and out of it.
std::vector<glm::vec3> somePoints(std::size_t count);

/// By a new engine.
std::vector<float> answers(const Scene& scene, const std::vector<glm::vec3>& points);
/// By one that has been given a scene.
std::vector<float> answers(Engine& engine, const std::vector<glm::vec3>& points);

/// Bytes of uploads of that name in the last call.
std::uint64_t uploaded(const FrameStats& stats, const std::string& what);

/// That what give() gives the engine is kept until the engine is told to let go, or given another scene.
template <class Give>
void expectKeptUntilDropped(Engine& engine, const std::weak_ptr<const void>& owner, const Give& give) {
  give();
  EXPECT_FALSE(owner.expired());
  engine.drop();
  EXPECT_TRUE(owner.expired());
  give();
  engine.prepare(cloudScene());
  EXPECT_TRUE(owner.expired());
}

/// What was thrown, or nothing.
template <class Call>
std::string errorOf(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace cdsm::embedding
