// SPDX-License-Identifier: Apache-2.0
#include "device/lookup_arguments.hpp"

#include <string>

#include "device/cl_error.hpp"

namespace cdsm::device {

cl_uint LookupArguments::set(cl_kernel kernel, cl_uint first) const {
  if (!kernel) throw Error("the kernel that arguments are set in is null");
  for (const Argument& argument : list_) {
    const cl_mem memory = argument.memory();
    const bool isValue = !argument.value.empty();
    const cl_int code = clSetKernelArg(kernel, first, isValue ? argument.value.size() : sizeof(cl_mem),
                                       isValue ? static_cast<const void*>(argument.value.data()) : &memory);
    if (code != CL_SUCCESS)
      throw deviceError(cl::Error(code, "clSetKernelArg"), "argument " + std::to_string(first) +
                                                               " of the kernel, which must have CDSM_LOOKUP_PARAMS "
                                                               "there");
    ++first;
  }
  return first;
}

}  // namespace cdsm::device
