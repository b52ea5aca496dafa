// SPDX-License-Identifier: Apache-2.0
// What the filters of this folder share: a light, what casts shadows, and an engine that is kept from one execution to
// the next, so that only what has changed is built again.
#pragma once

#include <memory>
#include <string>

#include <vtkDataSetAlgorithm.h>
#include <vtkSmartPointer.h>
#include <cdsm/cdsm.hpp>

class vtkVolumeProperty;

/// Passes a data set on with one more array of points: what of a light gets there, float in [0, 1], 0 outside of a spot
/// light's cone. The scalars of the image that casts are those of SetInputArrayToProcess(0, ...), else the active ones
/// of its points; they are read in place, and kept until another execution or Drop(). Whole extents are asked for.
///
/// Errors go to vtkErrorMacro: the array is then missing, and the filter can be used on. Where AbortExecute is set, by
/// an observer of progress for instance, execution ends without the array, too.
class CDSM_API vtkCdsmFilter : public vtkDataSetAlgorithm {
 public:
  vtkAbstractTypeMacro(vtkCdsmFilter, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LightTypes { SPOT, OMNI, DIRECTIONAL };

  /// SPOT, a cone; OMNI, to all sides; DIRECTIONAL, parallel light. Default: SPOT.
  vtkSetMacro(LightType, int);
  vtkGetMacro(LightType, int);
  void SetLightTypeToSpot() { this->SetLightType(SPOT); }
  void SetLightTypeToOmni() { this->SetLightType(OMNI); }
  void SetLightTypeToDirectional() { this->SetLightType(DIRECTIONAL); }

  /// Of spot and omni lights. Default: (0, 1, 0).
  vtkSetVector3Macro(LightPosition, double);
  vtkGetVector3Macro(LightPosition, double);

  /// A point that a spot light shines at. Default: (0, 0, 0).
  vtkSetVector3Macro(LightTarget, double);
  vtkGetVector3Macro(LightTarget, double);

  /// The way in which directional light travels. Default: (0, -1, 0).
  vtkSetVector3Macro(LightDirection, double);
  vtkGetVector3Macro(LightDirection, double);

  /// Half the angle of a spot light's cone in degrees, in (0, 90). Default: 30.
  vtkSetMacro(LightCutoff, double);
  vtkGetMacro(LightCutoff, double);

  /// Opacities and unit distance of the image's component 0. There is one from the beginning.
  virtual void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();

  /// Of one crossing of the surfaces, in [0, 1]. Default: 1.
  vtkSetMacro(SurfaceOpacity, double);
  vtkGetMacro(SurfaceOpacity, double);

  /// Technique, size of maps, tolerance and the like; those below are of them.
  /// `transmittance` must be "grey", or the filter fails.
  void SetShadows(const cdsm::ShadowSettings& shadows);
  const cdsm::ShadowSettings& GetShadows() const { return this->Shadows; }
  void SetTechnique(const char* technique);
  void SetMapSize(int texels);
  void SetTolerance(double tolerance);

  /// Of the array that is added. Default: Transmittance.
  vtkSetStdStringFromCharMacro(ArrayName);
  vtkGetCharFromStdStringMacro(ArrayName);

  /// OpenCL device: "platform:device" or part of a name. Default: CDSM_DEVICE in the environment, else the first
  /// usable.
  vtkSetStdStringFromCharMacro(Device);
  vtkGetCharFromStdStringMacro(Device);

  /// What the last execution built: maps, bytes that were uploaded or copied.
  const cdsm::FrameStats& GetStats() const;

  /// Lets go of the engine, with what it has built and the arrays that it keeps.
  void Drop();

  vtkMTimeType GetMTime() override;

  vtkCdsmFilter(const vtkCdsmFilter&) = delete;
  void operator=(const vtkCdsmFilter&) = delete;

 protected:
  /// Port 0 is what is asked about. The image casts; it may be port 0 itself.
  vtkCdsmFilter(int imagePort, int surfacePort);
  ~vtkCdsmFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  double Bias = 0.0;  ///< world units by which points are moved towards the light

 private:
  struct Internals;

  cdsm::Engine& UseEngine();
  void TellProgress(double done);
  cdsm::Light MakeLight() const;
  cdsm::Scene MakeScene(vtkInformationVector** inputs);
  void AddImage(cdsm::Scene& scene, vtkInformationVector** inputs);
  void AddSurfaces(cdsm::Scene& scene, vtkInformationVector* surfaces);
  void AddTransmittance(vtkInformationVector** inputs, vtkDataSet* output);

  int ImagePort, SurfacePort;
  int LightType = SPOT;
  double LightPosition[3] = {0.0, 1.0, 0.0};
  double LightTarget[3] = {0.0, 0.0, 0.0};
  double LightDirection[3] = {0.0, -1.0, 0.0};
  double LightCutoff = 30.0;
  double SurfaceOpacity = 1.0;
  vtkSmartPointer<vtkVolumeProperty> VolumeProperty;
  cdsm::ShadowSettings Shadows;
  std::string ArrayName = "Transmittance";
  std::string Device;
  std::unique_ptr<Internals> Internal;
};
