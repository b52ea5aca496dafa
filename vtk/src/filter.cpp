// SPDX-License-Identifier: Apache-2.0
// From a pipeline's inputs to a scene, from the engine's answers to an array.
#include <algorithm>
#include <string>

#include <cdsm/vtk/vtkCdsmFilter.h>
#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVolumeProperty.h>
#include <cdsm/vtk/convert.hpp>

#include "dataset_points.hpp"
#include "known_inputs.hpp"

namespace {

const char* const kLight = "light";
constexpr vtkIdType kBatch = 1 << 20;  ///< points asked about at once: 16 MiB with their values
constexpr double kBuilt = 0.4;         ///< progress by which the maps are there

/// Somebody set AbortExecute.
struct Aborted {};

glm::vec3 vectorOf(const double (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }

}  // namespace

struct vtkCdsmFilter::Internals {
  std::unique_ptr<cdsm::Engine> engine;
  std::string device;  ///< that the engine was asked for
  cdsm::vtk::KnownInputs inputs;
  cdsm::FrameStats stats;
};

vtkCdsmFilter::vtkCdsmFilter(int imagePort, int surfacePort)
    : ImagePort(imagePort),
      SurfacePort(surfacePort),
      VolumeProperty(vtkSmartPointer<vtkVolumeProperty>::New()),
      Internal(std::make_unique<Internals>()) {
  this->SetNumberOfInputPorts(surfacePort + 1);
  this->SetInputArrayToProcess(0, imagePort, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkCdsmFilter::~vtkCdsmFilter() = default;

const cdsm::FrameStats& vtkCdsmFilter::GetStats() const { return this->Internal->stats; }

void vtkCdsmFilter::Drop() { this->Internal = std::make_unique<Internals>(); }

cdsm::Engine& vtkCdsmFilter::UseEngine() {
  if (this->Internal->engine && this->Internal->device == this->Device) return *this->Internal->engine;
  this->Drop();
  cdsm::EngineOptions options;
  options.device = this->Device;
  options.warning = [this](const std::string& text) { vtkWarningMacro(<< text); };
  options.progress = [this](const std::string& step, float) {
    if (step == "upload") this->TellProgress(0.0);
    if (step == "shadows") this->TellProgress(0.1);
  };
  this->Internal->engine = std::make_unique<cdsm::Engine>(options);
  this->Internal->device = this->Device;
  return *this->Internal->engine;
}

void vtkCdsmFilter::TellProgress(double done) {
  this->UpdateProgress(done);
  if (this->GetAbortExecute()) throw Aborted();
}

cdsm::Light vtkCdsmFilter::MakeLight() const {
  if (this->LightType < SPOT || this->LightType > DIRECTIONAL)
    throw cdsm::Error("LightType is " + std::to_string(this->LightType) + ", must be SPOT, OMNI or DIRECTIONAL");
  cdsm::Light light;
  light.name = kLight;
  light.type = static_cast<cdsm::LightType>(this->LightType);  // in the same order
  light.position = vectorOf(this->LightPosition);
  light.target = vectorOf(this->LightTarget);
  light.direction = vectorOf(this->LightDirection);
  light.cutoff = float(this->LightCutoff);
  return light;
}

void vtkCdsmFilter::AddImage(cdsm::Scene& scene, vtkInformationVector** inputs) {
  vtkImageData* const image = vtkImageData::GetData(inputs[this->ImagePort]);
  if (!image) return;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const scalars = this->GetInputArrayToProcess(0, image, association);
  if (scalars && association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
    throw cdsm::Error("the image's array is of its cells, must be of its points; vtkCellDataToPointData makes one");
  if (!scalars && image->GetCellData()->GetNumberOfArrays() > 0)
    throw cdsm::Error("the image has no scalars of its points, only of its cells; vtkCellDataToPointData makes some");
  if (!scalars) throw cdsm::Error("the image has no scalars of its points, or not those of SetInputArrayToProcess()");
  scene.volumes = {this->Internal->inputs.volume(image, scalars)};
  scene.volumes[0].transfer = cdsm::vtk::transferFunction(this->VolumeProperty);
}

void vtkCdsmFilter::AddSurfaces(cdsm::Scene& scene, vtkInformationVector* surfaces) {
  std::vector<vtkPolyData*> given;
  for (int i = 0; i < surfaces->GetNumberOfInformationObjects(); ++i)
    if (vtkPolyData* const surface = vtkPolyData::GetData(surfaces, i)) given.push_back(surface);
  scene.materials.resize(1);
  scene.materials[0].name = "SurfaceOpacity";
  scene.materials[0].opacity = float(this->SurfaceOpacity);
  scene.meshes = this->Internal->inputs.meshes(given);
}

cdsm::Scene vtkCdsmFilter::MakeScene(vtkInformationVector** inputs) {
  cdsm::Scene scene;
  scene.shadows = this->Shadows;
  scene.lights = {this->MakeLight()};
  this->AddImage(scene, inputs);
  this->AddSurfaces(scene, inputs[this->SurfacePort]);
  return scene;
}

void vtkCdsmFilter::AddTransmittance(vtkInformationVector** inputs, vtkDataSet* output) {
  if (!(this->Bias >= 0.0)) throw cdsm::Error("Bias is " + std::to_string(this->Bias) + ", must be at least 0");
  if (this->Shadows.transmittance != "grey")
    throw cdsm::Error("transmittance is '" + this->Shadows.transmittance +
                      "', must be 'grey': one value for each point");
  cdsm::Engine& engine = this->UseEngine();
  const cdsm::Scene scene = this->MakeScene(inputs);
  engine.prepare(scene);
  this->Internal->stats = engine.stats();

  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<vtkFloatArray> values;
  values->SetName(this->ArrayName.c_str());
  values->SetNumberOfTuples(count);
  cdsm::vtk::DatasetPoints points(*output, scene.lights[0], this->Bias);
  for (vtkIdType first = 0; first < count; first += kBatch) {
    this->TellProgress(kBuilt + (1.0 - kBuilt) * double(first) / double(count));
    const vtkIdType batch = std::min(kBatch, count - first);
    float* const answers = values->GetPointer(first);
    engine.transmittance(kLight, points.read(first, batch), std::size_t(batch), answers);
    std::replace(answers, answers + batch, -1.0f, 0.0f);  // outside of the cone
  }
  output->GetPointData()->AddArray(values);
}

int vtkCdsmFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  vtkDataSet* const output = vtkDataSet::GetData(outputs);
  output->ShallowCopy(vtkDataSet::GetData(inputs[0]));
  output->GetPointData()->RemoveArray(this->ArrayName.c_str());  // one of that name is not ours
  try {
    this->AddTransmittance(inputs, output);
  } catch (const Aborted&) {
    return 1;  // as VTK's own filters do
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}
