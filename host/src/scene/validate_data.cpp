// SPDX-License-Identifier: Apache-2.0
// Checks of what readers and embedders hand over in bulk: triangles, voxels, spheres, transfer functions.
#include <cmath>
#include <cstdint>
#include <cstring>

#include <cdsm/error.hpp>

#include "scene/range.hpp"
#include "scene/transform.hpp"
#include "scene/validate.hpp"
#include "scene/voxels.hpp"

namespace cdsm::scene {
namespace {

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void requireFinite(const Array<glm::vec3>& vectors, const std::string& what) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (!isFinite(vectors[i])) throw Error(what + " " + std::to_string(i) + " is not finite, must be numbers");
  }
}

/// That an array shows values that can be there.
template <class T>
void requireView(const Array<T>& array, const std::string& what) {
  if (!array.isSomewhere()) throw Error(what + " show memory at null, must point to " + std::to_string(array.size()));
  if (array.stride() != 0 && std::abs(array.stride()) < std::ptrdiff_t(sizeof(T)))
    throw Error(what + " of " + std::to_string(sizeof(T)) + " bytes lie at a stride of " +
                std::to_string(array.stride()) + " bytes, must be at least as many or 0");
}

/// What the device's numbers can hold.
void requireFewer(std::size_t count, std::size_t limit, const std::string& what) {
  if (count < limit) return;
  throw Error(what + " are " + std::to_string(count) + ", must be below " + std::to_string(limit));
}

/// Product of the sides, or 0 when it does not fit.
std::uint64_t voxelCount(const glm::uvec3& size) {
  const std::uint64_t plane = static_cast<std::uint64_t>(size.x) * size.y;
  return size.z != 0 && plane > (UINT64_MAX >> 3) / size.z ? 0 : plane * size.z;
}

/// Number of a float voxel that is NaN or infinite, or of voxels.
std::size_t findNonFinite(const VolumeData& data) {
  const HostVoxels voxels = hostVoxels(data);
  std::size_t number = 0;
  for (std::size_t z = 0; z < data.size.z; ++z)
    for (std::size_t y = 0; y < data.size.y; ++y)
      for (std::size_t x = 0; x < data.size.x; ++x, ++number) {
        float value;
        std::memcpy(&value, voxels.at(x, y, z), sizeof value);
        if (!std::isfinite(value)) return number;
      }
  return number;
}

/// That voxels are given in one way, and as many as the size says.
void requireVoxels(const VolumeData& data, std::uint64_t bytes, const std::string& sides, const std::string& what) {
  const int places = !data.voxels.empty() + (data.view.data != nullptr) + (data.view.deviceMemory != nullptr);
  if (places > 1) throw Error(what + " has voxels and a view, or two views of them, must have one");
  if (data.view.data || data.view.deviceMemory) return;
  if (data.voxels.size() != bytes) {
    throw Error(what + " has " + std::to_string(data.voxels.size()) + " bytes for " + sides + " voxels, must be " +
                std::to_string(bytes));
  }
}

template <typename Point>
void requireAscending(const std::vector<Point>& points, const std::string& what) {
  if (points.empty()) throw Error(what + " has no points, must have at least one");
  for (std::size_t i = 0; i < points.size(); ++i) {
    requireRange(points[i].value, kAnyNumber, what + ": value " + std::to_string(i));
    if (i > 0 && points[i].value < points[i - 1].value) {
      throw Error(what + ": value " + formatNumber(points[i].value) + " follows " + formatNumber(points[i - 1].value) +
                  ", must be ascending (equal values make a step)");
    }
  }
}

}  // namespace

