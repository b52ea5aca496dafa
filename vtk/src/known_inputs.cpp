// SPDX-License-Identifier: Apache-2.0
#include "known_inputs.hpp"

#include <algorithm>
#include <string>

#include <vtkPoints.h>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::vtk {

namespace {

bool sameVoxels(const VolumeData& a, const VolumeData& b) {
  return a.view.data == b.view.data && a.type == b.type && a.size == b.size;
}

const void* placeOfPoints(vtkPolyData* surface) {
  return surface->GetPoints() ? surface->GetPoints()->GetVoidPointer(0) : nullptr;
}

}  // namespace

Volume KnownInputs::volume(vtkImageData* image, vtkDataArray* scalars) {
  Volume next = vtk::volume(image, scalars);
  if (scalars == scalars_ && sameVoxels(*next.data, *volume_.data)) {
    next.data = volume_.data;
    next.revision = volume_.revision + (image->GetMTime() == modified_ ? 0 : 1);
  }
  volume_ = next;
  scalars_ = scalars;
  modified_ = image->GetMTime();
  return next;
}

std::vector<Mesh> KnownInputs::meshes(const std::vector<vtkPolyData*>& surfaces) {
  std::vector<Surface> next;
  std::vector<Mesh> meshes;
  for (vtkPolyData* const surface : surfaces) {
    const vtkMTimeType modified = surface->GetMTime();
    const auto known = std::find_if(surfaces_.begin(), surfaces_.end(), [&](const Surface& s) {
      return s.modified == modified && s.points == placeOfPoints(surface);
    });
    const std::shared_ptr<const MeshData> data = known == surfaces_.end() ? meshData(surface) : known->data;
    next.push_back({modified, placeOfPoints(surface), data});  // where they are now: triangulating may move them
    if (!next.back().data) continue;
    meshes.emplace_back();
    meshes.back().name = "surface " + std::to_string(next.size() - 1);
    meshes.back().data = next.back().data;
  }
  surfaces_ = std::move(next);
  return meshes;
}

}  // namespace cdsm::vtk
