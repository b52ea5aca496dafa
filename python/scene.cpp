// SPDX-License-Identifier: Apache-2.0
// The scene in Python, and what the engine gets of it: a copy, made while the interpreter's lock is held.
#include <algorithm>

#include <cdsm/error.hpp>

#include "objects.hpp"

namespace cdsm::python {

namespace {

/// Elements of a scene's list. Throws TypeError for one that is something else.
template <class T>
std::vector<std::shared_ptr<T>> elementsOf(const py::list& list, const std::string& name) {
  std::vector<std::shared_ptr<T>> elements;
  for (const py::handle& element : list) {
    const std::string what = "Scene." + name + "[" + std::to_string(elements.size()) + "]";
    elements.push_back(valueOf<std::shared_ptr<T>>(element, what));
    if (!elements.back()) throw py::type_error(what + " is None, must be " + Expected<std::shared_ptr<T>>::text());
  }
  return elements;
}

/// Index of a material in the engine's scene, each there once.
class Materials {
 public:
  explicit Materials(std::vector<Material>& list) : list_(list) {}

  int indexOf(const std::shared_ptr<Material>& material) {
    const auto found = std::find(known_.begin(), known_.end(), material);
    if (found != known_.end()) return int(found - known_.begin());
    known_.push_back(material);
    list_.push_back(material ? *material : Material());
    return int(list_.size()) - 1;
  }

 private:
  std::vector<Material>& list_;
  std::vector<std::shared_ptr<Material>> known_;
};

Volume volumeOf(const VolumeObject& object, const std::vector<std::shared_ptr<MeshObject>>& meshes) {
  Volume volume = object.volume;
  if (object.transfer) volume.transfer = *object.transfer;
  if (!object.boundary) return volume;
  const auto found = std::find(meshes.begin(), meshes.end(), object.boundary);
  if (found == meshes.end())
    throw Error("volume '" + volume.name + "': its boundary '" + object.boundary->mesh.name +
                "' is not in the scene, must be in Scene.meshes");
  volume.boundary = int(found - meshes.begin());
  return volume;
}

template <class T>
T valueOrDefault(const std::shared_ptr<T>& value) {
  return value ? *value : T();
}

Fields<SceneObject>& addList(Fields<SceneObject>& fields, const char* name, py::list SceneObject::*list,
                             const char* doc) {
  return fields.property(
      name, [list](SceneObject& scene) { return scene.*list; },
      [list, what = std::string(name)](SceneObject& scene, const py::object& given) {
        if (!py::isinstance<py::iterable>(given)) throw py::type_error("Scene." + what + " must be a list");
        scene.*list = py::list(given);
      },
      doc);
}

}  // namespace

Scene toScene(const SceneObject& object) {
  Scene scene;
  scene.camera = valueOrDefault(object.camera);
  scene.image = valueOrDefault(object.image);
  scene.shadows = valueOrDefault(object.shadows);
  if (object.occlusion) scene.ambientOcclusion = *object.occlusion;
  for (const auto& light : elementsOf<Light>(object.lights, "lights")) scene.lights.push_back(*light);
  Materials materials(scene.materials);
  const auto meshes = elementsOf<MeshObject>(object.meshes, "meshes");
  for (const auto& mesh : meshes) {
    scene.meshes.push_back(mesh->mesh);
    scene.meshes.back().material = materials.indexOf(mesh->material);
  }
  for (const auto& spheres : elementsOf<SpheresObject>(object.spheres, "spheres")) {
    scene.spheres.push_back(spheres->spheres);
    scene.spheres.back().material = materials.indexOf(spheres->material);
  }
  for (const auto& volume : elementsOf<VolumeObject>(object.volumes, "volumes"))
    scene.volumes.push_back(volumeOf(*volume, meshes));
  return scene;
}

void bindScene(py::module_& module) {
  Fields<SceneObject> fields(module, "Scene", "Camera, image and shadow settings, lights and objects.");
  fields.field("camera", &SceneObject::camera, "None: the default one.")
      .field("image", &SceneObject::image, "None: the default one.")
      .field("shadows", &SceneObject::shadows, "None: the default ones.")
      .field("ambient_occlusion", &SceneObject::occlusion, "Of the spheres; None: none.");
  addList(fields, "lights", &SceneObject::lights, "List of Light.");
  addList(fields, "meshes", &SceneObject::meshes, "List of Mesh.");
  addList(fields, "volumes", &SceneObject::volumes, "List of Volume.");
  addList(fields, "spheres", &SceneObject::spheres, "List of Spheres.").constructor();
  module.def(
      "validate", [](const SceneObject& scene) { validate(toScene(scene)); }, py::arg("scene"),
      "Raises Error if a value of the scene is out of its range; names the object and the remedy.");
}

}  // namespace cdsm::python
