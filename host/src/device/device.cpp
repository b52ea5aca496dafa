// SPDX-License-Identifier: Apache-2.0
// Opens a device. In: the user's words and CDSM_DEVICE; out: context, queue, memory account, program cache.
#include "device/device.hpp"

#include <cstdlib>

#include "device/cl_error.hpp"
#include "device/device_list.hpp"
#include "device/program.hpp"

namespace cdsm::device {

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
  return guarded("opening device " + description.id + " '" + description.name + "'",
                 [&] { return std::unique_ptr<Device>(new Device(chosen.handle, description)); });
}

Device::Device(const cl::Device& handle, const DeviceDescription& description)
    : description_(description),
      handle_(handle),
      context_(handle),
      queue_(context_, handle, CL_QUEUE_PROFILING_ENABLE),
      account_(std::make_shared<MemoryAccount>()),
      programs_(std::make_unique<ProgramCache>(*this)) {
  account_->device = description.name;
  account_->maxAllocationBytes = description.maxAllocationBytes;
  account_->totalBytes = description.memoryBytes;
}

Device::~Device() {
  // Host memory and programs may go away right after this, so nothing may run any longer.
  if (queue_()) clFinish(queue_());
}

void Device::finish() {
  guarded("waiting for device '" + description_.name + "'", [&] { queue_.finish(); });
}

}  // namespace cdsm::device
