// SPDX-License-Identifier: Apache-2.0
// What opencl.hpp promises.
#include <cdsm/opencl.hpp>

#include "device/cl_error.hpp"
#include "device/picture_target.hpp"
#include "device/program.hpp"
#include "engine/engine_impl.hpp"

namespace cdsm::opencl {

namespace {

using Floats = device::Buffer<float>;

/// Points without points need no buffers.
Floats adoptFloats(device::Device& device, cl_mem buffer, std::size_t count, const char* name) {
  return count > 0 ? Floats::adopt(device, buffer, count, name) : Floats(device, 0, name);
}

/// Floats from the first point to the end of the last one. Throws Error for a wrong stride or too many points.
std::size_t coordinatesOf(const Points& points) {
  if (points.stride < 3 || points.stride > 0xffffffffu)
    throw Error("the stride of the points is " + std::to_string(points.stride) + " floats, must be at least 3");
  if (points.count == 0) return 0;
  if (points.count - 1 > (device::kAll / sizeof(float) - 3) / points.stride)
    throw Error(std::to_string(points.count) + " points at a stride of " + std::to_string(points.stride) +
                " floats fit no memory");
  return (points.count - 1) * points.stride + 3;
}

/// Retained as long as the result lives. `what` begins the message.
std::shared_ptr<void> retained(cl_mem memory, const std::string& what) {
  if (!memory) throw Error(what + " is null, must have its voxels");
  if (clRetainMemObject(memory) != CL_SUCCESS) throw Error(what + " is no OpenCL memory object");
  return {memory, [](void* held) { clReleaseMemObject(static_cast<cl_mem>(held)); }};
}

/// The type that voxels of an image of this format have. Throws Error if there is none.
VoxelType voxelTypeOf(const cl_image_format& format) {
  const cl_channel_order order = format.image_channel_order;
  if (order != CL_R && order != CL_LUMINANCE && order != CL_INTENSITY)
    throw Error("the image of a volume has other channels than one, must be of CL_R, CL_LUMINANCE or CL_INTENSITY");
  switch (format.image_channel_data_type) {
    case CL_UNORM_INT8:
    case CL_UNSIGNED_INT8:
      return VoxelType::UInt8;
    case CL_SNORM_INT8:
    case CL_SIGNED_INT8:
      return VoxelType::Int8;
    case CL_UNORM_INT16:
    case CL_UNSIGNED_INT16:
      return VoxelType::UInt16;
    case CL_SNORM_INT16:
    case CL_SIGNED_INT16:
      return VoxelType::Int16;
    case CL_FLOAT:
      return VoxelType::Float32;
    default:
      throw Error("the image of a volume has channels of an unknown type, must be integers of 8 or 16 bits or floats");
  }
}

}  // namespace

Engine makeEngine(const Place& place, const EngineOptions& options) {
  if (!options.device.empty())
    throw Error("options name the device '" + options.device + "', but it is given already; leave the name empty");
  return EngineAccess::make(options, device::Device::adopt(place.context, place.device, place.queue, options.fetch));
}

Place placeOf(const Engine& engine) {
  const device::Device& device = EngineAccess::frame(engine).device();
  return {device.context()(), device.handle()(), device.queue()()};
}

std::shared_ptr<VolumeData> volumeData(cl_mem buffer, VoxelType type, const glm::uvec3& size,
                                       const glm::mat4& objectFromIndex) {
  auto data = std::make_shared<VolumeData>();
  data->view.deviceMemory = retained(buffer, "the buffer of a volume");
  device::guarded("the buffer of a volume", [&] {
    if (cl::Buffer(buffer, true).getInfo<CL_MEM_TYPE>() != CL_MEM_OBJECT_BUFFER)
      throw Error("the buffer of a volume is an image, must be a buffer; images come without type and size");
  });
  data->type = type;
  data->size = size;
  data->objectFromIndex = objectFromIndex;
  return data;
}

std::shared_ptr<VolumeData> volumeData(cl_mem image, const glm::mat4& objectFromIndex) {
  auto data = std::make_shared<VolumeData>();
  data->view.deviceMemory = retained(image, "the image of a volume");
  data->objectFromIndex = objectFromIndex;
  device::guarded("the image of a volume", [&] {
    const cl::Image3D given(image, true);
    if (given.getInfo<CL_MEM_TYPE>() != CL_MEM_OBJECT_IMAGE3D)
      throw Error("the image of a volume is none of three dimensions; a buffer comes with its type and size");
    data->type = voxelTypeOf(given.getImageInfo<CL_IMAGE_FORMAT>());
    data->size = {given.getImageInfo<CL_IMAGE_WIDTH>(), given.getImageInfo<CL_IMAGE_HEIGHT>(),
                  given.getImageInfo<CL_IMAGE_DEPTH>()};
  });
  return data;
}

void transmittance(Engine& engine, const std::string& light, const Points& points, cl_mem values, const Order& order) {
  engine::FrameState& frame = EngineAccess::frame(engine);
  device::Device& device = frame.device();
  const std::size_t number = engine::lightNumber(engine::lightNames(frame.readyScene()), light);
  const Floats coordinates = adoptFloats(device, points.buffer, coordinatesOf(points), "points");
  const std::size_t channels = engine::channelsOf(frame.readyScene());
  const Floats results = adoptFloats(device, values, channels * points.count, "transmittances");
  frame.query(number, {coordinates, points.count, points.stride}, results, order.after, order.done);
}

void render(Engine& engine, const Scene& scene, cl_mem target) {
  engine::FrameState& frame = EngineAccess::frame(engine);
  frame.check(scene);
  device::PictureTarget picture(frame.device(), target, scene.image.width, scene.image.height);
  std::vector<glm::vec4> pixels(std::size_t(scene.image.width) * std::size_t(scene.image.height));
  frame.render(scene, pixels.data());
  picture.write(pixels.data());
}

struct Lookup::Impl {
  engine::Lookup lookup;
  std::string buildOptions;
};

Lookup::Lookup(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Lookup::~Lookup() = default;
Lookup::Lookup(Lookup&&) noexcept = default;
Lookup& Lookup::operator=(Lookup&&) noexcept = default;

const std::string& Lookup::source() const { return impl_->lookup.source; }
const std::string& Lookup::buildOptions() const { return impl_->buildOptions; }

unsigned Lookup::light(const std::string& name) const {
  return unsigned(engine::lightNumber(impl_->lookup.lights, name));
}

cl_uint Lookup::setArguments(cl_kernel kernel, cl_uint first) const {
  return impl_->lookup.arguments.set(kernel, first);
}

Lookup lookup(Engine& engine) {
  auto impl = std::make_unique<Lookup::Impl>();
  impl->lookup = EngineAccess::frame(engine).lookup();
  impl->buildOptions = device::kBuildOptions;
  return Lookup(std::move(impl));
}

}  // namespace cdsm::opencl
