// SPDX-License-Identifier: Apache-2.0
// What opencl.hpp promises.
#include <cdsm/opencl.hpp>

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
  if (!buffer) throw Error("the buffer of a volume is null, must have its voxels");
  if (clRetainMemObject(buffer) != CL_SUCCESS) throw Error("the buffer of a volume is no OpenCL memory object");
  auto data = std::make_shared<VolumeData>();
  data->view.deviceBuffer =
      std::shared_ptr<void>(buffer, [](void* held) { clReleaseMemObject(static_cast<cl_mem>(held)); });
  data->type = type;
  data->size = size;
  data->objectFromIndex = objectFromIndex;
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
