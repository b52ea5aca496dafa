// SPDX-License-Identifier: Apache-2.0
// Properties and ports of the filters.
#include <algorithm>

#include <cdsm/vtk/vtkCdsmFilter.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVolumeProperty.h>

void vtkCdsmFilter::SetVolumeProperty(vtkVolumeProperty* property) {
  if (this->VolumeProperty == property) return;
  this->VolumeProperty = property;
  this->Modified();
}

vtkVolumeProperty* vtkCdsmFilter::GetVolumeProperty() { return this->VolumeProperty; }

void vtkCdsmFilter::SetShadows(const cdsm::ShadowSettings& shadows) {
  this->Shadows = shadows;
  this->Modified();
}

void vtkCdsmFilter::SetTechnique(const char* technique) {
  this->Shadows.technique = technique ? technique : "";
  this->Modified();
}

void vtkCdsmFilter::SetMapSize(int texels) {
  this->Shadows.mapSize = texels;
  this->Modified();
}

void vtkCdsmFilter::SetTolerance(double tolerance) {
  this->Shadows.tolerance = float(tolerance);
  this->Modified();
}

vtkMTimeType vtkCdsmFilter::GetMTime() {
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->VolumeProperty ? std::max(own, this->VolumeProperty->GetMTime()) : own;
}

int vtkCdsmFilter::FillInputPortInformation(int port, vtkInformation* info) {
  const char* const type = port == this->ImagePort     ? "vtkImageData"
                           : port == this->SurfacePort ? "vtkPolyData"
                                                       : "vtkDataSet";
  info->Set(INPUT_REQUIRED_DATA_TYPE(), type);
  if (port > 0) info->Set(INPUT_IS_OPTIONAL(), 1);
  if (port == this->SurfacePort) info->Set(INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkCdsmFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (const int port : {this->ImagePort, this->SurfacePort}) {  // all that casts, whatever part is asked for
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i) {
      vtkInformation* const info = inputs[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (info->Has(Pipeline::WHOLE_EXTENT()))
        info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
  return 1;
}

void vtkCdsmFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* v) {
    os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n";
  };
  os << indent << "LightType: " << this->LightType << "\n";
  vector("LightPosition", this->LightPosition);
  vector("LightTarget", this->LightTarget);
  vector("LightDirection", this->LightDirection);
  os << indent << "LightCutoff: " << this->LightCutoff << "\n"
     << indent << "VolumeProperty: " << this->VolumeProperty.GetPointer() << "\n"
     << indent << "SurfaceOpacity: " << this->SurfaceOpacity << "\n"
     << indent << "Technique: " << this->Shadows.technique << "\n"
     << indent << "MapSize: " << this->Shadows.mapSize << "\n"
     << indent << "Tolerance: " << this->Shadows.tolerance << "\n"
     << indent << "ArrayName: " << this->ArrayName << "\n"
     << indent << "Device: " << this->Device << "\n";
}
