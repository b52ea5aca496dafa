// SPDX-License-Identifier: Apache-2.0
// Surfaces of VTK as triangles.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <cdsm/error.hpp>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::vtk {

namespace {

/// VTK's triangulation checks neither.
void requireSound(vtkPolyData* surface) {
  const vtkIdType count = surface->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i) {
    const double* const point = surface->GetPoint(i);
    if (!std::isfinite(point[0] + point[1] + point[2]))
      throw Error("point " + std::to_string(i) + " of a surface is not finite, must be numbers");
  }
  for (vtkCellArray* const cells : {surface->GetPolys(), surface->GetStrips()}) {
    if (cells->GetNumberOfConnectivityIds() == 0) continue;
    double range[2];
    cells->GetConnectivityArray()->GetRange(range);
    if (range[0] < 0 || range[1] >= double(count))
      throw Error("a cell of a surface has the point " + std::to_string(vtkIdType(range[range[0] < 0 ? 0 : 1])) +
                  ", must be in 0 to " + std::to_string(count - 1));
  }
}

/// Where they are if they are floats side by side; else a copy.
Array<glm::vec3> positionsOf(vtkDataArray* points) {
  const auto count = std::size_t(points->GetNumberOfTuples());
  if (points->GetDataType() == VTK_FLOAT && points->HasStandardMemoryLayout()) {
    const auto owner = std::make_shared<vtkSmartPointer<vtkDataArray>>(points);
    return Array<glm::vec3>::view(points->GetVoidPointer(0), count, sizeof(glm::vec3), owner);
  }
  std::vector<glm::vec3> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const double* const point = points->GetTuple(vtkIdType(i));
    positions.emplace_back(point[0], point[1], point[2]);
  }
  return positions;
}

}  // namespace

std::shared_ptr<const MeshData> meshData(vtkPolyData* surface) {
  if (!surface) throw Error("there is no surface, must be one");
  requireSound(surface);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->PassLinesOff();
  filter->PassVertsOff();
  filter->Update();
  vtkPolyData* const triangles = filter->GetOutput();
  if (triangles->GetNumberOfPolys() == 0) return nullptr;
  auto data = std::make_shared<MeshData>();
  data->positions = positionsOf(triangles->GetPoints()->GetData());
  std::vector<glm::uvec3> indices;
  vtkNew<vtkIdList> corners;
  vtkCellArray* const cells = triangles->GetPolys();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    cells->GetCellAtId(i, corners);
    indices.emplace_back(corners->GetId(0), corners->GetId(1), corners->GetId(2));
  }
  data->triangles = std::move(indices);
  return data;
}

}  // namespace cdsm::vtk
