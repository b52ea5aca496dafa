// SPDX-License-Identifier: Apache-2.0
// Volumes in images of the device: of all formats they can have, read where they are or copied, at several time steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "given_place.hpp"

namespace cdsm::embedding {
namespace {

/// A format that images of the context can have for a type of voxels; normalized or not.
struct ImageKind {
  VoxelType type;
  cl_channel_order order;
  cl_channel_type channel;
};
const ImageKind kImageKinds[] = {{VoxelType::UInt8, CL_R, CL_UNORM_INT8},
                                 {VoxelType::UInt8, CL_R, CL_UNSIGNED_INT8},
                                 {VoxelType::Int8, CL_R, CL_SNORM_INT8},
                                 {VoxelType::Int8, CL_R, CL_SIGNED_INT8},
                                 {VoxelType::UInt16, CL_R, CL_UNORM_INT16},
                                 {VoxelType::UInt16, CL_R, CL_UNSIGNED_INT16},
                                 {VoxelType::Int16, CL_R, CL_SNORM_INT16},
                                 {VoxelType::Int16, CL_R, CL_SIGNED_INT16},
                                 {VoxelType::Float32, CL_R, CL_FLOAT},
                                 {VoxelType::UInt8, CL_LUMINANCE, CL_UNORM_INT8},
                                 {VoxelType::UInt16, CL_INTENSITY, CL_UNORM_INT16}};

bool canHave(const Given& given, const ImageKind& kind) {
  std::vector<cl::ImageFormat> formats;
  given.context.getSupportedImageFormats(CL_MEM_READ_ONLY, CL_MEM_OBJECT_IMAGE3D, &formats);
  return std::any_of(formats.begin(), formats.end(), [&](const cl::ImageFormat& format) {
    return format.image_channel_order == kind.order && format.image_channel_data_type == kind.channel;
  });
}

cl::Image3D imageOf(const Given& given, const ImageKind& kind, const VolumeData& data) {
  return {given.context,
          CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
          cl::ImageFormat(kind.order, kind.channel),
          data.size.x,
          data.size.y,
          data.size.z,
          0,
          0,
          const_cast<std::byte*>(data.voxels.data())};
}

/// The transfers of voxels, but for that to a buffer in which they are looked at.
std::string copiedBy(const FrameStats& stats) {
  std::string list;
  for (const KernelTime& kernel : stats.kernels)
    if (kernel.name == "upload voxels" || kernel.name == "fill voxels") list += kernel.name + ";";
  return list;
}

/// Textures are read in place or filled on the device; signed voxels become unsigned ones on the host.
std::string expectedCopies(const ImageKind& kind, const std::string& fetch) {
  if (fetch == "buffer") return "";
  if (kind.type == VoxelType::Int8 || kind.type == VoxelType::Int16) return "upload voxels;";
  const bool normalized = kind.channel != CL_UNSIGNED_INT8 && kind.channel != CL_UNSIGNED_INT16;
  return kind.order == CL_R && normalized ? "" : "fill voxels;";
}

TEST(VolumeImages, AnswerAsVoxelsOfTheHost) {
  const Given given;
  const auto points = somePoints(300);
  int kinds = 0;
  for (const char* fetch : {"buffer", "image"}) {
    EngineOptions options;
    options.fetch = fetch;
    Engine engine = opencl::makeEngine(given.place(), options), other = opencl::makeEngine(given.place(), options);
    for (const ImageKind& kind : kImageKinds) {
      if (!canHave(given, kind)) continue;
      ++kinds;
      const VolumeData data = cloud(kind.type), later = cloud(kind.type, 5.0f);
      const cl::Image3D image = imageOf(given, kind, data);
      Scene scene = sceneOf(opencl::volumeData(image(), data.objectFromIndex));
      engine.prepare(scene);
      EXPECT_EQ(copiedBy(engine.stats()), expectedCopies(kind, fetch))
          << fetch << int(kind.type) << "/" << kind.channel;
      other.prepare(sceneOf(std::make_shared<VolumeData>(data)));
      EXPECT_EQ(answers(engine, points), answers(other, points)) << fetch << int(kind.type) << "/" << kind.channel;
      given.queue.enqueueWriteImage(image, CL_TRUE, {0, 0, 0}, {data.size.x, data.size.y, data.size.z}, 0, 0,
                                    later.voxels.data());
      ++scene.volumes.front().revision;
      engine.prepare(scene);
      other.prepare(sceneOf(std::make_shared<VolumeData>(later)));
      EXPECT_EQ(answers(engine, points), answers(other, points)) << fetch << int(kind.type) << "/" << kind.channel;
    }
  }
  if (kinds == 0) GTEST_SKIP() << "the device has no 3D images of one channel";
}

TEST(VolumeImages, OfOtherKindsAreRefusedWithARemedy) {
  const Given given, other;
  Engine engine = opencl::makeEngine(given.place());
  const VolumeData data = cloud(VoxelType::UInt8);
  const ImageKind kind{VoxelType::UInt8, CL_R, CL_UNORM_INT8};
  if (!canHave(given, kind)) GTEST_SKIP() << "the device has no such images";
  const auto says = [&](const cl::Memory& memory) { return errorOf([&] { opencl::volumeData(memory()); }); };
  EXPECT_NE(says(given.buffer(data.voxels)).find("none of three dimensions"), std::string::npos);
  EXPECT_NE(errorOf([] { opencl::volumeData(nullptr); }).find("null"), std::string::npos);
  const cl::Image3D colored(given.context, CL_MEM_READ_ONLY, cl::ImageFormat(CL_RGBA, CL_UNORM_INT8), 4, 4, 4);
  EXPECT_NE(says(colored).find("other channels than one"), std::string::npos);
  const cl::Image3D halves(given.context, CL_MEM_READ_ONLY, cl::ImageFormat(CL_R, CL_HALF_FLOAT), 4, 4, 4);
  EXPECT_NE(says(halves).find("must be integers of 8 or 16 bits or floats"), std::string::npos);
  const auto prepared = [&](const std::shared_ptr<const VolumeData>& wrong) {
    return errorOf([&] { engine.prepare(sceneOf(wrong)); });
  };
  const cl::Image3D foreign = imageOf(other, kind, data), right = imageOf(given, kind, data);
  EXPECT_NE(prepared(opencl::volumeData(foreign())).find("another context"), std::string::npos);
  const auto resized = opencl::volumeData(right(), data.objectFromIndex);
  resized->size.x += 1;
  EXPECT_NE(prepared(resized).find("must have 14 x 11 x 12"), std::string::npos) << prepared(resized);
  const auto retyped = opencl::volumeData(right(), data.objectFromIndex);
  retyped->type = VoxelType::Int8;  // the same bytes, seen as others
  VolumeData wanted = data;
  wanted.type = VoxelType::Int8;
  const auto points = somePoints(100);
  for (const char* fetch : {"buffer", "image"}) {
    EngineOptions options;
    options.fetch = fetch;
    Engine a = opencl::makeEngine(given.place(), options), b = opencl::makeEngine(given.place(), options);
    a.prepare(sceneOf(retyped));
    b.prepare(sceneOf(std::make_shared<VolumeData>(wanted)));
    EXPECT_EQ(answers(a, points), answers(b, points)) << fetch;
  }
  EXPECT_EQ(prepared(opencl::volumeData(right(), data.objectFromIndex)), "");
  EXPECT_EQ(answers(engine, somePoints(50)), answers(cloudScene(), somePoints(50)));
}

}  // namespace
}  // namespace cdsm::embedding
