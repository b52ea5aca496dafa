// SPDX-License-Identifier: Apache-2.0
// GDCM; see dicom_slice.hpp.
#include "io/dicom_slice.hpp"

#include <cmath>
#include <cstring>
#include <mutex>
#include <new>
#include <optional>

#include <gdcmImageReader.h>
#include <gdcmTrace.h>

#include <cdsm/error.hpp>

#include "io/dicom_elements.hpp"
#include "io/input_file.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

constexpr DicomTag kSeries = 0x0020000e, kPosition = 0x00200032, kOrientation = 0x00200037;
constexpr DicomTag kSamples = 0x00280002, kColours = 0x00280004, kFrames = 0x00280008, kRows = 0x00280010;
constexpr DicomTag kColumns = 0x00280011, kSpacing = 0x00280030, kAllocated = 0x00280100, kStored = 0x00280101;
constexpr DicomTag kHighBit = 0x00280102, kSigned = 0x00280103, kIntercept = 0x00281052, kSlope = 0x00281053;
constexpr DicomTag kPixels = 0x7fe00010;

/// GDCM prints unless told not to, and has tables of its own that all threads share.
std::unique_lock<std::mutex> lockGdcm() {
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock(mutex);
  gdcm::Trace::DebugOff();
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  return lock;
}

/// Decimal numbers parted by backslashes, exactly `count`; nothing when the element is not there.
std::optional<std::vector<double>> numbersOf(const DicomElements& elements, DicomTag tag, const char* name,
                                             std::size_t count) {
  std::string text = elements.text(tag);
  if (text.empty()) return std::nullopt;
  const std::string whole = text;
  for (char& c : text)
    if (c == '\\') c = ' ';
  std::vector<double> numbers;
  for (const std::string_view word : words(text)) {
    const auto number = parseNumber<double>(word);
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (numbers.size() != count || words(text).size() != count)
    throw Error(Location{elements.path()},
                std::string(name) + " is " + io::quoted(whole) + ", must be " + std::to_string(count) + " numbers");
  return numbers;
}

std::vector<double> needNumbers(const DicomElements& elements, DicomTag tag, const char* name, std::size_t count) {
  const auto numbers = numbersOf(elements, tag, name, count);
  if (!numbers)
    throw Error(Location{elements.path()}, "has no " + std::string(name) + "; a slice of a volume must have one");
  return *numbers;
}

/// What GDCM would end the process for, or what is no value per pixel.
void checkPixels(const DicomElements& elements) {
  const std::string& path = elements.path();
  const std::uint32_t allocated = elements.integer(kAllocated, "BitsAllocated");
  const std::uint32_t stored = elements.integer(kStored, "BitsStored");
  const std::string colours = elements.text(kColours);
  if (elements.integer(kSamples, "SamplesPerPixel") != 1 || (colours != "MONOCHROME1" && colours != "MONOCHROME2"))
    throw Error(Location{path}, "has colours (" + io::quoted(colours) + "); a volume has one value");
  if ((allocated != 8 && allocated != 16 && allocated != 32) || stored < 1 || stored > allocated ||
      elements.integer(kHighBit, "HighBit") + 1 != stored || elements.integer(kSigned, "PixelRepresentation") > 1)
    throw Error(Location{path}, "has pixels of " + std::to_string(stored) + " in " + std::to_string(allocated) +
                                    " bits; integers in 8, 16 or 32 bits, in the lowest of them, are read");
  if (!elements.has(kPixels)) throw Error(Location{path}, "has no PixelData; is the file cut short?");
}

void checkDirections(const DicomSlice& slice) {
  constexpr double kRounding = 1e-3;  // of decimal texts
  const double row = glm::length(slice.alongRow), column = glm::length(slice.alongColumn);
  if (std::abs(row - 1.0) > kRounding || std::abs(column - 1.0) > kRounding ||
      std::abs(glm::dot(slice.alongRow, slice.alongColumn)) > kRounding)
    throw Error(Location{slice.path}, "ImageOrientationPatient is no pair of unit vectors at a right angle");
  if (!(slice.spacing.x > 0.0 && slice.spacing.y > 0.0))
    throw Error(Location{slice.path}, "PixelSpacing is not above 0");
  if (slice.width == 0 || slice.height == 0) throw Error(Location{slice.path}, "has no Rows or Columns");
}

DicomSlice sliceOf(const DicomElements& elements) {
  DicomSlice slice;
  slice.path = elements.path();
  slice.series = elements.text(kSeries);
  slice.width = elements.integer(kColumns, "Columns");
  slice.height = elements.integer(kRows, "Rows");
  if (const auto frames = numbersOf(elements, kFrames, "NumberOfFrames", 1); frames && (*frames)[0] != 1.0)
    throw Error(Location{elements.path()}, "has several frames; a series of files with one slice each is read");
  const auto position = needNumbers(elements, kPosition, "ImagePositionPatient", 3);
  const auto axes = needNumbers(elements, kOrientation, "ImageOrientationPatient", 6);
  const auto spacing = needNumbers(elements, kSpacing, "PixelSpacing", 2);
  slice.position = {position[0], position[1], position[2]};
  slice.alongRow = {axes[0], axes[1], axes[2]};
  slice.alongColumn = {axes[3], axes[4], axes[5]};
  slice.spacing = {spacing[1], spacing[0]};  // the file names that of rows, along y, first
  slice.slope = numbersOf(elements, kSlope, "RescaleSlope", 1).value_or(std::vector<double>{1.0})[0];
  slice.intercept = numbersOf(elements, kIntercept, "RescaleIntercept", 1).value_or(std::vector<double>{0.0})[0];
  checkDirections(slice);
  return slice;
}

template <typename T>
void rescale(const std::vector<char>& stored, const DicomSlice& slice, std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    T value;
    std::memcpy(&value, stored.data() + i * sizeof(T), sizeof(T));
    values[i] = static_cast<float>(static_cast<double>(value) * slice.slope + slice.intercept);
  }
}

