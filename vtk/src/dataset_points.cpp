// SPDX-License-Identifier: Apache-2.0
#include "dataset_points.hpp"

#include <algorithm>

#include <vtkFloatArray.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

namespace cdsm::vtk {

namespace {

constexpr double kMostOfTheWay = 0.999;  ///< where the light is itself, there is no way from it

}  // namespace

DatasetPoints::DatasetPoints(vtkDataSet& dataset, const Light& light, double bias)
    : dataset_(dataset), light_(light), bias_(bias) {
  auto* const set = vtkPointSet::SafeDownCast(&dataset);
  if (bias != 0.0 || !set || !set->GetPoints()) return;
  auto* const floats = vtkFloatArray::SafeDownCast(set->GetPoints()->GetData());
  if (floats) inPlace_ = reinterpret_cast<const glm::vec3*>(floats->GetPointer(0));
}

glm::dvec3 DatasetPoints::moved(const glm::dvec3& point) const {
  if (bias_ == 0.0) return point;
  if (light_.type == LightType::Directional) return point - bias_ * glm::normalize(glm::dvec3(light_.direction));
  const glm::dvec3 way = glm::dvec3(light_.position) - point;
  const double length = glm::length(way);
  return length > 0.0 ? point + way * (std::min(bias_, kMostOfTheWay * length) / length) : point;
}

const glm::vec3* DatasetPoints::read(vtkIdType first, vtkIdType count) {
  if (inPlace_) return inPlace_ + first;
  copies_.clear();
  for (vtkIdType i = first; i < first + count; ++i) {
    glm::dvec3 point;
    dataset_.GetPoint(i, &point.x);
    copies_.emplace_back(moved(point));
  }
  return copies_.data();
}

}  // namespace cdsm::vtk
