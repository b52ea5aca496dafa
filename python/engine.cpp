// SPDX-License-Identifier: Apache-2.0
#include "engine.hpp"

#include "arrays.hpp"
#include "stats.hpp"

namespace cdsm::python {

EngineObject::EngineObject(const std::string& device, const std::string& fetch, py::object progress, py::object warning)
    : progress_(std::move(progress)), warning_(std::move(warning)) {
  EngineOptions options;
  options.device = device;
  options.fetch = fetch;
  options.progress = [this](const std::string& step, float done) { tellProgress(step, done); };
  options.warning = [this](const std::string& text) { tellWarning(text); };
  const py::gil_scoped_release unlocked;
  engine_ = std::make_unique<Engine>(options);
}

void EngineObject::tellProgress(const std::string& step, float done) const {
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // Ctrl-C
  if (!progress_.is_none()) progress_(step, done);
}

void EngineObject::tellWarning(const std::string& text) const {
  const py::gil_scoped_acquire locked;
  if (!warning_.is_none()) warning_(text);
}

int EngineObject::visitCallbacks(visitproc visit, void* arg) const {
  Py_VISIT(progress_.ptr());
  Py_VISIT(warning_.ptr());
  return 0;
}

void EngineObject::dropCallbacks() {
  progress_ = py::none();
  warning_ = py::none();
}

namespace {

static_assert(sizeof(glm::vec4) == 4 * sizeof(float), "pixels are four floats side by side");

py::array imageArray(Image&& image) {
  const auto kept = std::make_shared<Image>(std::move(image));
  return arrayOver<float>(&kept->pixels.data()->x, {kept->height, kept->width, 4}, kept);
}

py::array render(EngineObject& engine, const SceneObject& object, const py::object& out) {
  const Scene scene = toScene(object);
  if (out.is_none()) return imageArray(engine.work([&](Engine& e) { return e.render(scene); }));
  py::array_t<float> image = resultArray(out, {scene.image.height, scene.image.width, 4}, "out is");
  auto* const pixels = reinterpret_cast<glm::vec4*>(image.mutable_data());
  engine.work([&](Engine& e) { e.render(scene, pixels); });
  return std::move(image);
}

DebugView viewOfName(const std::string& name) {
  const std::pair<const char*, DebugView> views[] = {{"clusters", DebugView::Clusters},
                                                     {"nodes", DebugView::Nodes},
                                                     {"layers", DebugView::Layers},
                                                     {"steps", DebugView::Steps},
                                                     {"texels", DebugView::Texels}};
  std::string known;
  for (const auto& [text, view] : views) {
    if (name == text) return view;
    known += (known.empty() ? "" : ", ") + std::string(text);
  }
  throw Error("there is no view '" + name + "'; known: " + known);
}

py::array renderView(EngineObject& engine, const SceneObject& object, const std::string& view,
                     const std::optional<std::string>& light) {
  const Scene scene = toScene(object);
  const ViewOptions options{viewOfName(view), light};
  return imageArray(engine.work([&](Engine& e) { return e.render(scene, options); }));
}

py::array transmittance(EngineObject& engine, const std::string& light, const py::object& given,
                        const py::object& out) {
  const py::array points = arrayOf(given, "points are");
  checkType(points, py::dtype::of<float>(), "points are");
  checkShape(points, {-1, 3}, "points are");
  checkDense(points, "points are");
  const auto channels = py::ssize_t(engine.work([](Engine& e) { return e.channels(); }));
  std::vector<py::ssize_t> shape{points.shape(0)};
  if (channels > 1) shape.push_back(channels);
  py::array_t<float> values = resultArray(out, shape, "out is");
  checkApart(points, values, "out is");
  const auto* const first = static_cast<const glm::vec3*>(points.data());
  float* const result = values.mutable_data();
  const auto count = std::size_t(points.shape(0));
  engine.work([&](Engine& e) {
    if (py::ssize_t(e.channels()) != channels) throw Error("the engine was given another scene meanwhile; ask again");
    e.transmittance(light, first, count, result);
  });
  return std::move(values);
}

std::vector<std::shared_ptr<LightMap>> lightMaps(EngineObject& engine, const SceneObject& object,
                                                 const std::string& light) {
  const Scene scene = toScene(object);
  std::vector<std::shared_ptr<LightMap>> maps;
  for (LightMap& map : engine.work([&](Engine& e) { return e.lightMaps(scene, light); }))
    maps.push_back(std::make_shared<LightMap>(std::move(map)));
  return maps;
}

/// The engine behind a Python object, or null while that is being made.
EngineObject* engineOf(PyObject* self) {
  const bool made = reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().holder_constructed();
  return made ? py::handle(self).cast<EngineObject*>() : nullptr;
}

void collectGarbage(PyHeapTypeObject* heapType) {
  PyTypeObject& type = heapType->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) {
    Py_VISIT(Py_TYPE(self));
    const EngineObject* const engine = engineOf(self);
    return engine ? engine->visitCallbacks(visit, arg) : 0;
  };
  type.tp_clear = [](PyObject* self) {
    if (EngineObject* const engine = engineOf(self)) engine->dropCallbacks();
    return 0;
  };
}

using EngineClass = py::class_<EngineObject>;

void addQueries(EngineClass& type) {
  type.def(
          "prepare",
          [](EngineObject& engine, const SceneObject& object) {
            const Scene scene = toScene(object);
            engine.work([&](Engine& e) { e.prepare(scene); });
          },
          py::arg("scene"), "Builds what queries for the scene need, as far as it has changed.")
      .def(
          "transmittance", transmittance, py::arg("light"), py::arg("points"), py::arg("out") = py::none(),
          "What of the light of that name gets to world points of the scene that was given last: float32 of shape "
          "(n,), "
          "-1 outside of a spot light's cone. Points are float32 of shape (n, 3), C-contiguous; `out` gets the values.")
      .def("light_maps", lightMaps, py::arg("scene"), py::arg("light"),
           "The deep shadow maps of the light of that name, a list of LightMap.")
      .def(
          "drop", [](EngineObject& engine) { engine.work([](Engine& e) { e.drop(); }); },
          "Lets go of the scene: its device memory, and the arrays that were kept.");
}

}  // namespace