using Rescale = void (*)(const std::vector<char>&, const DicomSlice&, std::vector<float>&);

Rescale rescaleOf(const std::string& path, const gdcm::PixelFormat& format) {
  switch (format.GetScalarType()) {
    case gdcm::PixelFormat::UINT8:
      return rescale<std::uint8_t>;
    case gdcm::PixelFormat::INT8:
      return rescale<std::int8_t>;
    case gdcm::PixelFormat::UINT16:
      return rescale<std::uint16_t>;
    case gdcm::PixelFormat::INT16:
      return rescale<std::int16_t>;
    case gdcm::PixelFormat::UINT32:
      return rescale<std::uint32_t>;
    case gdcm::PixelFormat::INT32:
      return rescale<std::int32_t>;
    default:
      throw Error(Location{path}, "has pixels of type " + std::string(format.GetScalarTypeAsString()) +
                                      "; integers of 8, 16 and 32 bits are read");
  }
}

std::vector<float> valuesOf(const DicomSlice& slice, const gdcm::Image& image) {
  const std::string& path = slice.path;
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  const Rescale convert = rescaleOf(path, format);
  const std::uint64_t pixels = std::uint64_t{slice.width} * slice.height;
  const std::uint64_t bytes = pixels * format.GetPixelSize();
  if (bytes / kMaxDeflateRatio > inputFileSize(path) || image.GetBufferLength() != bytes)
    throw Error(Location{path}, "holds fewer pixels than its header asks for; is the file cut short?");
  std::vector<char> stored(bytes);
  if (!image.GetBuffer(stored.data()))
    throw Error(Location{path}, "has pixels that GDCM cannot decode (" +
                                    std::string(image.GetTransferSyntax().GetString()) + "); is the file damaged?");
  std::vector<float> values(pixels);
  convert(stored, slice, values);
  return values;
}

}  // namespace

DicomSlice readDicomHeader(const std::string& path) {
  const DicomElements elements(path);
  checkPixels(elements);
  return sliceOf(elements);
}

std::vector<float> readDicomValues(const DicomSlice& slice) {
  const std::unique_lock<std::mutex> lock = lockGdcm();
  try {
    gdcm::ImageReader reader;
    reader.SetFileName(slice.path.c_str());
    if (!reader.Read()) throw Error(Location{slice.path}, "has no image that GDCM can read; is the file damaged?");
    return valuesOf(slice, reader.GetImage());
  } catch (const std::bad_alloc&) {
    throw Error(Location{slice.path}, "there is no memory for its pixels");
  }
}

}  // namespace cdsm::io
