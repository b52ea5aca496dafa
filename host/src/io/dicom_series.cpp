// SPDX-License-Identifier: Apache-2.0
// From slices to a volume; see dicom_series.hpp.
#include "io/dicom_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <new>
#include <set>

#include <cdsm/error.hpp>

#include "io/dicom_slice.hpp"
#include "io/input_file.hpp"
#include "scene/range.hpp"

namespace cdsm::io {

namespace {

namespace fs = std::filesystem;
using scene::formatNumber;

/// Of the greatest difference between distances of neighbours, and of a shift of slices against their normal, in parts
/// of the distance: scanners round positions, a missing slice doubles a distance, a tilted gantry leans by degrees.
constexpr double kUneven = 0.05;
constexpr double kTilt = 0.005;
constexpr double kSameDirection = 1e-3;

/// A file of DICOM has "DICM" behind 128 bytes of anything; .dcm files without are an error of theirs.
bool isSlice(const fs::directory_entry& entry) {
  constexpr std::size_t kPreamble = 128;
  if (!entry.is_regular_file() || entry.path().filename() == "DICOMDIR") return false;
  if (hasEnding(entry.path().string(), ".dcm")) return true;
  return entry.file_size() > kPreamble + 4 &&
         readText(entry.path().string(), kPreamble + 4).substr(kPreamble) == "DICM";
}

std::vector<DicomSlice> readHeaders(const std::string& folder) {
  std::set<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (isSlice(entry)) paths.insert(entry.path().string());
  if (paths.size() < 2)
    throw Error(Location{folder}, "is a folder with " + std::to_string(paths.size()) +
                                      " DICOM files; a volume is a file, or a folder with at least two slices");
  std::vector<DicomSlice> slices;
  for (const std::string& path : paths) slices.push_back(readDicomHeader(path));
  return slices;
}

glm::dvec3 normalOf(const DicomSlice& slice) { return glm::cross(slice.alongRow, slice.alongColumn); }

void checkAlike(const DicomSlice& first, const DicomSlice& other) {
  const auto fail = [&](const std::string& what) {
    throw Error(Location{other.path}, what + " than " + fs::path(first.path).filename().string() +
                                          "; a folder must hold the slices of one series");
  };
  if (other.series != first.series) fail("is of another series");
  if (other.width != first.width || other.height != first.height) fail("has another size");
  if (glm::distance(other.alongRow, first.alongRow) > kSameDirection ||
      glm::distance(other.alongColumn, first.alongColumn) > kSameDirection)
    fail("has another orientation");
  if (glm::distance(other.spacing, first.spacing) > kSameDirection * first.spacing.x) fail("has another PixelSpacing");
}

/// Ascending along the normal of the first, which makes the axes right-handed.
void sortSlices(std::vector<DicomSlice>& slices) {
  for (const DicomSlice& slice : slices) checkAlike(slices.front(), slice);
  const glm::dvec3 normal = normalOf(slices.front());
  std::sort(slices.begin(), slices.end(), [&](const DicomSlice& a, const DicomSlice& b) {
    return glm::dot(a.position, normal) < glm::dot(b.position, normal);
  });
}

/// From slice to slice, along their normal.
double checkedDistance(const std::vector<DicomSlice>& slices) {
  const glm::dvec3 normal = normalOf(slices.front());
  std::vector<double> distances;
  for (std::size_t i = 1; i < slices.size(); ++i)
    distances.push_back(glm::dot(slices[i].position - slices[i - 1].position, normal));
  std::vector<double> sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::abs(distances[i] - usual) <= kUneven * usual && distances[i] > 0.0) continue;
    throw Error(Location{slices[i + 1].path},
                "lies " + formatNumber(distances[i]) + " mm from its neighbour " +
                    fs::path(slices[i].path).filename().string() + ", the others lie " + formatNumber(usual) +
                    " mm apart; slices must be evenly spaced, none missing and none twice there");
  }
  return distances.empty() ? 0.0
                           : glm::dot(slices.back().position - slices.front().position, normal) /
                                 static_cast<double>(distances.size());
}

void checkStraight(const std::vector<DicomSlice>& slices) {
  const glm::dvec3 normal = normalOf(slices.front());
  const glm::dvec3 way = slices.back().position - slices.front().position;
  const double along = glm::dot(way, normal);
  const double aside = glm::length(way - along * normal);
  if (aside > kTilt * along)
    throw Error(Location{slices.back().path}, "is shifted by " + formatNumber(aside) + " mm against the first slice " +
                                                  formatNumber(along) +
                                                  " mm away (gantry tilt); resample the series to a straight grid");
}

template <typename T>
bool allFit(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float value) {
    return value >= std::numeric_limits<T>::lowest() && value <= std::numeric_limits<T>::max() &&
           value == std::floor(value);
  });
}

template <typename T>
std::vector<std::byte> bytesOf(const std::vector<float>& values) {
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const T value = static_cast<T>(values[i]);
    std::memcpy(bytes.data() + i * sizeof(T), &value, sizeof(T));
  }
  return bytes;
}

/// In the smallest type that holds all values.
void storeValues(const std::vector<float>& values, StoredVolume& stored) {
  const auto store = [&](StoredType type, std::vector<std::byte> bytes) {
    stored.type = type;
    stored.bytes = std::move(bytes);
  };
  if (allFit<std::uint8_t>(values)) return store(StoredType::UInt8, bytesOf<std::uint8_t>(values));
  if (allFit<std::int8_t>(values)) return store(StoredType::Int8, bytesOf<std::int8_t>(values));
  if (allFit<std::int16_t>(values)) return store(StoredType::Int16, bytesOf<std::int16_t>(values));
  if (allFit<std::uint16_t>(values)) return store(StoredType::UInt16, bytesOf<std::uint16_t>(values));
  store(StoredType::Float32, bytesOf<float>(values));
}

std::vector<float> readValues(const std::vector<DicomSlice>& slices) {
  std::vector<float> values;
  for (const DicomSlice& slice : slices) {
    const std::vector<float> one = readDicomValues(slice);
    values.insert(values.end(), one.begin(), one.end());
  }
  return values;
}

}  // namespace

StoredVolume readDicomSeries(const std::string& folder) {
  std::vector<DicomSlice> slices = readHeaders(folder);
  sortSlices(slices);
  const double distance = checkedDistance(slices);
  checkStraight(slices);
  const DicomSlice& first = slices.front();
  StoredVolume stored;
  stored.bigEndian = hostIsBigEndian();
  stored.size = {first.width, first.height, slices.size()};
  stored.objectFromIndex[0] = glm::dvec4(first.alongRow * first.spacing.x, 0.0);
  stored.objectFromIndex[1] = glm::dvec4(first.alongColumn * first.spacing.y, 0.0);
  stored.objectFromIndex[2] = glm::dvec4(normalOf(first) * distance, 0.0);
  stored.objectFromIndex[3] = glm::dvec4(first.position, 1.0);
  try {
    storeValues(readValues(slices), stored);
  } catch (const std::bad_alloc&) {
    throw Error(Location{folder}, "there is no memory for its " + std::to_string(slices.size()) + " slices");
  }
  return stored;
}

}  // namespace cdsm::io
