// SPDX-License-Identifier: Apache-2.0
// Definitions that hide the OpenCL library's in this program. clCreateBuffer: fills new buffers for poison.hpp.
// clEnqueueFillBuffer: writes instead, since oclgrind 21.10 takes memory that was filled for uninitialized.
#include <CL/cl.h>
#include <dlfcn.h>

#include <cstring>
#include <vector>

#include "poison.hpp"

namespace {

std::optional<unsigned char> poison;

void fill(cl_context context, cl_mem buffer, std::size_t bytes) {
  cl_device_id device = nullptr;
  cl_int code = clGetContextInfo(context, CL_CONTEXT_DEVICES, sizeof(device), &device, nullptr);
  if (code != CL_SUCCESS) return;
  const cl_command_queue queue = clCreateCommandQueue(context, device, 0, &code);
  if (code != CL_SUCCESS) return;
  const std::vector<unsigned char> pattern(bytes, *poison);
  clEnqueueWriteBuffer(queue, buffer, CL_TRUE, 0, bytes, pattern.data(), 0, nullptr, nullptr);
  clReleaseCommandQueue(queue);
}

}  // namespace

void cdsm::devices::poisonNewBuffers(std::optional<unsigned char> byte) { poison = byte; }

extern "C" cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, std::size_t bytes, void* host, cl_int* code) {
  static const auto original = reinterpret_cast<decltype(&clCreateBuffer)>(dlsym(RTLD_NEXT, "clCreateBuffer"));
  const cl_mem buffer = original(context, flags, bytes, host, code);
  if (buffer && !host && poison) fill(context, buffer, bytes);
  return buffer;
}

extern "C" cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void* pattern,
                                      std::size_t patternBytes, std::size_t offset, std::size_t bytes,
                                      cl_uint waitCount, const cl_event* waitFor, cl_event* event) {
  std::vector<unsigned char> filled(bytes);
  for (std::size_t i = 0; i + patternBytes <= bytes; i += patternBytes) std::memcpy(&filled[i], pattern, patternBytes);
  return clEnqueueWriteBuffer(queue, buffer, CL_TRUE, offset, bytes, filled.data(), waitCount, waitFor, event);
}
