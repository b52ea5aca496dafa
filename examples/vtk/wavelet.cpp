// SPDX-License-Identifier: Apache-2.0
// A pipeline of VTK's with the filters of cdsm: the light in a volume, and on a plane below it. Exit status 0 if there
// is a shadow.
#include <cstdio>

#include <cdsm/vtk/vtkCdsmShadowFilter.h>
#include <cdsm/vtk/vtkCdsmTransmittanceFilter.h>
#include <vtkDataSet.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkSphereSource.h>
#include <vtkVolumeProperty.h>

namespace {

double darkest(const char* what, vtkCdsmFilter* filter) {
  filter->Update();
  vtkDataArray* const light = filter->GetOutput()->GetPointData()->GetArray("Transmittance");
  if (!light) return 1.0;  // the filter has said why
  std::printf("%s: %.3f to %.3f of the light\n", what, light->GetRange()[0], light->GetRange()[1]);
  return light->GetRange()[0];
}

}  // namespace

int main() {
  vtkNew<vtkRTAnalyticSource> wavelet;  // values from 37 to 277
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0, 14, 0);
  sphere->SetRadius(3);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-20, -12, 20);
  floor->SetPoint1(20, -12, 20);
  floor->SetPoint2(-20, -12, -20);
  floor->SetResolution(100, 100);

  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(100, 0.0);
  opacity->AddPoint(277, 0.5);

  vtkNew<vtkCdsmShadowFilter> shadows;
  shadows->SetInputConnection(wavelet->GetOutputPort());
  shadows->AddInputConnection(1, sphere->GetOutputPort());
  shadows->GetVolumeProperty()->SetScalarOpacity(opacity);
  shadows->GetVolumeProperty()->SetScalarOpacityUnitDistance(2.0);
  shadows->SetLightPosition(0, 60, 0);

  vtkNew<vtkCdsmTransmittanceFilter> query;
  query->SetInputConnection(0, floor->GetOutputPort());
  query->SetInputConnection(1, wavelet->GetOutputPort());
  query->AddInputConnection(2, sphere->GetOutputPort());
  query->SetVolumeProperty(shadows->GetVolumeProperty());
  query->SetLightPosition(0, 60, 0);

  const double inside = darkest("in the volume", shadows), below = darkest("on the floor", query);
  return inside < 0.1 && below < 0.1 ? 0 : 1;
}
