// SPDX-License-Identifier: Apache-2.0
// Inputs of a pipeline as objects of a scene. What has not changed since the last execution stays the same object, by
// which the engine knows that nothing is to be built again.
#pragma once

#include <vector>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <cdsm/scene.hpp>

namespace cdsm::vtk {

class KnownInputs {
 public:
  /// With another revision than before if the image was modified, the same data as long as the array is the same.
  Volume volume(vtkImageData* image, vtkDataArray* scalars);

  /// One for each surface that has a triangle, with the material of index 0.
  std::vector<Mesh> meshes(const std::vector<vtkPolyData*>& surfaces);

 private:
  struct Surface {
    vtkMTimeType modified;  ///< of which VTK gives each only once
    const void* points;     ///< which may move without one, when room for them is made or given back
    std::shared_ptr<const MeshData> data;
  };

  Volume volume_;  ///< keeps the array, so that no other one has its address
  vtkDataArray* scalars_ = nullptr;
  vtkMTimeType modified_ = 0;
  std::vector<Surface> surfaces_;
};

}  // namespace cdsm::vtk
