// SPDX-License-Identifier: Apache-2.0
// Opens a device. In: the user's words and CDSM_DEVICE; out: context, queue, memory account, program cache.
#include "device/device.hpp"

#include <algorithm>
#include <cstdlib>

#include "device/cl_error.hpp"
#include "device/device_list.hpp"
#include "device/program.hpp"

namespace cdsm::device {

namespace {

/// Throws Error unless they belong to each other and commands run in order.
void requireTogether(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue) {
  const std::vector<cl::Device> devices = context.getInfo<CL_CONTEXT_DEVICES>();
  const auto isDevice = [&](const cl::Device& other) { return other() == device(); };
  if (std::none_of(devices.begin(), devices.end(), isDevice))
    throw Error("the given device is not of the given context; give one of the context's CL_CONTEXT_DEVICES");
  if (queue.getInfo<CL_QUEUE_CONTEXT>()() != context() || queue.getInfo<CL_QUEUE_DEVICE>()() != device())
    throw Error("the given queue is not of the given context and device; give one that is, or none");
  if (queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE)
    throw Error("the given queue runs commands out of order; give one in order, or none");
}

}  // namespace

std::vector<DeviceDescription> Device::list() {
  std::vector<DeviceDescription> descriptions;
  for (ListedDevice& device : findDevices()) descriptions.push_back(std::move(device.description));
  return descriptions;
}

std::unique_ptr<Device> Device::open(const std::string& spec, const std::string& fetch) {
  const char* environment = std::getenv("CDSM_DEVICE");
  const std::string wanted = spec.empty() && environment ? environment : spec;
  const std::vector<ListedDevice> devices = findDevices();
  const ListedDevice& chosen = chooseDevice(devices, wanted);
  DeviceDescription description = chosen.description;
  description.fetch = resolveFetch(description, fetch);
  return guarded("opening device " + description.id + " '" + description.name + "'", [&] {
    const cl::Context context(chosen.handle);
    const cl::CommandQueue queue(context, chosen.handle, CL_QUEUE_PROFILING_ENABLE);
    return std::unique_ptr<Device>(new Device(chosen.handle, context, queue, description));
  });
}

std::unique_ptr<Device> Device::adopt(cl_context context, cl_device_id device, cl_command_queue queue,
                                      const std::string& fetch) {
  if (!context || !device) throw Error("context and device are needed to work in; one of them is null");
  return guarded("working in a given context", [&] {
    const cl::Context givenContext(context, true);
    const cl::Device givenDevice(device, true);
    const cl::CommandQueue givenQueue =
        queue ? cl::CommandQueue(queue, true) : cl::CommandQueue(givenContext, givenDevice, CL_QUEUE_PROFILING_ENABLE);
    requireTogether(givenContext, givenDevice, givenQueue);
    DeviceDescription description = describeDevice(givenDevice);
    if (!description.unusable.empty())
      throw Error("device '" + description.name + "' cannot be used: " + description.unusable);
    description.fetch = resolveFetch(description, fetch);
    return std::unique_ptr<Device>(new Device(givenDevice, givenContext, givenQueue, description));
  });
}

Device::Device(const cl::Device& handle, const cl::Context& context, const cl::CommandQueue& queue,
               const DeviceDescription& description)
    : description_(description),
      handle_(handle),
      context_(context),
      queue_(queue),
      sharesHostMemory_(handle.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>()),
      keepsTimes_((queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_PROFILING_ENABLE) != 0),
      account_(std::make_shared<MemoryAccount>()),
      programs_(std::make_unique<ProgramCache>(*this)) {
  if (!keepsTimes_) profiler_.ignoreTimes();
  account_->device = description.name;
  account_->maxAllocationBytes = description.maxAllocationBytes;
  account_->totalBytes = description.memoryBytes;
}

Device::~Device() {
  // Host memory and programs may go away right after this, so nothing may run any longer.
  if (queue_()) clFinish(queue_());
}

void Device::waitFor(const std::vector<cl_event>& events) {
  if (events.empty()) return;
  guarded("waiting for given events", [&] {
    std::vector<cl::Event> list;
    for (cl_event event : events) list.emplace_back(event, true);
    queue_.enqueueBarrierWithWaitList(&list);
  });
}

cl_event Device::mark() {
  return guarded("marking the end of the commands", [&] {
    cl::Event event;
    queue_.enqueueMarkerWithWaitList(nullptr, &event);
    queue_.flush();
    clRetainEvent(event());
    return event();
  });
}

void Device::finish() {
  guarded("waiting for device '" + description_.name + "'", [&] { queue_.finish(); });
}

}  // namespace cdsm::device
