// SPDX-License-Identifier: Apache-2.0
// Every OpenCL device of the machine, with handles. In: nothing but the installed platforms; out: the list that
// Device::list() shows and Device::open() chooses from.
#pragma once

#include <string>
#include <vector>

#include <CL/opencl.hpp>
#include <cdsm/cdsm.hpp>

namespace cdsm::device {

struct ListedDevice {
  cl::Device handle;
  DeviceDescription description;
};

/// Platforms without devices and platforms or devices that fail to describe themselves are passed over.
std::vector<ListedDevice> findDevices();

/// What a device is, with its id among findDevices().
DeviceDescription describeDevice(const cl::Device& device);

/// The device that `spec` means ("P:D", part of a name, empty: the first usable). Throws Error that lists what exists.
const ListedDevice& chooseDevice(const std::vector<ListedDevice>& devices, const std::string& spec);

/// "image" or "buffer" for a fetch of auto, buffer or image. Throws Error for another word, or image without images.
std::string resolveFetch(const DeviceDescription& description, const std::string& fetch);

}  // namespace cdsm::device
