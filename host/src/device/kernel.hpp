// SPDX-License-Identifier: Apache-2.0
// Typed launches. In: a program, a function and its arguments in the kernel's order; out: an enqueued, profiled launch.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <CL/opencl.hpp>

#include "device/buffer.hpp"
#include "device/device.hpp"
#include "device/texture.hpp"

namespace cdsm::device {

/// How one launch is called and how many work items it has. `global` is rounded up to a multiple of `local`, so
/// kernels must check their indices; a `global` of 0 in any dimension launches nothing.
struct Launch {
  const char* name;  ///< human name for profiler and errors
  cl::NDRange global;
  cl::NDRange local;
};

/// Memory objects that become one kernel argument each, for kernels whose list of buffers varies.
using ArgumentList = std::vector<cl::Memory>;

/// The untyped part of Kernel.
class KernelBase {
 protected:
  KernelBase(Device& device, const cl::Program& program, const char* function);

  /// Throws DeviceError unless `given` is the number of the kernel's arguments.
  void checkCount(cl_uint given) const;
  void enqueue(const Launch& launch);

  template <class T>
  void bind(cl_uint& index, const T& value) {
    setArgument(index++, value);
  }
  template <class T>
  void bind(cl_uint& index, const Buffer<T>& buffer) {
    setArgument(index++, buffer.cl());
  }
  void bind(cl_uint& index, const VolumeTexture& texture) { setArgument(index++, texture.image()); }
  void bind(cl_uint& index, const NodeTexture& texture) { setArgument(index++, texture.image()); }
  void bind(cl_uint& index, const ArgumentList& list);

 private:
  template <class T>
  void setArgument(cl_uint index, const T& value) {
    static_assert(std::is_base_of_v<cl::Memory, T> || std::is_trivially_copyable_v<T>,
                  "kernel arguments are memory objects or plain values");
    try {
      kernel_.setArg(index, value);
    } catch (const cl::Error& error) {
      failArgument(index, error);
    }
  }
  [[noreturn]] void failArgument(cl_uint index, const cl::Error& error) const;

  Device* device_;
  std::string function_;
  cl::Kernel kernel_;
};

/// One kernel function with the types of its arguments: plain structs by value, cl::Buffer, Buffer<T>, cl::Image,
/// textures, cl::LocalSpaceArg or ArgumentList. Throws DeviceError naming kernel, launch and CL code.
template <class... Args>
class Kernel : public KernelBase {
 public:
  Kernel(Device& device, const cl::Program& program, const char* function) : KernelBase(device, program, function) {
    if constexpr (!(std::is_same_v<Args, ArgumentList> || ...)) checkCount(sizeof...(Args));
  }

  void operator()(const Launch& launch, const Args&... args) {
    cl_uint index = 0;
    if constexpr ((std::is_same_v<Args, ArgumentList> || ...)) checkCount((count(args) + ... + 0u));
    (bind(index, args), ...);
    enqueue(launch);
  }

 private:
  template <class T>
  static cl_uint count(const T&) {
    return 1;
  }
  static cl_uint count(const ArgumentList& list) { return static_cast<cl_uint>(list.size()); }
};

}  // namespace cdsm::device
