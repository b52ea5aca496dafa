// SPDX-License-Identifier: Apache-2.0
// Launches. In: a kernel with its arguments set, a launch; out: an enqueued and recorded command, or DeviceError.
#include "device/kernel.hpp"

#include "device/cl_error.hpp"

namespace cdsm::device {
namespace {

std::string rangeText(const cl::NDRange& range) {
  std::string text;
  for (std::size_t axis = 0; axis < range.dimensions(); ++axis) {
    text += (axis ? " x " : "") + std::to_string(range.get()[axis]);
  }
  return text;
}

bool isEmpty(const cl::NDRange& range) {
  for (std::size_t axis = 0; axis < range.dimensions(); ++axis) {
    if (range.get()[axis] == 0) return true;
  }
  return range.dimensions() == 0;
}

std::uint64_t itemsOf(const cl::NDRange& range) {
  std::uint64_t items = 1;
  for (std::size_t axis = 0; axis < range.dimensions(); ++axis) items *= range.get()[axis];
  return items;
}

/// `global` rounded up to whole work groups.
cl::NDRange wholeGroups(const cl::NDRange& global, const cl::NDRange& local) {
  std::size_t size[3] = {1, 1, 1};
  for (std::size_t axis = 0; axis < global.dimensions(); ++axis) {
    const std::size_t group = local.get()[axis];
    size[axis] = (global.get()[axis] + group - 1) / group * group;
  }
  if (global.dimensions() == 1) return cl::NDRange(size[0]);
  if (global.dimensions() == 2) return cl::NDRange(size[0], size[1]);
  return cl::NDRange(size[0], size[1], size[2]);
}

}  // namespace

KernelBase::KernelBase(Device& device, const cl::Program& program, const char* function)
    : device_(&device),
      function_(function),
      kernel_(guarded("kernel " + function_, [&] { return cl::Kernel(program, function); })) {}

void KernelBase::checkCount(cl_uint given) const {
  const cl_uint wanted = guarded("kernel " + function_, [&] { return kernel_.getInfo<CL_KERNEL_NUM_ARGS>(); });
  if (given == wanted) return;
  throw DeviceError("kernel " + function_ + " takes " + std::to_string(wanted) + " arguments, but gets " +
                    std::to_string(given));
}

void KernelBase::bind(cl_uint& index, const ArgumentList& list) {
  for (const cl::Memory& memory : list) setArgument(index++, memory);
}

void KernelBase::failArgument(cl_uint index, const cl::Error& error) const {
  throw deviceError(error, "argument " + std::to_string(index) + " of kernel " + function_);
}

void KernelBase::enqueue(const Launch& launch) {
  if (isEmpty(launch.global)) return;
  const std::string doing = "launch '" + std::string(launch.name) + "' of kernel " + function_ + " (" +
                            rangeText(launch.global) + " items in groups of " + rangeText(launch.local) + ")";
  if (launch.local.dimensions() != launch.global.dimensions() || isEmpty(launch.local)) {
    throw DeviceError(doing + ": the group needs as many dimensions as the items, each at least 1");
  }
  cl::Event event;
  guarded(doing, [&] {
    device_->queue().enqueueNDRangeKernel(kernel_, cl::NullRange, wholeGroups(launch.global, launch.local),
                                          launch.local, nullptr, &event);
  });
  device_->profiler().record(launch.name, event, {0, itemsOf(launch.global)});
}

}  // namespace cdsm::device
