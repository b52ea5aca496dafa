// SPDX-License-Identifier: Apache-2.0
// Kernel arguments that are kept for somebody else's kernel. In: memory objects and plain values, in order; out: the
// same set in a kernel, from any number on.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include <CL/opencl.hpp>

namespace cdsm::device {

/// Retains its memory objects.
class LookupArguments {
 public:
  void addMemory(const cl::Memory& memory) { list_.push_back({memory, {}}); }
  template <class T>
  void addValue(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>, "the bytes of T travel to the device");
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    list_.push_back({{}, {bytes, bytes + sizeof(T)}});
  }

  /// Returns the number behind the last argument. Throws Error for a null kernel, DeviceError where the kernel's
  /// arguments are others.
  cl_uint set(cl_kernel kernel, cl_uint first) const;

 private:
  struct Argument {
    cl::Memory memory;
    std::vector<std::byte> value;  ///< if it is not memory
  };
  std::vector<Argument> list_;
};

}  // namespace cdsm::device
