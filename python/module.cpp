// SPDX-License-Identifier: Apache-2.0
// The Python module `cdsm`: the public C++ interface with NumPy's arrays (docs/python.md).
#include <cdsm/cdsm.hpp>

#include "objects.hpp"
#include "stats.hpp"

namespace py = pybind11;

PYBIND11_MODULE(cdsm, module) {
  module.doc() = "Clustered deep shadow maps: a Scene in, images and transmittances out.";
  module.attr("__version__") = CDSM_VERSION;
  const auto error = py::register_exception<cdsm::Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<cdsm::DeviceError>(module, "DeviceError", error);
  cdsm::python::bindSettings(module);
  cdsm::python::bindMesh(module);
  cdsm::python::bindSpheres(module);
  cdsm::python::bindVolume(module);
  cdsm::python::bindScene(module);
  cdsm::python::bindLightMap(module);
  cdsm::python::bindEngine(module);
  module.def(
      "list_devices",
      [] {
        py::list list;
        for (const cdsm::DeviceDescription& device : cdsm::listDevices()) list.append(cdsm::python::deviceDict(device));
        return list;
      },
      "All OpenCL devices, each a dict; `unusable` is empty, or why the engine cannot run on it.");
}
