// SPDX-License-Identifier: Apache-2.0
// Oclgrind 21.10 takes memory written by clEnqueueFillBuffer for uninitialized. In this program fills are writes: the
// definition here hides the OpenCL library's.
#include <CL/cl.h>

#include <cstring>
#include <vector>

extern "C" cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void* pattern,
                                      std::size_t patternBytes, std::size_t offset, std::size_t bytes,
                                      cl_uint waitCount, const cl_event* waitFor, cl_event* event) {
  std::vector<unsigned char> filled(bytes);
  for (std::size_t i = 0; i + patternBytes <= bytes; i += patternBytes)
    std::memcpy(&filled[i], pattern, patternBytes);
  return clEnqueueWriteBuffer(queue, buffer, CL_TRUE, offset, bytes, filled.data(), waitCount, waitFor, event);
}
