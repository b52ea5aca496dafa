// SPDX-License-Identifier: Apache-2.0
// Surfaces of VTK as triangles.
#include <cmath>
#include <string>

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
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
  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i) {
    const double* const point = triangles->GetPoint(i);
    data->positions.emplace_back(point[0], point[1], point[2]);
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray* const cells = triangles->GetPolys();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    cells->GetCellAtId(i, corners);
    data->triangles.emplace_back(corners->GetId(0), corners->GetId(1), corners->GetId(2));
  }
  return data;
}

}  // namespace cdsm::vtk
