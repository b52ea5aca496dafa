// SPDX-License-Identifier: Apache-2.0
// Finds devices and chooses one. In: the installed platforms and the user's words; out: a device and its description.
#include "device/device_list.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>

#include <cdsm/error.hpp>

namespace cdsm::device {
namespace {

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool contains(const std::string& text, const std::string& part) {
  return lowered(text).find(lowered(part)) != std::string::npos;
}

std::string typeName(cl_device_type type) {
  if (type & CL_DEVICE_TYPE_CPU) return "cpu";
  if (type & CL_DEVICE_TYPE_GPU) return "gpu";
  if (type & CL_DEVICE_TYPE_ACCELERATOR) return "accelerator";
  return "other";
}

/// True for "OpenCL 1.2 ..." and later.
bool speaksOpenCl12(const std::string& version) {
  int major = 0;
  int minor = 0;
  if (std::sscanf(version.c_str(), "OpenCL %d.%d", &major, &minor) != 2) return false;
  return major > 1 || (major == 1 && minor >= 2);
}

/// Empty, or why the engine cannot run on the device.
std::string obstacle(const cl::Device& device, const std::string& version) {
  if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "it is not available";
  if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "it has no compiler for OpenCL C";
  if (!speaksOpenCl12(version)) return "OpenCL 1.2 is needed, it has '" + version + "'";
  if (!device.getInfo<CL_DEVICE_ENDIAN_LITTLE>()) return "it is not little-endian";
  return "";
}

/// Volumes and maps are read faster through images on GPUs and on rusticl, through buffers on other CPU devices.
std::string autoFetch(const DeviceDescription& description) {
  if (!description.images) return "buffer";
  return description.type != "cpu" || contains(description.platform, "rusticl") ? "image" : "buffer";
}

DeviceDescription describe(const cl::Device& device, const std::string& platform, const std::string& id) {
  DeviceDescription description;
  description.id = id;
  description.platform = platform;
  description.name = device.getInfo<CL_DEVICE_NAME>();
  description.version = device.getInfo<CL_DEVICE_VERSION>();
  description.type = typeName(device.getInfo<CL_DEVICE_TYPE>());
  description.computeUnits = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  description.memoryBytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  description.maxAllocationBytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  description.localMemoryBytes = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
  description.images = device.getInfo<CL_DEVICE_IMAGE_SUPPORT>();
  description.fetch = autoFetch(description);
  description.unusable = obstacle(device, description.version);
  return description;
}

std::vector<cl::Platform> platforms() {
  std::vector<cl::Platform> found;
  try {
    cl::Platform::get(&found);
  } catch (const cl::Error&) {
    found.clear();  // no platform at all is an error code, not an empty list
  }
  return found;
}

void appendDevices(const cl::Platform& platform, std::size_t platformIndex, std::vector<ListedDevice>& devices) {
  std::vector<cl::Device> handles;
  std::string name;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &handles);
    name = platform.getInfo<CL_PLATFORM_NAME>();
  } catch (const cl::Error&) {
    return;  // empty or broken: others may still do
  }
  for (std::size_t index = 0; index < handles.size(); ++index) {
    const std::string id = std::to_string(platformIndex) + ":" + std::to_string(index);
    try {
      devices.push_back({handles[index], describe(handles[index], name, id)});
    } catch (const cl::Error&) {
      continue;  // a device that cannot describe itself cannot be used either
    }
  }
}

bool isId(const std::string& spec) {
  const auto digits = [](const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
  };
  const std::size_t colon = spec.find(':');
  return colon != std::string::npos && digits(spec.substr(0, colon)) && digits(spec.substr(colon + 1));
}

/// Whether the device is one that `spec` may mean; the empty one means any.
bool matches(const DeviceDescription& device, const std::string& spec) {
  if (isId(spec)) return device.id == spec;
  return contains(device.name, spec) || contains(device.platform, spec);
}

std::string listText(const std::vector<ListedDevice>& devices) {
  if (devices.empty()) return "there is no OpenCL device; PoCL (package pocl-opencl-icd) makes the CPU one";
  std::string text = "devices are";
  for (const ListedDevice& device : devices) {
    const DeviceDescription& d = device.description;
    text += std::string(&device == &devices.front() ? " " : ", ") + d.id + " '" + d.name + "' (" + d.platform;
    text += d.unusable.empty() ? ")" : "; unusable: " + d.unusable + ")";
  }
  return text;
}

}  // namespace

std::vector<ListedDevice> findDevices() {
  std::vector<ListedDevice> devices;
  const std::vector<cl::Platform> all = platforms();
  for (std::size_t index = 0; index < all.size(); ++index) appendDevices(all[index], index, devices);
  return devices;
}

DeviceDescription describeDevice(const cl::Device& device) {
  const cl::Platform own(device.getInfo<CL_DEVICE_PLATFORM>());
  for (ListedDevice& listed : findDevices())
    if (listed.handle() == device()) return std::move(listed.description);
  return describe(device, own.getInfo<CL_PLATFORM_NAME>(), "");  // a part of a device, say
}

const ListedDevice& chooseDevice(const std::vector<ListedDevice>& devices, const std::string& spec) {
  const ListedDevice* unusable = nullptr;
  for (const ListedDevice& device : devices) {
    if (!matches(device.description, spec)) continue;
    if (device.description.unusable.empty()) return device;
    if (!unusable) unusable = &device;
  }
  if (spec.empty()) throw Error("no usable OpenCL device: " + listText(devices));
  if (unusable) {
    throw Error("device '" + spec + "' is " + unusable->description.id + " '" + unusable->description.name +
                "', which cannot be used: " + unusable->description.unusable);
  }
  throw Error("unknown device '" + spec + "': give platform:device or part of a name; " + listText(devices));
}

std::string resolveFetch(const DeviceDescription& description, const std::string& fetch) {
  if (fetch == "auto") return description.fetch;
  if (fetch != "buffer" && fetch != "image") throw Error("fetch is '" + fetch + "', but must be auto, buffer or image");
  if (fetch == "image" && !description.images) {
    throw Error("fetch 'image': device " + description.id + " '" + description.name +
                "' has no images; use auto or buffer");
  }
  return fetch;
}

}  // namespace cdsm::device
