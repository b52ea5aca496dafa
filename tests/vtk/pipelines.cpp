// SPDX-License-Identifier: Apache-2.0
#include "pipelines.hpp"

#include <algorithm>
#include <cmath>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLogger.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkStringOutputWindow.h>
#include <vtkVolumeProperty.h>

namespace cdsm::tests {

vtkSmartPointer<vtkImageData> filledImage(int type) {
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-3, 4, 5, 20, 2, 7);
  image->SetOrigin(1.0, 2.0, -3.0);
  image->SetSpacing(0.5, 0.125, 0.25);
  image->SetDirectionMatrix(0, 0, 1, 0, -1, 0, 1, 0, 0);  // j runs down the world's y
  image->AllocateScalars(type, 1);
  image->GetPointData()->GetScalars()->Fill(kVoxel);
  image->GetPointData()->GetScalars()->SetName("density");
  return image;
}

double lowestY(vtkImageData* image) { return image->GetBounds()[2] - 0.0625; }

double highestY(vtkImageData* image) { return image->GetBounds()[3] + 0.0625; }

double expectedAt(vtkImageData* image, double y) {
  const double way = highestY(image) - std::clamp(y, lowestY(image), highestY(image));
  return std::pow(1.0 - kOpacity, way / kUnitDistance);
}

void setUp(vtkCdsmFilter* filter) {
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(kVoxel, kOpacity);
  filter->GetVolumeProperty()->SetScalarOpacity(opacity);
  filter->GetVolumeProperty()->SetScalarOpacityUnitDistance(kUnitDistance);
  filter->SetLightTypeToDirectional();
  filter->SetMapSize(64);
  filter->SetTolerance(0.001);
}

vtkSmartPointer<vtkPolyData> square(double height) {
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& [x, z] : {std::pair(-9, -9), {-9, 9}, {9, 9}, {9, -9}, {0, 1}})
    points->InsertNextPoint(x, height, z);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

std::vector<float> valuesOf(vtkDataSet* output, const char* name) {
  auto* const array = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray(name));
  if (!array) return {};
  return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples()};
}

ErrorLog::ErrorLog(vtkObject* object) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<vtkStringOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&text);
  command->SetCallback([](vtkObject*, unsigned long, void* log, void* said) {
    static_cast<std::string*>(log)->append(static_cast<const char*>(said));
  });
  object->AddObserver(vtkCommand::ErrorEvent, command);
}

}  // namespace cdsm::tests
