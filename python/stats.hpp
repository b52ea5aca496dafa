// SPDX-License-Identifier: Apache-2.0
// Statistics and devices as dictionaries.
#pragma once

#include <pybind11/pybind11.h>
#include <cdsm/cdsm.hpp>

namespace cdsm::python {

pybind11::dict statsDict(const FrameStats& stats);
pybind11::dict deviceDict(const DeviceDescription& device);

}  // namespace cdsm::python
