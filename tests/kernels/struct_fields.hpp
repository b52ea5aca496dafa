// SPDX-License-Identifier: Apache-2.0
// Every field of every struct that host and device share, with its place on the host. A field that is missing here
// fails the test that the fields fill the struct.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cdsm::kernels {

/// One number of a struct.
struct Scalar {
  std::string path;    ///< as both languages write it: "view.pixelU.x"
  std::size_t offset;  ///< bytes from the start of the struct, on the host
  bool isFloat;
};

struct SharedStruct {
  std::string name;
  std::string header;  ///< relative to kernels/
  std::size_t bytes;
  std::vector<Scalar> scalars;
};

std::vector<SharedStruct> sharedStructs();

}  // namespace cdsm::kernels
