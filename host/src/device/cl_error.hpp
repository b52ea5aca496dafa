// SPDX-License-Identifier: Apache-2.0
// From OpenCL's error codes to errors that people can read. In: cl::Error or a code; out: DeviceError.
#pragma once

#include <string>
#include <utility>

#include <CL/opencl.hpp>
#include <cdsm/error.hpp>

namespace cdsm::device {

/// "CL_OUT_OF_RESOURCES" for -5; "unknown code" for what OpenCL 1.2 and the ICD loader do not define.
const char* clErrorName(cl_int code);

/// "DOING: clCall failed with CL_NAME (code)".
DeviceError deviceError(const cl::Error& error, const std::string& doing);

/// Runs `call` and turns a cl::Error into a DeviceError that starts with `doing`, e.g. "upload of voxels".
template <class Call>
auto guarded(const std::string& doing, Call&& call) -> decltype(call()) {
  try {
    return std::forward<Call>(call)();
  } catch (const cl::Error& error) {
    throw deviceError(error, doing);
  }
}

}  // namespace cdsm::device
