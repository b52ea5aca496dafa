// SPDX-License-Identifier: Apache-2.0
// What a scene is made of in Python, where objects are named by reference and not by index.
#pragma once

#include <memory>

#include <cdsm/scene.hpp>

#include "fields.hpp"

namespace cdsm::python {

struct MeshObject {
  Mesh mesh;
  std::shared_ptr<Material> material;  ///< none: the default one
  /// The arrays that mesh.data shows.
  py::object positions = py::none(), normals = py::none(), triangles = py::none();
};

struct SpheresObject {
  Spheres spheres;
  std::shared_ptr<Material> material;  ///< none: the default one
  /// The arrays that spheres.data shows.
  py::object centers = py::none(), radii = py::none(), colors = py::none();
};

struct VolumeObject {
  Volume volume;
  std::shared_ptr<TransferFunction> transfer;  ///< none: the default one
  std::shared_ptr<MeshObject> boundary;        ///< none: the volume's own box
  py::object voxels = py::none();              ///< the array that volume.data is a view of
};

struct SceneObject {
  std::shared_ptr<Camera> camera = std::make_shared<Camera>();
  std::shared_ptr<ImageSettings> image = std::make_shared<ImageSettings>();
  std::shared_ptr<ShadowSettings> shadows = std::make_shared<ShadowSettings>();
  std::shared_ptr<AmbientOcclusion> occlusion;  ///< none: none
  py::list lights, meshes, volumes, spheres;
};

/// The scene as the engine takes it. Throws TypeError for a list with something else in it, and Error.
Scene toScene(const SceneObject& scene);

/// What objects have to do with shadows; `access` gives their ShadowRole.
template <class T, class Access>
void addShadowRole(Fields<T>& fields, Access access) {
  fields
      .field(
          "casts", [access](T& object) -> bool& { return access(object).casts; }, "Whether it attenuates light.")
      .field(
          "receives", [access](T& object) -> bool& { return access(object).receives; },
          "Whether it is lit by what is left of the light; False: as if nothing stood in the way.")
      .field(
          "weight", [access](T& object) -> float& { return access(object).weight; },
          "Of its distances to others when casters are clustered, above 0; larger: a sharper shadow.");
}

void bindSettings(py::module_& module);
void bindMesh(py::module_& module);
void bindSpheres(py::module_& module);
void bindVolume(py::module_& module);
void bindScene(py::module_& module);
void bindLightMap(py::module_& module);
void bindEngine(py::module_& module);

}  // namespace cdsm::python
