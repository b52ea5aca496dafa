// SPDX-License-Identifier: Apache-2.0
// Transfer functions of VTK as points with straight lines in between.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>
#include <cdsm/error.hpp>
#include <cdsm/vtk/convert.hpp>

namespace cdsm::vtk {

namespace {

constexpr double kTolerance = 1e-3;  ///< of opacities and colours
constexpr int kMostHalvings = 13;    ///< of the way between two nodes, for steps have no end
constexpr int kShares = 1024;  ///< of the range of values: how far a function without clamping reaches past its end

struct Node {
  double at;
  double midpoint, sharpness;  ///< of the curve to the next node
  glm::dvec3 value;            ///< a colour, or an opacity three times
};

/// A function of VTK, whichever of its two kinds.
struct Curve {
  std::vector<Node> nodes;
  std::function<glm::dvec3(double)> valueAt;
  bool straight = true;  ///< linear between nodes that have neither midpoint nor sharpness
  bool clamped = true;   ///< constant outside; else 0
};

Curve opacityCurve(vtkPiecewiseFunction* function) {
  Curve curve;
  for (int i = 0; i < function->GetSize(); ++i) {
    double node[4];
    function->GetNodeValue(i, node);
    curve.nodes.push_back({node[0], node[2], node[3], glm::dvec3(node[1])});
  }
  curve.valueAt = [function](double at) { return glm::dvec3(function->GetValue(at)); };
  curve.straight = !function->GetUseLogScale();
  curve.clamped = function->GetClamping();
  return curve;
}

Curve colorCurve(vtkColorTransferFunction* function) {
  Curve curve;
  for (int i = 0; i < function->GetSize(); ++i) {
    double node[6];
    function->GetNodeValue(i, node);
    curve.nodes.push_back({node[0], node[4], node[5], {node[1], node[2], node[3]}});
  }
  curve.valueAt = [function](double at) {
    double rgb[3];
    function->GetColor(at, rgb);
    return glm::dvec3(rgb[0], rgb[1], rgb[2]);
  };
  curve.straight = function->GetColorSpace() == VTK_CTF_RGB && function->GetScale() == VTK_CTF_LINEAR;
  curve.clamped = function->GetClamping();
  return curve;
}

struct Point {
  double at;
  glm::dvec3 value;
};

/// Whether a straight line from a to b is near enough, judged at its quarters.
bool isStraight(const Curve& curve, const Point& a, const Point& b) {
  for (const double share : {0.25, 0.5, 0.75}) {
    const glm::dvec3 off = curve.valueAt(glm::mix(a.at, b.at, share)) - glm::mix(a.value, b.value, share);
    if (glm::any(glm::greaterThan(glm::abs(off), glm::dvec3(kTolerance)))) return false;
  }
  return true;
}

/// Appends what is needed between a and b, and b.
void appendBent(const Curve& curve, const Point& a, const Point& b, int halvings, std::vector<Point>& points) {
  if (halvings > 0 && !isStraight(curve, a, b)) {
    const double middle = 0.5 * (a.at + b.at);
    const Point between{middle, curve.valueAt(middle)};
    appendBent(curve, a, between, halvings - 1, points);
    appendBent(curve, between, b, halvings - 1, points);
  } else {
    points.push_back(b);
  }
}

void appendSegment(const Curve& curve, const Node& a, const Node& b, std::vector<Point>& points) {
  const bool plain = a.midpoint == 0.5 && a.sharpness == 0.0;
  const Point end{b.at, b.value};
  if ((curve.straight && plain) || !(b.at > a.at)) return points.push_back(end);
  // the curve has a corner at the midpoint
  const double corner = glm::mix(a.at, b.at, a.midpoint);
  const Point middle{corner, curve.valueAt(corner)};
  appendBent(curve, {a.at, a.value}, middle, kMostHalvings, points);
  appendBent(curve, middle, end, kMostHalvings, points);
}

/// Steps to 0 at both ends. The last value itself counts as inside, so the upper step lies a little above it: by one
/// where all values are whole ones, as labels are.
void appendEnds(const Curve& curve, std::vector<Point>& points) {
  const bool whole = std::all_of(curve.nodes.begin(), curve.nodes.end(),
                                 [](const Node& node) { return node.at == std::floor(node.at); });
  const double last = points.back().at, span = last - points.front().at;
  const double past = last + (whole ? 1.0 : (span > 0.0 ? span : std::max(std::abs(last), 1.0)) / kShares);
  points.insert(points.begin(), {points.front().at, glm::dvec3(0.0)});
  points.push_back({past, points.back().value});
  points.push_back({past, glm::dvec3(0.0)});
}

std::vector<Point> pointsOf(const Curve& curve) {
  if (curve.nodes.empty()) return {};
  std::vector<Point> points = {{curve.nodes.front().at, curve.nodes.front().value}};
  for (std::size_t i = 1; i < curve.nodes.size(); ++i) appendSegment(curve, curve.nodes[i - 1], curve.nodes[i], points);
  if (!curve.clamped) appendEnds(curve, points);
  return points;
}

void requireOneDimension(vtkVolumeProperty* property) {
  if (!property) throw Error("there is no volume property, must be one");
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
    throw Error("the transfer function is of two dimensions, must be of one (SetTransferFunctionMode(TF_1D))");
  if (property->GetDisableGradientOpacity() || !property->HasGradientOpacity()) return;
  const Curve gradient = opacityCurve(property->GetStoredGradientOpacity());
  for (const Node& node : gradient.nodes)
    if (node.value.x != 1.0) throw Error("opacity depends on the gradient, must not (DisableGradientOpacityOn())");
}

}  // namespace

TransferFunction transferFunction(vtkVolumeProperty* property) {
  requireOneDimension(property);
  TransferFunction transfer;
  for (const Point& point : pointsOf(opacityCurve(property->GetScalarOpacity())))
    transfer.opacity.push_back({float(point.at), float(point.value.x)});
  const bool grey = property->GetColorChannels() == 1;
  const Curve color =
      grey ? opacityCurve(property->GetGrayTransferFunction()) : colorCurve(property->GetRGBTransferFunction());
  for (const Point& point : pointsOf(color)) transfer.color.push_back({float(point.at), glm::vec3(point.value)});
  transfer.unitDistance = float(property->GetScalarOpacityUnitDistance());
  return transfer;
}

}  // namespace cdsm::vtk