void validateMeshData(const MeshData& data, const std::string& what) {
  if (data.triangles.empty()) throw Error(what + " has no triangles, must have at least one");
  requireView(data.positions, what + ": positions");
  requireView(data.normals, what + ": normals");
  requireView(data.triangles, what + ": triangles");
  requireFewer(data.triangles.size(), kMostPrimitives, what + ": triangles");
  requireFewer(data.positions.size(), kMostVertices, what + ": positions");
  requireFinite(data.positions, what + ": position");
  requireFinite(data.normals, what + ": normal");
  if (!data.normals.empty() && data.normals.size() != data.positions.size()) {
    throw Error(what + " has " + std::to_string(data.normals.size()) + " normals for " +
                std::to_string(data.positions.size()) + " positions, must be none or one for each");
  }
  for (std::size_t i = 0; i < data.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t index = data.triangles[i][corner];
      if (index < data.positions.size()) continue;
      throw Error(what + ": triangle " + std::to_string(i) + " has the index " + std::to_string(index) +
                  ", must be below the number of positions, " + std::to_string(data.positions.size()));
    }
  }
}

void validateVolumeData(const VolumeData& data, const std::string& what) {
  const std::uint64_t count = voxelCount(data.size);
  const std::string sides =
      std::to_string(data.size.x) + " x " + std::to_string(data.size.y) + " x " + std::to_string(data.size.z);
  if (count == 0) throw Error(what + " has " + sides + " voxels, must be at least one along each axis and fit memory");
  const std::uint64_t bytes = count * voxelBytes(data.type);
  requireVoxels(data, bytes, sides, what);
  if (!isInvertibleAffine(data.objectFromIndex)) {
    throw Error(what + ": the grid's axes span no space, must be finite and independent");
  }
  if (data.type != VoxelType::Float32 || data.view.deviceMemory) return;
  const std::size_t bad = findNonFinite(data);
  if (bad < count) throw Error(what + ": voxel " + std::to_string(bad) + " is not finite, must be a number");
}

void validateSphereData(const SphereData& data, const std::string& what) {
  const std::string count = std::to_string(data.centers.size());
  if (data.centers.empty()) throw Error(what + " has no spheres, must have at least one");
  if (data.radii.size() != data.centers.size()) {
    throw Error(what + " has " + std::to_string(data.radii.size()) + " radii for " + count +
                " centres, must be one for each");
  }
  if (!data.colors.empty() && data.colors.size() != data.centers.size()) {
    throw Error(what + " has " + std::to_string(data.colors.size()) + " colours for " + count +
                " centres, must be none or one for each");
  }
  requireView(data.centers, what + ": centres");
  requireView(data.radii, what + ": radii");
  requireView(data.colors, what + ": colours");
  requireFewer(data.centers.size(), kMostPrimitives, what + ": centres");
  requireFinite(data.centers, what + ": centre");
  for (std::size_t i = 0; i < data.radii.size(); ++i)
    if (!kPositive.contains(data.radii[i]))
      requireRange(data.radii[i], kPositive, what + ": radius " + std::to_string(i));
  for (std::size_t i = 0; i < data.colors.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      if (!kNotNegative.contains(data.colors[i][channel]))
        requireRange(data.colors[i][channel], kNotNegative, what + ": colour " + std::to_string(i));
}

void validateTransferFunction(const TransferFunction& transfer, const std::string& what) {
  requireAscending(transfer.opacity, what + ": opacity");
  requireAscending(transfer.towardsLights(), what + ": shadow_opacity");
  requireAscending(transfer.color, what + ": color");
  for (const auto& point : transfer.opacity) requireRange(point.opacity, kUnitInterval, what + ": opacity");
  for (const auto& point : transfer.shadowOpacity)
    requireRange(point.opacity, kUnitInterval, what + ": shadow_opacity");
  for (const auto& point : transfer.color) {
    for (int channel = 0; channel < 3; ++channel) requireRange(point.color[channel], kNotNegative, what + ": color");
  }
  if (!transfer.transmission.empty()) requireAscending(transfer.transmission, what + ": transmission");
  for (const auto& point : transfer.transmission)
    for (int channel = 0; channel < 3; ++channel)
      requireRange(point.color[channel], kUnitInterval, what + ": transmission");
  requireRange(transfer.unitDistance, kPositive, what + ": unit_distance");
}

}  // namespace cdsm::scene
