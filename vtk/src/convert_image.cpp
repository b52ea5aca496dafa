// SPDX-License-Identifier: Apache-2.0
// Images of VTK as volumes whose voxels stay where they are.
#include <limits>
#include <string>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>
#include <cdsm/error.hpp>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::vtk {

namespace {

std::string nameOf(vtkDataArray* scalars) { return scalars->GetName() ? scalars->GetName() : "scalars"; }

VoxelType voxelTypeOf(vtkDataArray* scalars, const std::string& what) {
  switch (scalars->GetDataType()) {
    case VTK_UNSIGNED_CHAR:
      return VoxelType::UInt8;
    case VTK_SIGNED_CHAR:
      return VoxelType::Int8;
    case VTK_CHAR:
      return std::numeric_limits<char>::is_signed ? VoxelType::Int8 : VoxelType::UInt8;
    case VTK_UNSIGNED_SHORT:
      return VoxelType::UInt16;
    case VTK_SHORT:
      return VoxelType::Int16;
    case VTK_FLOAT:
      return VoxelType::Float32;
    default:
      throw Error(what + " is of type " + scalars->GetDataTypeAsString() +
                  ", must be float, signed or unsigned char or short; vtkImageCast makes such a copy");
  }
}

void requireVoxels(vtkImageData* image, vtkDataArray* scalars, const std::string& what) {
  if (scalars->GetNumberOfComponents() != 1)
    throw Error(what + " has " + std::to_string(scalars->GetNumberOfComponents()) +
                " components, must have one; vtkImageExtractComponents takes one out");
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
    throw Error(what + " has " + std::to_string(scalars->GetNumberOfTuples()) + " values for " +
                std::to_string(image->GetNumberOfPoints()) + " points, must have one for each");
  if (!scalars->HasStandardMemoryLayout())
    throw Error(what + " does not lie side by side in memory, must be such an array as vtkFloatArray");
}

/// From the index of a voxel, counted from 0, to the world.
glm::mat4 worldFromIndex(vtkImageData* image) {
  const double* const matrix = image->GetIndexToPhysicalMatrix()->GetData();  // row by row
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) result[column][row] = matrix[4 * row + column];
  const int* const extent = image->GetExtent();
  result[3] = result * glm::dvec4(extent[0], extent[2], extent[4], 1.0);
  return glm::mat4(result);
}

}  // namespace

Volume volume(vtkImageData* image, vtkDataArray* scalars) {
  if (!image || !scalars) throw Error("there is no image with an array of its points, must be one");
  const std::string what = "the array '" + nameOf(scalars) + "'";
  auto data = std::make_shared<VolumeData>();
  data->type = voxelTypeOf(scalars, what);
  requireVoxels(image, scalars, what);
  const int* const size = image->GetDimensions();
  data->size = glm::uvec3(size[0], size[1], size[2]);
  data->view.data = scalars->GetVoidPointer(0);
  data->view.owner = {data->view.data, [kept = vtkSmartPointer<vtkDataArray>(scalars)](const void*) {}};
  Volume volume;
  volume.name = nameOf(scalars);
  volume.data = data;
  volume.worldFromObject = worldFromIndex(image);  // not the data's: a grid that moves needs no other voxels
  return volume;
}

}  // namespace cdsm::vtk
