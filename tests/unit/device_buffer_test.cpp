// SPDX-License-Identifier: Apache-2.0
// Buffers, textures and the account of device memory, on the default device.
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "device/buffer.hpp"
#include "device/device.hpp"
#include "device/kernel.hpp"
#include "device/program.hpp"
#include "device/texture.hpp"

namespace cdsm::device {
namespace {

class DeviceBufferTest : public ::testing::Test {
 protected:
  std::unique_ptr<Device> device_ = Device::open();
};

TEST_F(DeviceBufferTest, bringsBackWhatWasUploaded) {
  std::vector<int> values(1000);
  std::iota(values.begin(), values.end(), 5);
  Buffer<int> buffer = Buffer<int>::fromHost(*device_, values, "values");
  EXPECT_EQ(buffer.download(), values);
  EXPECT_EQ(buffer.download(3, 10), (std::vector<int>{15, 16, 17}));
  EXPECT_EQ(buffer.read(999), 1004);
  const int change = -1;
  buffer.upload(&change, 1, 42);
  EXPECT_EQ(buffer.read(42), -1);
  EXPECT_EQ(buffer.bytes(), 4000u);
}

TEST_F(DeviceBufferTest, fillsWithPatternsOfSeveralSizes) {
  struct Pair {
    int first;
    float second;
  };
  Buffer<Pair> pairs(*device_, 9, "pairs");
  pairs.fill({3, 0.5f});
  EXPECT_EQ(pairs.read(8).first, 3);
  EXPECT_EQ(pairs.read(8).second, 0.5f);
  Buffer<unsigned char> bytes(*device_, 5, "bytes");
  bytes.fill(200);
  EXPECT_EQ(bytes.download(), std::vector<unsigned char>(5, 200));
}

TEST_F(DeviceBufferTest, acceptsNoElements) {
  Buffer<float> buffer(*device_, 0, "nothing");
  EXPECT_EQ(buffer.size(), 0u);
  EXPECT_NE(buffer.cl()(), nullptr);
  EXPECT_TRUE(buffer.download().empty());
  buffer.upload({});
  buffer.fill(1.0f);
  EXPECT_FALSE(Buffer<float>().allocated());
}

TEST_F(DeviceBufferTest, growsOnlyWhenTooSmall) {
  Buffer<int> buffer(*device_, 10, "growing");
  EXPECT_FALSE(buffer.reserve(10));
  EXPECT_TRUE(buffer.reserve(11));
  EXPECT_EQ(buffer.size(), 11u);
  buffer.fill(4);
  EXPECT_EQ(buffer.read(10), 4);
  EXPECT_EQ(device_->usedBytes(), 44u);
}

TEST_F(DeviceBufferTest, givesItsBytesBack) {
  {
    Buffer<int> first(*device_, 100, "first");
    Buffer<int> second(*device_, 50, "second");
    EXPECT_EQ(device_->usedBytes(), 600u);
    first = std::move(second);
    EXPECT_EQ(device_->usedBytes(), 200u);
    EXPECT_EQ(first.size(), 50u);
    EXPECT_EQ(second.size(), 0u);
  }
  EXPECT_EQ(device_->usedBytes(), 0u);
}

TEST_F(DeviceBufferTest, refusesMoreThanOneAllocationCanHold) {
  const std::uint64_t tooMany = device_->maxAllocationBytes() + 1;
  try {
    Buffer<char> buffer(*device_, tooMany, "huge");
    FAIL() << "no error";
  } catch (const DeviceError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'huge'"), std::string::npos) << message;
    EXPECT_NE(message.find(std::to_string(tooMany)), std::string::npos) << message;
    EXPECT_NE(message.find(std::to_string(tooMany - 1)), std::string::npos) << message;
  }
  EXPECT_THROW(Buffer<double>(*device_, kAll / 2, "overflow"), DeviceError);
  EXPECT_EQ(device_->usedBytes(), 0u);
}

TEST_F(DeviceBufferTest, staysUsableWhenGrowingFails) {
  Buffer<char> buffer(*device_, 10, "growing");
  EXPECT_THROW(buffer.reserve(device_->maxAllocationBytes() + 1), DeviceError);
  EXPECT_EQ(buffer.size(), 0u);
  EXPECT_TRUE(buffer.reserve(4));
  buffer.fill('x');
  EXPECT_EQ(buffer.read(3), 'x');
}

TEST_F(DeviceBufferTest, refusesRangesPastTheEnd) {
  Buffer<int> buffer(*device_, 10, "short");
  EXPECT_THROW(buffer.read(10), DeviceError);
  EXPECT_THROW(buffer.download(5, 6), DeviceError);
  EXPECT_THROW(buffer.download(kAll, 11), DeviceError);
  EXPECT_THROW(buffer.upload(std::vector<int>(11)), DeviceError);
}

TEST(MemoryAccountTest, countsAllAllocationsOfADevice) {
  auto account = std::make_shared<MemoryAccount>();
  account->device = "small";
  account->maxAllocationBytes = 60;
  account->totalBytes = 100;
  MemoryClaim first(account, 60, "first");
  EXPECT_THROW(MemoryClaim(account, 41, "second"), DeviceError);
  EXPECT_THROW(MemoryClaim(account, 61, "third"), DeviceError);
  EXPECT_EQ(account->usedBytes, 60u);
  first = MemoryClaim();
  EXPECT_EQ(account->usedBytes, 0u);
}

/// Reads texel (x, y, z) of a volume and texel (x, y) of nodes with samplers that need no linear filter.
const char* const kReadTextures = R"(
constant sampler_t nearest = CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_NEAREST;
kernel void readVolume(int4 texel, read_only image3d_t volume, global float* out) {
  out[0] = read_imagef(volume, nearest, texel).x;
}
kernel void readNode(int2 texel, read_only image2d_t nodes, global float4* out) {
  out[0] = read_imagef(nodes, nearest, texel);
}
)";

class TextureTest : public DeviceBufferTest {
 protected:
  void SetUp() override {
    if (!device_->description().images) GTEST_SKIP() << "the device has no images";
  }
  const cl::Program& program() { return device_->programs().get({"test/t.cl", {}, {{"test/t.cl", kReadTextures}}}); }
};

TEST_F(TextureTest, holdsVoxels) {
  const std::vector<unsigned char> voxels{0, 51, 102, 153, 204, 255};
  VolumeTexture texture(*device_, CL_UNORM_INT8, {3, 2, 1}, voxels.data(), voxels.size(), "voxels");
  Buffer<float> out(*device_, 1, "out");
  Kernel<cl_int4, VolumeTexture, Buffer<float>> kernel(*device_, program(), "readVolume");
  kernel({"read volume", cl::NDRange(1), cl::NDRange(1)}, cl_int4{{1, 1, 0, 0}}, texture, out);
  EXPECT_NEAR(out.read(0), 204.0f / 255.0f, 1e-6f);
}

TEST_F(TextureTest, holdsNodesFromABuffer) {
  std::vector<float> nodes(4 * 3 * 2);
  std::iota(nodes.begin(), nodes.end(), 0.0f);
  Buffer<float> source = Buffer<float>::fromHost(*device_, nodes, "nodes");
  NodeTexture texture(*device_, 3, 2, "nodes");
  texture.fill(source.cl());
  Buffer<cl_float4> out(*device_, 1, "out");
  Kernel<cl_int2, NodeTexture, Buffer<cl_float4>> kernel(*device_, program(), "readNode");
  kernel({"read node", cl::NDRange(1), cl::NDRange(1)}, cl_int2{{2, 1}}, texture, out);
  EXPECT_EQ(out.read(0).s[0], 20.0f);
  EXPECT_THROW(texture.fill(source.cl(), 16), DeviceError);
}

TEST_F(TextureTest, refusesWhatTheDeviceCannotHold) {
  const float voxel = 1.0f;
  EXPECT_THROW(VolumeTexture(*device_, CL_FLOAT, {1 << 20, 1, 1}, &voxel, 4, "wide"), DeviceError);
  EXPECT_THROW(VolumeTexture(*device_, CL_FLOAT, {0, 1, 1}, &voxel, 0, "empty"), DeviceError);
  EXPECT_THROW(VolumeTexture(*device_, CL_FLOAT, {2, 1, 1}, &voxel, 4, "truncated"), DeviceError);
  EXPECT_FALSE(VolumeTexture::obstacle(*device_, CL_FLOAT, {1 << 20, 1, 1}).empty());
  EXPECT_THROW(NodeTexture(*device_, NodeTexture::maxSize(*device_)[0] + 1, 1, "wide"), DeviceError);
}

}  // namespace
}  // namespace cdsm::device