void bindEngine(py::module_& module) {
  EngineClass type(
      module, "Engine",
      "Renders scenes and answers for the light at points. What is built for a scene is kept until a scene "
      "that differs is given. Threads that use one engine take turns.",
      py::custom_type_setup(collectGarbage));
  type.def(py::init<std::string, std::string, py::object, py::object>(), py::arg("device") = "",
           py::arg("fetch") = "auto", py::kw_only(), py::arg("progress") = py::none(), py::arg("warning") = py::none(),
           "device: 'platform:device' or part of a name; '': CDSM_DEVICE, else the first usable. fetch: 'auto', "
           "'buffer' "
           "or 'image'. progress(step, done) and warning(text) are called while it works; what they raise ends the "
           "call.")
      .def("render", render, py::arg("scene"), py::arg("out") = py::none(),
           "The camera's image: float32 of shape (height, width, 4), linear RGBA, rows from the top. `out` gets it.")
      .def("view", renderView, py::arg("scene"), py::arg("view"), py::arg("light") = py::none(),
           "A debug picture: 'clusters', 'nodes', 'layers', 'steps' or 'texels', of the light of that name.")
      .def_property_readonly(
          "stats", [](EngineObject& engine) { return statsDict(engine.work([](Engine& e) { return e.stats(); })); },
          "What the last call did: times in milliseconds, maps, memory. A dict.")
      .def_property_readonly(
          "device", [](EngineObject& engine) { return deviceDict(engine.work([](Engine& e) { return e.device(); })); },
          "The device that it works on. A dict.");
  addQueries(type);
}

}  // namespace cdsm::python
