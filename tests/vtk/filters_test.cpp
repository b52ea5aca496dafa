// SPDX-License-Identifier: Apache-2.0
// The filters for VTK against formulas and against the engine itself.
#include "pipelines.hpp"

#include <gtest/gtest.h>
#include <vtkAppendPolyData.h>
#include <vtkImageShiftScale.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRectilinearGrid.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolumeProperty.h>
#include <cdsm/cdsm.hpp>

namespace cdsm::tests {

namespace {

constexpr double kNear = 0.003;  ///< the tolerance of the maps, and what their steps leave

class VoxelTypes : public testing::TestWithParam<int> {};

TEST_P(VoxelTypes, areReadInPlaceWhereverTheGridLies) {
  const auto image = filledImage(GetParam());
  vtkNew<vtkCdsmShadowFilter> filter;
  setUp(filter);
  filter->SetInputData(image);
  filter->Update();
  const std::vector<float> values = valuesOf(filter->GetOutput());
  ASSERT_EQ(vtkIdType(values.size()), image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    ASSERT_NEAR(values[i], expectedAt(image, image->GetPoint(i)[1]), kNear) << i;
  EXPECT_EQ(filter->GetStats().copiedBytes, 0u);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "density") << "stay the scalars";
}

INSTANTIATE_TEST_SUITE_P(All, VoxelTypes,
                         testing::Values(VTK_UNSIGNED_CHAR, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_SHORT,
                                         VTK_FLOAT));

/// What setUp() and filledImage() mean, written by hand.
Scene handMade(vtkImageData* image) {
  auto data = std::make_shared<VolumeData>();
  data->type = VoxelType::UInt8;
  data->size = {8, 16, 6};
  data->voxels.assign(8 * 16 * 6, std::byte(kVoxel));
  Scene scene;
  scene.volumes.resize(1);
  scene.volumes[0].data = data;
  scene.volumes[0].transfer = {{{0.0f, 0.0f}, {kVoxel, float(kOpacity)}}, {}, {{0.0f, {}}}, float(kUnitDistance)};
  const double* const first = image->GetPoint(0);
  scene.volumes[0].worldFromObject = {
      {0, 0, 0.5f, 0}, {0, -0.125f, 0, 0}, {0.25f, 0, 0, 0}, {float(first[0]), float(first[1]), float(first[2]), 1}};
  scene.shadows.mapSize = 64;
  scene.shadows.tolerance = 0.001f;
  scene.lights.resize(1);
  scene.lights[0].position = {2.0f, 4.0f, -3.0f};
  scene.lights[0].target = {2.0f, 0.0f, -3.0f};
  return scene;
}

TEST(Filters, giveWhatTheEngineGives) {
  const auto image = filledImage(VTK_UNSIGNED_CHAR);
  vtkNew<vtkCdsmShadowFilter> filter;
  setUp(filter);
  filter->SetLightTypeToSpot();
  filter->SetLightPosition(2, 4, -3);
  filter->SetLightTarget(2, 0, -3);
  filter->SetLightCutoff(20);
  filter->SetInputData(image);
  filter->Update();

  Scene scene = handMade(image);
  scene.lights[0].cutoff = 20.0f;
  std::vector<glm::vec3> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    const double* const point = image->GetPoint(i);
    points.emplace_back(point[0], point[1], point[2]);
  }
  std::vector<float> expected;
  std::size_t unlit = 0;
  for (const Transmittance& light : Engine().transmittance(scene, "", points)) {
    expected.push_back(light.transmittance);
    unlit += light.lit == 0;
  }
  EXPECT_EQ(valuesOf(filter->GetOutput()), expected);
  EXPECT_GT(unlit, 0u);
  EXPECT_LT(unlit, points.size());
}

/// Five points from above the image to below it, as the type of data set that T is.
template <class T>
void expectLight(T* asked, vtkImageData* image) {
  vtkNew<vtkCdsmTransmittanceFilter> filter;
  setUp(filter);
  filter->SetInputData(0, asked);
  filter->SetInputData(1, image);
  filter->Update();
  ASSERT_TRUE(T::SafeDownCast(filter->GetOutput())) << filter->GetOutput()->GetClassName();
  const std::vector<float> values = valuesOf(filter->GetOutput());
  ASSERT_EQ(vtkIdType(values.size()), asked->GetNumberOfPoints());
  for (vtkIdType i = 0; i < asked->GetNumberOfPoints(); ++i)
    EXPECT_NEAR(values[i], expectedAt(image, asked->GetPoint(i)[1]), kNear) << asked->GetClassName() << i;
  EXPECT_EQ(values.front(), 1.0f);
  EXPECT_LT(values.back(), 0.5f);
}

TEST(Filters, answerForPointsOfAnyDataset) {
  const auto image = filledImage(VTK_SHORT);
  const double *bounds = image->GetBounds(), x = bounds[0] + 0.1, z = bounds[4] + 0.7;
  const double heights[] = {bounds[3] + 1, bounds[3], 0.5 * (bounds[2] + bounds[3]), bounds[2], bounds[2] - 2};
  for (const int precision : {VTK_FLOAT, VTK_DOUBLE}) {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    points->SetDataType(precision);
    for (const double y : heights) points->InsertNextPoint(x, y, z);
    grid->SetPoints(points);
    expectLight(grid.GetPointer(), image);
  }
  vtkNew<vtkImageData> probe;
  probe->SetDimensions(1, 5, 1);
  probe->SetOrigin(x, heights[0], z);
  probe->SetSpacing(1, 1, 1);
  probe->SetDirectionMatrix(1, 0, 0, 0, -1, 0, 0, 0, 1);
  expectLight(probe.GetPointer(), image);
}

TEST(Filters, multiplySurfaces) {
  vtkNew<vtkCdsmTransmittanceFilter> filter;
  setUp(filter);
  filter->SetSurfaceOpacity(0.5);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(square(1.0));
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  filter->AddInputConnection(2, strips->GetOutputPort());
  filter->AddInputData(2, square(0.0));
  vtkNew<vtkPolyData> nothing;
  filter->AddInputData(2, nothing);
  vtkNew<vtkPolyData> asked;
  vtkNew<vtkPoints> points;
  for (const double y : {2.0, 0.5, -1.0}) points->InsertNextPoint(0.3, y, 0.2);
  asked->SetPoints(points);
  filter->SetInputData(0, asked);
  filter->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  const std::vector<float> expected = {1.0f, 0.5f, 0.25f};
  EXPECT_EQ(valuesOf(filter->GetOutput()), expected);
}

TEST(Filters, biasMovesPointsTowardsTheLight) {
  vtkNew<vtkCdsmTransmittanceFilter> filter;
  setUp(filter);
  filter->SetInputData(0, square(1.0));
  filter->AddInputData(2, square(2.0));
  filter->AddInputData(2, square(0.0));
  filter->SetMapSize(512);
  filter->SetLightCutoff(60);
  for (const int type : {vtkCdsmFilter::DIRECTIONAL, vtkCdsmFilter::OMNI, vtkCdsmFilter::SPOT})
    for (const double side : {1.0, -1.0}) {  // light from above, and from below
      filter->SetLightType(type);
      filter->SetLightPosition(0, 20 * side, 0);
      filter->SetLightDirection(0, -side, 0);
      for (const double bias : {0.0, 0.9, 1.8, 90.0}) {  // the last one only almost to where the light is
        filter->SetBias(bias);
        filter->Update();
        EXPECT_EQ(valuesOf(filter->GetOutput())[4], bias > 1.0 ? 1.0f : 0.0f) << type << " " << side << " " << bias;
      }
    }
}

TEST(Filters, passOnNoArrayOfTheirNameThatIsNotTheirs) {
  vtkNew<vtkCdsmShadowFilter> first, second;
  setUp(first);
  first->SetInputData(filledImage(VTK_FLOAT));
  second->SetInputConnection(first->GetOutputPort());
  second->SetMapSize(0);
  const ErrorLog log(second);
  second->Update();
  EXPECT_TRUE(first->GetOutput()->GetPointData()->HasArray("Transmittance"));
  EXPECT_FALSE(second->GetOutput()->GetPointData()->HasArray("Transmittance"));
}

TEST(Filters, giveFullLightWithoutCasters) {
  vtkNew<vtkCdsmTransmittanceFilter> filter;
  filter->SetInputData(square(0.0));
  filter->SetLightPosition(0, 5, 0);
  filter->SetLightCutoff(89);
  filter->Update();
  EXPECT_EQ(valuesOf(filter->GetOutput()), std::vector<float>(5, 1.0f));
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("Transmittance"));
}

TEST(Filters, askForTheWholeImage) {
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(0, 9, 0, 9, 0, 9);
  vtkNew<vtkCdsmShadowFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetLightTypeToOmni();
  filter->SetLightPosition(4, 30, 4);
  filter->GetVolumeProperty()->SetScalarOpacityUnitDistance(20);
  filter->UpdateExtent(std::array<int, 6>{2, 4, 2, 4, 2, 4}.data());
  const std::vector<float> whole = valuesOf(filter->GetOutput());
  EXPECT_EQ(whole.size(), 1000u);
  EXPECT_LT(*std::min_element(whole.begin(), whole.end()), 0.9f);
}

}  // namespace

}  // namespace cdsm::tests
