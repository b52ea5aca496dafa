// SPDX-License-Identifier: Apache-2.0
// A volume sampled as INTERFACE says: interpolate the scalar, then classify.
#include "grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace cdsm::reference {
namespace {

constexpr double kLargestOpacity = 0.9999;

/// A gradient below this part of the largest value per voxel is rounding: the field is flat.
constexpr double kFlatGradient = 1e-6;

template <typename T>
std::vector<double> decodeAs(const std::vector<std::byte>& bytes) {
  std::vector<double> values(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < values.size(); ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    values[i] = static_cast<double>(value);
  }
  return values;
}

std::vector<double> decode(const VolumeData& data) {
  switch (data.type) {
    case VoxelType::UInt8:
      return decodeAs<std::uint8_t>(data.voxels);
    case VoxelType::Int8:
      return decodeAs<std::int8_t>(data.voxels);
    case VoxelType::UInt16:
      return decodeAs<std::uint16_t>(data.voxels);
    case VoxelType::Int16:
      return decodeAs<std::int16_t>(data.voxels);
    case VoxelType::Float32:
      return decodeAs<float>(data.voxels);
  }
  return {};
}

double mix(double a, double b, double f) { return a + (b - a) * f; }

/// The piecewise-linear function through points with a member `value`; `get` yields what is interpolated.
template <typename Point, typename Get>
auto interpolate(const std::vector<Point>& points, double value, Get get) {
  const auto above = std::find_if(points.begin(), points.end(), [&](const Point& p) { return value < p.value; });
  if (above == points.begin()) return get(points.front());
  if (above == points.end()) return get(points.back());
  const auto below = above - 1;
  const double f = (value - below->value) / (double(above->value) - double(below->value));
  return get(*below) + (get(*above) - get(*below)) * f;
}

}  // namespace

double opacityAt(const TransferFunction& transfer, double value) {
  if (transfer.opacity.empty()) return 0.0;
  return interpolate(transfer.opacity, value,
                     [](const TransferFunction::OpacityPoint& p) { return static_cast<double>(p.opacity); });
}

glm::dvec3 colorAt(const TransferFunction& transfer, double value) {
  if (transfer.color.empty()) return glm::dvec3(1.0);
  return interpolate(transfer.color, value, [](const TransferFunction::ColorPoint& p) { return glm::dvec3(p.color); });
}

glm::dvec3 transmissionAt(const TransferFunction& transfer, double value) {
  if (transfer.transmission.empty()) return glm::dvec3(0.0);
  return interpolate(transfer.transmission, value,
                     [](const TransferFunction::ColorPoint& p) { return glm::dvec3(p.color); });
}

Grid::Grid(const Volume& volume) : voxels_(decode(*volume.data)), size_(volume.data->size), transfer_(volume.transfer) {
  const glm::dmat4 worldFromIndex = glm::dmat4(volume.worldFromObject) * glm::dmat4(volume.data->objectFromIndex);
  indexFromWorld_ = glm::inverse(worldFromIndex);
  smallestEdge_ = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    smallestEdge_ = std::min(smallestEdge_, glm::length(glm::dvec3(worldFromIndex[axis])));
  }
  for (double v : voxels_) largestValue_ = std::max(largestValue_, std::abs(v));
}

Interval Grid::inside(const Ray& ray) const {
  const glm::dvec3 origin = indexOf(ray.origin);
  const glm::dvec3 direction = glm::dmat3(indexFromWorld_) * ray.direction;
  Interval result{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = -0.5 - origin[axis];
    const double high = size_[axis] - 0.5 - origin[axis];
    if (direction[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return {0.0, 0.0};
      continue;
    }
    const double t0 = low / direction[axis];
    const double t1 = high / direction[axis];
    result.begin = std::max(result.begin, std::min(t0, t1));
    result.end = std::min(result.end, std::max(t0, t1));
  }
  return result;
}

double Grid::value(const glm::dvec3& pointWorld) const { return valueAtIndex(indexOf(pointWorld)); }

glm::dvec3 Grid::normal(const glm::dvec3& pointWorld) const {
  const glm::dvec3 index = indexOf(pointWorld);
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 offset(0.0);
    offset[axis] = 1.0;
    gradient[axis] = 0.5 * (valueAtIndex(index + offset) - valueAtIndex(index - offset));
  }
  if (glm::length(gradient) <= kFlatGradient * largestValue_) return glm::dvec3(0.0);
  return glm::normalize(glm::transpose(glm::dmat3(indexFromWorld_)) * gradient);
}

double Grid::extinction(const glm::dvec3& pointWorld) const {
  const double opacity = std::min(opacityAt(transfer_, value(pointWorld)), kLargestOpacity);
  return -std::log(1.0 - opacity) / static_cast<double>(transfer_.unitDistance);
}

glm::dvec3 Grid::color(const glm::dvec3& pointWorld) const { return colorAt(transfer_, value(pointWorld)); }

glm::dvec3 Grid::transmission(const glm::dvec3& pointWorld) const {
  return transmissionAt(transfer_, value(pointWorld));
}

double Grid::voxel(int x, int y, int z) const {
  const auto columns = static_cast<std::size_t>(size_.x);
  const auto rows = static_cast<std::size_t>(size_.y);
  return voxels_[(static_cast<std::size_t>(z) * rows + static_cast<std::size_t>(y)) * columns +
                 static_cast<std::size_t>(x)];
}

double Grid::valueAtIndex(const glm::dvec3& index) const {
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(size_ - 1));
  const glm::ivec3 a(p);
  const glm::ivec3 b = glm::min(a + 1, size_ - 1);
  const glm::dvec3 f = p - glm::dvec3(a);
  const double y0z0 = mix(voxel(a.x, a.y, a.z), voxel(b.x, a.y, a.z), f.x);
  const double y1z0 = mix(voxel(a.x, b.y, a.z), voxel(b.x, b.y, a.z), f.x);
  const double y0z1 = mix(voxel(a.x, a.y, b.z), voxel(b.x, a.y, b.z), f.x);
  const double y1z1 = mix(voxel(a.x, b.y, b.z), voxel(b.x, b.y, b.z), f.x);
  return mix(mix(y0z0, y1z0, f.y), mix(y0z1, y1z1, f.y), f.z);
}

glm::dvec3 Grid::indexOf(const glm::dvec3& pointWorld) const {
  return glm::dvec3(indexFromWorld_ * glm::dvec4(pointWorld, 1.0));
}

}  // namespace cdsm::reference
