// SPDX-License-Identifier: Apache-2.0
// Wrong input gets an error that says what would be right, an output without the array, and a filter that works on.
#include "pipelines.hpp"

#include <functional>
#include <limits>

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageShiftScale.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkVolumeProperty.h>
#include <cdsm/error.hpp>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::tests {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Shadows {
  vtkSmartPointer<vtkImageData> image = filledImage(VTK_FLOAT);
  vtkSmartPointer<vtkPolyData> surface = square(30.0);
  vtkNew<vtkCdsmShadowFilter> filter;

  vtkDataArray* scalars() const { return image->GetPointData()->GetScalars(); }
  vtkVolumeProperty* property() const { return filter->GetVolumeProperty(); }
};

struct Wrong {
  const char* name;
  std::function<void(Shadows&)> spoil;
  const char* message;
};

void useCellData(Shadows& setup) {
  vtkNew<vtkFloatArray> cells;
  cells->SetNumberOfValues(setup.image->GetNumberOfCells());
  cells->SetName("cells");
  setup.image->GetCellData()->AddArray(cells);
}

void useArray(Shadows& setup, vtkDataArray* array, int components = 1) {
  array->SetName("other");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(setup.image->GetNumberOfPoints());
  array->Fill(1.0);
  setup.image->GetPointData()->SetScalars(array);
}

void spoilOpacity(Shadows& setup, double value) {
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0, 0);
  function->AddPoint(1, value);
  setup.property()->SetScalarOpacity(function);
}

const Wrong kWrong[] = {
    {"noScalars", [](Shadows& s) { s.image->GetPointData()->Initialize(); }, "has no scalars of its points"},
    {"cellScalars",
     [](Shadows& s) {
       s.image->GetPointData()->Initialize();
       useCellData(s);
     },
     "vtkCellDataToPointData"},
    {"cellArray",
     [](Shadows& s) {
       useCellData(s);
       s.filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells");
     },
     "of its cells, must be of its points"},
    {"unknownArray",
     [](Shadows& s) { s.filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "missing"); },
     "not those of SetInputArrayToProcess()"},
    {"doubles", [](Shadows& s) { s.image->AllocateScalars(VTK_DOUBLE, 1); }, "is of type double, must be float"},
    {"ints", [](Shadows& s) { s.image->AllocateScalars(VTK_INT, 1); }, "is of type int, must be float"},
    {"components", [](Shadows& s) { s.image->AllocateScalars(VTK_FLOAT, 3); }, "has 3 components, must have one"},
    {"tooFewValues", [](Shadows& s) { s.scalars()->SetNumberOfTuples(7); }, "has 7 values for 768 points"},
    {"scatteredValues", [](Shadows& s) { useArray(s, vtkNew<vtkSOADataArrayTemplate<float>>()); },
     "does not lie side by side"},
    {"nanVoxel", [](Shadows& s) { s.scalars()->SetComponent(5, 0, kNaN); }, "is not finite"},
    {"noVoxels", [](Shadows& s) { s.image->SetExtent(0, -1, 0, -1, 0, -1); }, "the array 'density' has 768 values"},
    {"flatVoxels", [](Shadows& s) { s.image->SetSpacing(1, 0, 1); }, "the transform cannot be inverted"},
    {"nanOrigin", [](Shadows& s) { s.image->SetOrigin(kNaN, 0, 0); }, "cannot be inverted"},
    {"noProperty", [](Shadows& s) { s.filter->SetVolumeProperty(nullptr); }, "there is no volume property"},
    {"opacityAboveOne", [](Shadows& s) { spoilOpacity(s, 1.5); }, "opacity is 1.5"},
    {"nanOpacity", [](Shadows& s) { spoilOpacity(s, kNaN); }, "opacity is nan"},
    {"noOpacity", [](Shadows& s) { s.property()->GetScalarOpacity()->RemoveAllPoints(); }, "opacity has no points"},
    {"unitDistance", [](Shadows& s) { s.property()->SetScalarOpacityUnitDistance(0); }, "unit_distance is 0"},
    {"gradientOpacity",
     [](Shadows& s) {
       vtkNew<vtkPiecewiseFunction> function;
       function->AddPoint(0, 0.5);
       s.property()->SetGradientOpacity(function);
     },
     "opacity depends on the gradient"},
    {"twoDimensions", [](Shadows& s) { s.property()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D); },
     "is of two dimensions"},
    {"lightType", [](Shadows& s) { s.filter->SetLightType(3); }, "LightType is 3, must be"},
    {"lightDirection", [](Shadows& s) { s.filter->SetLightDirection(0, 0, 0); }, "has no length"},
    {"nanLight",
     [](Shadows& s) {
       s.filter->SetLightTypeToOmni();
       s.filter->SetLightPosition(kNaN, 0, 0);
     },
     "position is nan"},
    {"cutoff",
     [](Shadows& s) {
       s.filter->SetLightTypeToSpot();
       s.filter->SetLightCutoff(90);
     },
     "cutoff is 90"},
    {"technique", [](Shadows& s) { s.filter->SetTechnique("magic"); }, "magic"},
    {"nullTechnique", [](Shadows& s) { s.filter->SetTechnique(nullptr); }, "technique"},
    {"mapSize", [](Shadows& s) { s.filter->SetMapSize(0); }, "map_size is 0"},
    {"tolerance", [](Shadows& s) { s.filter->SetTolerance(kNaN); }, "tolerance is nan"},
    {"device", [](Shadows& s) { s.filter->SetDevice("no such device"); }, "no such device"},
    {"surfaceOpacity", [](Shadows& s) { s.filter->SetSurfaceOpacity(2); }, "opacity is 2"},
    {"nanSurface", [](Shadows& s) { s.surface->GetPoints()->SetPoint(2, kNaN, 0, 0); }, "point 2 of a surface"},
    {"surfaceIndex",
     [](Shadows& s) {
       vtkNew<vtkCellArray> cells;
       cells->InsertNextCell({0, 1, 9});
       s.surface->SetPolys(cells);
     },
     "has the point 9, must be in 0 to 4"},
};

