// SPDX-License-Identifier: Apache-2.0
// Small pipelines whose light is known by formula.
#pragma once

#include <string>
#include <vector>

#include <cdsm/vtk/vtkCdsmShadowFilter.h>
#include <cdsm/vtk/vtkCdsmTransmittanceFilter.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace cdsm::tests {

constexpr double kOpacity = 0.25;      ///< per kUnitDistance, of voxels of the value 1
constexpr double kUnitDistance = 0.5;  ///< world units
constexpr int kVoxel = 1;

/// A filled box whose grid is as unlike the world's as it can be: its extent begins below and above 0, its axes are
/// exchanged and turned around, its edges differ. `type`: VTK_FLOAT and so on.
vtkSmartPointer<vtkImageData> filledImage(int type);

/// The lowest and the highest coordinate along the world's y of the image's box, half a voxel beyond its outer centres.
double lowestY(vtkImageData* image);
double highestY(vtkImageData* image);

/// What of light from above gets to a height in the image's box.
double expectedAt(vtkImageData* image, double y);

/// Opacities of 0 below kVoxel and kOpacity from there on, light from above.
void setUp(vtkCdsmFilter* filter);

/// A square in the plane y = height above or below all of the image, as one polygon; its last point is one amid it.
vtkSmartPointer<vtkPolyData> square(double height);

std::vector<float> valuesOf(vtkDataSet* output, const char* name = "Transmittance");

/// Gathers the errors of an object, and keeps what VTK prints off the screen.
class ErrorLog {
 public:
  explicit ErrorLog(vtkObject* object);
  std::string text;
};

}  // namespace cdsm::tests
