// SPDX-License-Identifier: Apache-2.0
// Launches, their errors and their times, on the default device.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "device/buffer.hpp"
#include "device/cl_error.hpp"
#include "device/device.hpp"
#include "device/kernel.hpp"
#include "device/program.hpp"

namespace cdsm::device {
namespace {

/// The host's view of the struct in kText.
struct ScaleParams {
  cl_float4 offset;
  cl_int count;
  cl_float scale;
  cl_int padding[2];
};

const char* const kText = R"(
typedef struct { float4 offset; int count; float scale; int padding[2]; } ScaleParams;
kernel void scaleIndices(ScaleParams params, global float* out) {
  const int i = get_global_id(0);
  if (i < params.count) out[i] = params.offset.w + params.scale * i;
}
kernel void addUp(int count, global const int* a, global const int* b, global int* out, local int* scratch) {
  const int i = get_global_id(0);
  scratch[get_local_id(0)] = i < count ? a[i] + b[i] : 0;
  barrier(CLK_LOCAL_MEM_FENCE);
  if (i < count) out[i] = scratch[get_local_id(0)];
}
)";

class DeviceKernelTest : public ::testing::Test {
 protected:
  std::unique_ptr<Device> device_ = Device::open();
  const cl::Program& program() { return device_->programs().get({"test/k.cl", {}, {{"test/k.cl", kText}}}); }
};

std::string deviceErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}

TEST_F(DeviceKernelTest, passesAStructAndRoundsTheItemsUp) {
  Buffer<float> out(*device_, 10, "out");
  Kernel<ScaleParams, Buffer<float>> kernel(*device_, program(), "scaleIndices");
  kernel({"scale", cl::NDRange(10), cl::NDRange(8)}, ScaleParams{{{0, 0, 0, 100.0f}}, 10, 0.5f, {}}, out);
  EXPECT_EQ(out.read(0), 100.0f);
  EXPECT_EQ(out.read(9), 104.5f);
}

TEST_F(DeviceKernelTest, spreadsAnArgumentList) {
  Buffer<int> a = Buffer<int>::fromHost(*device_, {1, 2, 3}, "a");
  Buffer<int> b = Buffer<int>::fromHost(*device_, {10, 20, 30}, "b");
  Buffer<int> out(*device_, 3, "out");
  Kernel<cl_int, ArgumentList, cl::LocalSpaceArg> kernel(*device_, program(), "addUp");
  const Launch launch{"add", cl::NDRange(3), cl::NDRange(4)};
  kernel(launch, 3, ArgumentList{a.cl(), b.cl(), out.cl()}, cl::Local(4 * sizeof(cl_int)));
  EXPECT_EQ(out.download(), (std::vector<int>{11, 22, 33}));
  EXPECT_THROW(kernel(launch, 3, ArgumentList{a.cl(), b.cl()}, cl::Local(16)), DeviceError);
}

TEST_F(DeviceKernelTest, refusesAWrongNumberOfArgumentsAndUnknownKernels) {
  using TooFew = Kernel<ScaleParams>;
  const std::string message = deviceErrorOf([&] { TooFew(*device_, program(), "scaleIndices"); });
  EXPECT_NE(message.find("scaleIndices takes 2 arguments, but gets 1"), std::string::npos) << message;
  EXPECT_NE(deviceErrorOf([&] { TooFew(*device_, program(), "noKernel"); }).find("CL_INVALID_KERNEL_NAME"),
            std::string::npos);
}

TEST_F(DeviceKernelTest, namesLaunchKernelAndCodeOfAFailure) {
  Buffer<float> out(*device_, 1, "out");
  Kernel<ScaleParams, Buffer<float>> kernel(*device_, program(), "scaleIndices");
  const std::size_t tooLarge = device_->handle().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() * 2;
  const std::string message = deviceErrorOf([&] {
    kernel({"scale", cl::NDRange(1), cl::NDRange(tooLarge)}, ScaleParams{}, out);
  });
  for (const char* part : {"'scale'", "scaleIndices", "clEnqueueNDRangeKernel", "CL_INVALID_WORK_"}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_NE(deviceErrorOf([&] { kernel({"scale", cl::NDRange(1), cl::NullRange}, ScaleParams{}, out); }), "");
}

TEST_F(DeviceKernelTest, launchesNothingForNoItems) {
  Buffer<float> out(*device_, 1, "out");
  Kernel<ScaleParams, Buffer<float>> kernel(*device_, program(), "scaleIndices");
  kernel({"scale", cl::NDRange(8, 0), cl::NDRange(8, 1)}, ScaleParams{}, out);
  EXPECT_TRUE(device_->profiler().kernels().empty());
}

TEST_F(DeviceKernelTest, sumsTimesByNameAndGroup) {
  Profiler& profiler = device_->profiler();
  Buffer<float> out(*device_, 1 << 10, "out");
  Kernel<ScaleParams, Buffer<float>> kernel(*device_, program(), "scaleIndices");
  profiler.beginGroup("first");
  const Launch launch{"scale", cl::NDRange(1 << 10), cl::NDRange(64)};
  for (int i = 0; i < 300; ++i) kernel(launch, ScaleParams{{}, 1 << 10, 1.0f, {}}, out);
  profiler.beginGroup("second");
  kernel(launch, ScaleParams{{}, 1, 1.0f, {}}, out);
  out.fill(0.0f);
  const std::vector<KernelTime> times = profiler.kernels();
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].name, "scale");
  EXPECT_EQ(times[0].launches, 301u);
  EXPECT_EQ(times[1].name, "fill out");
  EXPECT_GT(profiler.groupMilliseconds("first"), 0.0);
  EXPECT_NEAR(profiler.groupMilliseconds("first") + profiler.groupMilliseconds("second"),
              times[0].milliseconds + times[1].milliseconds, 1e-9);
  EXPECT_EQ(profiler.groupMilliseconds("third"), 0.0);
  profiler.reset();
  EXPECT_TRUE(profiler.kernels().empty());
  EXPECT_EQ(profiler.group(), "second");
}

TEST(ClErrorTest, knowsTheNamesOfCodes) {
  EXPECT_STREQ(clErrorName(-5), "CL_OUT_OF_RESOURCES");
  EXPECT_STREQ(clErrorName(-68), "CL_INVALID_DEVICE_PARTITION_COUNT");
  EXPECT_STREQ(clErrorName(-12345), "unknown code");
}

}  // namespace
}  // namespace cdsm::device