class WrongInput : public testing::TestWithParam<Wrong> {};

TEST_P(WrongInput, isToldAndForgiven) {
  Shadows setup;
  setUp(setup.filter);
  setup.filter->AddInputData(1, setup.surface);
  setup.filter->SetInputData(setup.image);
  setup.filter->Update();
  GetParam().spoil(setup);
  setup.image->Modified();
  setup.surface->Modified();
  {
    const ErrorLog log(setup.filter);
    setup.filter->Update();
    EXPECT_NE(log.text.find(GetParam().message), std::string::npos) << log.text;
    EXPECT_EQ(setup.filter->GetOutput()->GetPointData()->GetArray("Transmittance"), nullptr);
  }
  setup.filter->RemoveAllObservers();
  vtkNew<vtkVolumeProperty> property;
  setup.filter->SetVolumeProperty(property);
  setUp(setup.filter);
  setup.filter->SetLightDirection(0, -1, 0);
  setup.filter->SetTechnique("deep-shadow-map");
  setup.filter->SetDevice("");
  setup.filter->SetSurfaceOpacity(0);
  setup.filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  setup.filter->SetInputDataObject(1, square(30.0));
  const auto image = filledImage(VTK_FLOAT);
  setup.filter->SetInputData(image);
  setup.filter->Update();
  const std::vector<float> values = valuesOf(setup.filter->GetOutput());
  ASSERT_EQ(values.size(), 768u);
  EXPECT_NEAR(values[15 * 8], expectedAt(image, image->GetPoint(15 * 8)[1]), 0.003);
}

INSTANTIATE_TEST_SUITE_P(All, WrongInput, testing::ValuesIn(kWrong),
                         [](const testing::TestParamInfo<Wrong>& info) { return info.param.name; });

TEST(WrongInput, ofConversionsIsTold) {
  vtkNew<vtkImageData> image;
  EXPECT_THROW(vtk::transferFunction(nullptr), Error);
  EXPECT_THROW(vtk::volume(nullptr, nullptr), Error);
  EXPECT_THROW(vtk::volume(image, nullptr), Error);
  EXPECT_THROW(vtk::meshData(nullptr), Error);
}

TEST(WrongInput, ofQueriesIsTold) {
  vtkNew<vtkCdsmTransmittanceFilter> filter;
  ErrorLog log(filter);
  const auto asked = square(0.0);
  asked->GetPoints()->SetPoint(1, kNaN, 0, 0);
  filter->SetInputData(asked);
  filter->Update();
  EXPECT_NE(log.text.find("point 1"), std::string::npos) << log.text;
  asked->GetPoints()->SetPoint(1, 0, 0, 0);
  asked->GetPoints()->Modified();
  filter->SetBias(-1);
  filter->Update();
  EXPECT_NE(log.text.find("Bias is -1"), std::string::npos) << log.text;
  filter->SetBias(0);
  ShadowSettings colored;
  colored.transmittance = "rgb";
  filter->SetShadows(colored);
  filter->Update();
  EXPECT_NE(log.text.find("must be 'grey'"), std::string::npos) << log.text;
  filter->SetShadows(ShadowSettings());
  filter->Update();
  EXPECT_EQ(valuesOf(filter->GetOutput()).size(), 5u);
}

}  // namespace

}  // namespace cdsm::tests
