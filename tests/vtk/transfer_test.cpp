// SPDX-License-Identifier: Apache-2.0
// Transfer functions of VTK against VTK's own values.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::tests {

namespace {

/// Linear between points, constant outside.
template <class Point, class Value>
Value linear(const std::vector<Point>& points, double at, Value Point::*value) {
  std::size_t after = 0;
  while (after < points.size() && points[after].value <= at) ++after;
  if (after == 0) return points.front().*value;
  if (after == points.size()) return points.back().*value;
  const Point &a = points[after - 1], &b = points[after];
  return a.*value + (b.*value - a.*value) * float((at - a.value) / (b.value - a.value));
}

TransferFunction converted(vtkPiecewiseFunction* opacity, vtkColorTransferFunction* color = nullptr) {
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(3.5);
  if (color) property->SetColor(color);
  return vtk::transferFunction(property);
}

TEST(Transfer, nodesAreTakenAsTheyAre) {
  vtkNew<vtkPiecewiseFunction> function;
  function->AllowDuplicateScalarsOn();
  function->AddPoint(-5, 0.1);
  function->AddPoint(3, 0.7);
  function->AddPoint(3, 0.2);
  function->AddPoint(10, 0.9);
  const TransferFunction transfer = converted(function);
  EXPECT_EQ(transfer.unitDistance, 3.5f);
  const std::vector<std::pair<float, float>> expected = {{-5, 0.1f}, {3, 0.7f}, {3, 0.2f}, {10, 0.9f}};
  ASSERT_EQ(transfer.opacity.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(std::pair(transfer.opacity[i].value, transfer.opacity[i].opacity), expected[i]);
}

TEST(Transfer, bentOpacitiesAreFollowed) {
  for (const double sharpness : {0.0, 0.3, 0.8})
    for (const double midpoint : {0.5, 0.2}) {
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(-1, 0.0, midpoint, sharpness);
      function->AddPoint(4, 1.0, midpoint, sharpness);
      function->AddPoint(7, 0.3);
      const TransferFunction transfer = converted(function);
      for (double x = -2; x < 8; x += 0.01)
        EXPECT_NEAR(linear(transfer.opacity, x, &TransferFunction::OpacityPoint::opacity), function->GetValue(x), 0.002)
            << "at " << x << ", midpoint " << midpoint << ", sharpness " << sharpness;
      EXPECT_LT(transfer.opacity.size(), 400u);
    }
}

TEST(Transfer, stepsAreThin) {
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0, 0.1, 0.5, 1.0);
  function->AddPoint(8, 0.9);
  const TransferFunction transfer = converted(function);
  EXPECT_LT(transfer.opacity.size(), 50u);
  for (const double x : {1.0, 3.99, 4.01, 7.0})
    EXPECT_NEAR(linear(transfer.opacity, x, &TransferFunction::OpacityPoint::opacity), x < 4 ? 0.1 : 0.9, 1e-6) << x;
}

TEST(Transfer, logarithmsAreFollowed) {
  vtkNew<vtkPiecewiseFunction> function;
  function->UseLogScaleOn();
  function->AddPoint(1, 0.0);
  function->AddPoint(1000, 1.0);
  const TransferFunction transfer = converted(function);
  for (double x = 1; x < 1000; x *= 1.05)
    EXPECT_NEAR(linear(transfer.opacity, x, &TransferFunction::OpacityPoint::opacity), function->GetValue(x), 0.002);
}

TEST(Transfer, isZeroBeyondTheEndsWithoutClamping) {
  const auto opacity = &TransferFunction::OpacityPoint::opacity;
  for (const double first : {10.0, 10.5}) {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(first, 0.5);
    function->AddPoint(20, 0.75);
    EXPECT_EQ(linear(converted(function).opacity, 25, opacity), 0.75f);
    function->ClampingOff();
    const TransferFunction transfer = converted(function);
    const double past = first == 10.0 ? 21 : 20.01;
    for (const double x : {first - 1e-3, past}) EXPECT_EQ(linear(transfer.opacity, x, opacity), 0.0f) << x;
    for (const double x : {first, 20.0}) EXPECT_EQ(linear(transfer.opacity, x, opacity), x < 20 ? 0.5f : 0.75f) << x;
  }
}

TEST(Transfer, colorsAreFollowedInTheirSpace) {
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0, 0.9, 0.2, 0.1);
  color->AddRGBPoint(5, 0.1, 0.3, 0.8);
  EXPECT_EQ(converted(opacity, color).color.size(), 2u);
  for (const int space : {VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING}) {
    color->SetColorSpace(space);
    const TransferFunction transfer = converted(opacity, color);
    for (double x = -1; x < 6; x += 0.01) {
      const glm::vec3 rgb = linear(transfer.color, x, &TransferFunction::ColorPoint::color);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(rgb[channel], color->GetColor(x)[channel], 0.002) << "space " << space << " at " << x;
    }
  }
}

TEST(Transfer, greyAndDisabledGradientsAreUnderstood) {
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkPiecewiseFunction> grey, gradient;
  grey->AddPoint(0, 0.25);
  property->SetColor(grey);
  gradient->AddPoint(0, 1);
  gradient->AddPoint(9, 1);
  property->SetGradientOpacity(gradient);
  EXPECT_EQ(vtk::transferFunction(property).color.front().color, glm::vec3(0.25f));
  gradient->AddPoint(9, 0.5);
  property->DisableGradientOpacityOn();
  EXPECT_NO_THROW(vtk::transferFunction(property));
}

}  // namespace

}  // namespace cdsm::tests
