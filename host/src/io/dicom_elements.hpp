// SPDX-License-Identifier: Apache-2.0
// In: a DICOM file. Out: its outermost elements, after all lengths, nested ones too, were found to fit the file. GDCM
// ends the process where they do not.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace cdsm::io {

/// Group in the upper, element in the lower 16 bits.
using DicomTag = std::uint32_t;

class DicomElements {
 public:
  /// Little endian files that begin with a preamble and "DICM". Throws Error for others and for damaged ones.
  explicit DicomElements(const std::string& path);
  DicomElements(const DicomElements&) = delete;
  DicomElements& operator=(const DicomElements&) = delete;

  const std::string& path() const { return path_; }
  bool has(DicomTag tag) const { return elements_.count(tag) > 0; }
  /// The element's text without the blanks that fill it up; "" when there is none.
  std::string text(DicomTag tag) const;
  /// The element's 16 bit integer; throws Error when there is none.
  std::uint32_t integer(DicomTag tag, const char* name) const;

 private:
  std::string path_;
  std::string bytes_;
  std::map<DicomTag, std::string_view> elements_;
};

}  // namespace cdsm::io
