// SPDX-License-Identifier: Apache-2.0
// The points of any data set, batch by batch, moved towards a light if asked for.
#pragma once

#include <vector>

#include <vtkDataSet.h>
#include <cdsm/scene.hpp>

namespace cdsm::vtk {

class DatasetPoints {
 public:
  /// `bias`: world units towards the light, but not past it. Keeps neither alive.
  DatasetPoints(vtkDataSet& dataset, const Light& light, double bias);

  /// Points first to first + count - 1, valid until the next call. Floats that lie side by side are not copied.
  const glm::vec3* read(vtkIdType first, vtkIdType count);

 private:
  glm::dvec3 moved(const glm::dvec3& point) const;

  vtkDataSet& dataset_;
  const Light& light_;
  double bias_;
  const glm::vec3* inPlace_ = nullptr;
  std::vector<glm::vec3> copies_;
};

}  // namespace cdsm::vtk
