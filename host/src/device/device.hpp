// SPDX-License-Identifier: Apache-2.0
// Finds and opens an OpenCL device. In: "platform:device" or part of a name, or somebody else's context; out: one
// context and one in-order queue, and what the engine must know about the device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <CL/opencl.hpp>
#include <cdsm/cdsm.hpp>

#include "device/memory_account.hpp"
#include "device/profiler.hpp"

namespace cdsm::device {

class ProgramCache;

/// One context and one queue. Neither copied nor moved, since buffers, kernels and the program cache refer to it:
/// pass it by reference; it must outlive them. Used by one thread at a time.
class Device {
 public:
  /// All devices of all platforms. P and D of an id count from 0; platforms that are empty or broken count, too.
  static std::vector<DeviceDescription> list();

  /// `spec`: "P:D" or a part of a device's or platform's name, case ignored; empty: environment CDSM_DEVICE, else the
  /// first usable device. `fetch`: auto | buffer | image. Throws Error that lists what exists.
  static std::unique_ptr<Device> open(const std::string& spec = "", const std::string& fetch = "auto");

  /// Works in a context that is there already. `queue` may be null: then it makes one. All are retained. Throws Error
  /// if they do not belong together.
  static std::unique_ptr<Device> adopt(cl_context context, cl_device_id device, cl_command_queue queue,
                                       const std::string& fetch = "auto");

  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const cl::Context& context() const { return context_; }
  const cl::CommandQueue& queue() const { return queue_; }
  const cl::Device& handle() const { return handle_; }
  const DeviceDescription& description() const { return description_; }

  /// True: volumes and maps are read through images; false: through buffers.
  bool fetchImages() const { return description_.fetch == "image"; }
  /// True where buffers can lie in the host's memory without loss.
  bool sharesHostMemory() const { return sharesHostMemory_; }
  /// False: the queue keeps no times of its commands.
  bool keepsTimes() const { return keepsTimes_; }
  /// True for an OpenCL CPU device: kernels take the paths made for CPUs.
  bool isCpu() const { return description_.type == "cpu"; }
  std::uint64_t maxAllocationBytes() const { return description_.maxAllocationBytes; }
  /// Bytes held at the moment by buffers and textures of this device.
  std::uint64_t usedBytes() const { return account_->usedBytes; }

  Profiler& profiler() { return profiler_; }
  ProgramCache& programs() { return *programs_; }
  const std::shared_ptr<MemoryAccount>& account() const { return account_; }

  /// Waits until all that was enqueued is done. Throws DeviceError.
  void finish();
  /// What is enqueued from now on waits for these events of the same context.
  void waitFor(const std::vector<cl_event>& events);
  /// An event for the end of all that was enqueued, which begins to run; the caller's to release.
  cl_event mark();

 private:
  Device(const cl::Device& handle, const cl::Context& context, const cl::CommandQueue& queue,
         const DeviceDescription& description);

  DeviceDescription description_;
  cl::Device handle_;
  cl::Context context_;
  cl::CommandQueue queue_;
  bool sharesHostMemory_ = false;
  bool keepsTimes_ = true;
  std::shared_ptr<MemoryAccount> account_;
  Profiler profiler_;
  std::unique_ptr<ProgramCache> programs_;
};

}  // namespace cdsm::device
