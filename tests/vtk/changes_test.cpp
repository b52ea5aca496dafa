// SPDX-License-Identifier: Apache-2.0
// A pipeline that is updated again and again builds what has changed, and nothing else.
#include "pipelines.hpp"

#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkVolumeProperty.h>
#include <cdsm/cdsm.hpp>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::tests {

namespace {

constexpr vtkIdType kLowest = 4 + 8 * (15 + 16 * 3);  ///< of filledImage(): amid its lowest points

struct Pipeline {
  Pipeline() {
    setUp(filter);
    filter->SetInputData(image);
    filter->AddInputData(1, surface);
    filter->SetSurfaceOpacity(0.5);
    filter->Update();
  }

  float lowest() { return valuesOf(filter->GetOutput())[kLowest]; }
  float expected(double surfaces = 0.5) { return float(surfaces * expectedAt(image, image->GetPoint(kLowest)[1])); }

  vtkSmartPointer<vtkImageData> image = filledImage(VTK_FLOAT);
  vtkSmartPointer<vtkPolyData> surface = square(5.0);
  vtkNew<vtkCdsmShadowFilter> filter;
};

TEST(Changes, noneMeansNoExecution) {
  Pipeline p;
  vtkDataArray* const before = p.filter->GetOutput()->GetPointData()->GetArray("Transmittance");
  p.filter->Update();
  EXPECT_EQ(p.filter->GetOutput()->GetPointData()->GetArray("Transmittance"), before);
}

TEST(Changes, ofTheLightUploadNoData) {
  Pipeline p;
  EXPECT_NEAR(p.lowest(), p.expected(), 0.003);
  p.filter->SetLightDirection(0, 1, 0);
  p.filter->Update();
  EXPECT_NEAR(p.lowest(), std::pow(1.0 - kOpacity, 0.0625 / kUnitDistance), 0.003);
  EXPECT_LT(p.filter->GetStats().uploadedBytes, p.image->GetNumberOfPoints() * sizeof(float) / 2);
}

TEST(Changes, ofArrayNameBuildNoMap) {
  Pipeline p;
  p.filter->SetArrayName("light");
  p.filter->Update();
  EXPECT_FALSE(valuesOf(p.filter->GetOutput(), "light").empty());
  ASSERT_EQ(p.filter->GetStats().lights.size(), 1u);
  for (const MapStats& map : p.filter->GetStats().lights[0].maps) EXPECT_FALSE(map.regenerated) << map.reason;
}

TEST(Changes, ofVoxelsAreSeenInTheSameArray) {
  Pipeline p;
  p.image->GetPointData()->GetScalars()->Fill(0.0);
  p.image->Modified();
  p.filter->Update();
  EXPECT_EQ(p.lowest(), 0.5f);
  EXPECT_EQ(p.filter->GetStats().copiedBytes, 0u);
  p.image->GetPointData()->GetScalars()->Fill(kVoxel);
  p.image->GetPointData()->GetScalars()->Modified();
  p.filter->Update();
  EXPECT_NEAR(p.lowest(), p.expected(), 0.003);
}

TEST(Changes, ofArraysAndGridsAreSeen) {
  Pipeline p;
  p.image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  p.image->GetPointData()->GetScalars()->Fill(kVoxel);
  p.filter->Update();
  EXPECT_NEAR(p.lowest(), p.expected(), 0.003);
  p.image->SetSpacing(0.5, 0.125, 0.5);
  p.filter->Update();
  EXPECT_NEAR(p.lowest(), p.expected(), 0.003);
}

TEST(Changes, ofSurfacesAndOpacitiesAreSeen) {
  Pipeline p;
  p.surface->GetPoints()->SetPoint(0, 100, 5, 100);
  p.surface->GetPoints()->SetPoint(1, 100, 5, 100);
  p.surface->GetPoints()->SetPoint(2, 100, 5, 100);
  p.surface->GetPoints()->Modified();
  p.filter->Update();
  EXPECT_NEAR(p.lowest(), p.expected(1.0), 0.003);
  p.filter->GetVolumeProperty()->GetScalarOpacity()->AddPoint(kVoxel, 0.0);
  p.filter->Update();
  EXPECT_EQ(p.lowest(), 1.0f);
}

TEST(Changes, pointsOfSurfacesStayInPlace) {
  const auto surface = square(5.0);
  const auto inPlace = vtk::meshData(surface);
  EXPECT_EQ(static_cast<const void*>(inPlace->positions.sideBySide()), surface->GetPoints()->GetVoidPointer(0));
  vtkNew<vtkPoints> doubles;
  doubles->SetDataTypeToDouble();
  doubles->DeepCopy(surface->GetPoints());
  surface->SetPoints(doubles);
  const auto copied = vtk::meshData(surface);
  ASSERT_EQ(copied->positions.size(), inPlace->positions.size());
  for (std::size_t i = 0; i < copied->positions.size(); ++i) EXPECT_EQ(copied->positions[i], inPlace->positions[i]);
}

TEST(Changes, ofPlacesOfPointsAreSeen) {
  Pipeline p;
  const void* const before = p.surface->GetPoints()->GetVoidPointer(0);
  const vtkMTimeType time = p.surface->GetMTime();
  p.surface->GetPoints()->GetData()->Resize(1 << 20);
  ASSERT_NE(p.surface->GetPoints()->GetVoidPointer(0), before);
  ASSERT_EQ(p.surface->GetMTime(), time);
  p.filter->SetLightDirection(0.1, -1, 0);
  p.filter->Update();
  EXPECT_LT(p.lowest(), 0.5f);
}

TEST(Changes, arrayIsKeptUntilDropped) {
  Pipeline p;
  vtkDataArray* const scalars = p.image->GetPointData()->GetScalars();
  p.filter->RemoveAllInputs();
  p.filter->GetOutput()->Initialize();
  const int kept = scalars->GetReferenceCount();
  p.filter->Drop();
  EXPECT_EQ(scalars->GetReferenceCount(), kept - 1);
}

TEST(Changes, progressIsToldAndAbortEndsExecution) {
  Pipeline p;
  struct Told {
    std::vector<double> progress;
    bool abort = false;
  } told;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&told);
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void* progress) {
    auto& told = *static_cast<Told*>(data);
    told.progress.push_back(*static_cast<double*>(progress));
    if (told.abort) static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  });
  p.filter->AddObserver(vtkCommand::ProgressEvent, command);
  p.image->Modified();
  p.filter->Update();
  EXPECT_GT(told.progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(told.progress.begin(), told.progress.end()));
  EXPECT_EQ(told.progress.back(), 1.0);

  told.abort = true;
  p.image->Modified();
  p.filter->Update();
  EXPECT_TRUE(valuesOf(p.filter->GetOutput()).empty());
  told.abort = false;
  p.image->Modified();
  p.filter->Update();
  EXPECT_NEAR(p.lowest(), p.expected(), 0.003);
}

}  // namespace

}  // namespace cdsm::tests
