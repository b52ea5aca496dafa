// SPDX-License-Identifier: Apache-2.0
// The structure of DICOM files [DICOM PS3.5, 7; PS3.10, 7]; see dicom_elements.hpp.
#include "io/dicom_elements.hpp"

#include <cstring>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"

namespace cdsm::io {

namespace {

constexpr std::size_t kPreamble = 128;
constexpr std::uint32_t kUndefined = 0xffffffff;
constexpr DicomTag kItem = 0xfffee000, kItemEnd = 0xfffee00d, kSequenceEnd = 0xfffee0dd;
constexpr DicomTag kSyntax = 0x00020010, kPixels = 0x7fe00010;
/// GDCM ends the process where such pixels are damaged, and nothing else in the file tells.
constexpr std::string_view kRunLengths = "1.2.840.10008.1.2.5";
constexpr int kMaxDepth = 16;

/// Types with a length of 32 bits, behind two bytes of nothing.
constexpr std::string_view kLongTypes = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
/// Those that may be items up to an end mark.
constexpr std::string_view kItemTypes = "OB OW SQ UN";
constexpr std::string_view kShortTypes = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";

bool isOf(std::string_view types, std::string_view type) {
  const std::size_t at = types.find(type);
  return at != std::string_view::npos && at % 3 == 0;
}

struct Element {
  DicomTag tag = 0;
  std::uint32_t length = 0;
  bool sequence = false;  ///< its value is items
};

/// Goes through a file from front to end.
class Walker {
 public:
  Walker(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  std::size_t at = 0;
  bool implicit = false;  ///< elements do not say their types

  [[noreturn]] void fail() const {
    throw Error(Location{path_},
                "is no sound DICOM file at byte " + std::to_string(at) + "; is it cut short or damaged?");
  }

  std::uint32_t integer(std::size_t size) {
    const std::string_view bytes = take(size);
    std::uint32_t value = 0;
    for (std::size_t i = size; i > 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i - 1]);
    at += size;
    return value;
  }

  DicomTag tag() {
    const std::uint32_t group = integer(2);
    return group << 16 | integer(2);
  }

  /// The next bytes, without going on.
  std::string_view take(std::size_t count) const {
    if (count > bytes_.size() - at) fail();
    return bytes_.substr(at, count);
  }

  void skip(std::uint32_t count) { at += take(count).size(); }

  Element element() {
    Element element;
    element.tag = tag();
    if (implicit || element.tag >> 16 == 0xfffe) {
      element.length = integer(4);
      element.sequence = element.length == kUndefined;
    } else {
      const std::string_view type = take(2);
      const bool isLong = isOf(kLongTypes, type);
      if (!isLong && !isOf(kShortTypes, type)) fail();
      at += 2;
      if (isLong) skip(2);
      element.length = integer(isLong ? 4 : 2);
      element.sequence = type == "SQ" || (isLong && element.length == kUndefined);
      if (element.length == kUndefined && !isOf(kItemTypes, type)) fail();
    }
    if (element.length != kUndefined && (element.length % 2 != 0 || element.length > bytes_.size() - at)) fail();
    return element;
  }

  /// What follows the head of an element. Of pixels, items are bytes; of sequences, elements.
  void skipValue(const Element& element, int depth) {
    if (depth > kMaxDepth) fail();
    if (!element.sequence) return skip(element.length);
    const std::size_t end = element.length == kUndefined ? bytes_.size() : at + element.length;
    while (at < end) {
      const Element item = this->element();
      if (item.tag == kSequenceEnd && element.length == kUndefined) return;
      if (item.tag != kItem) fail();
      if (element.tag == kPixels)
        skip(item.length);
      else
        skipItem(item, depth);
    }
    if (at != end || element.length == kUndefined) fail();
  }

 private:
  void skipItem(const Element& item, int depth) {
    const std::size_t end = item.length == kUndefined ? bytes_.size() : at + item.length;
    while (at < end) {
      const Element inner = element();
      if (inner.tag == kItemEnd && item.length == kUndefined) return;
      if (inner.tag >> 16 == 0xfffe) fail();
      skipValue(inner, depth + 1);
    }
    if (at != end || item.length == kUndefined) fail();
  }

  const std::string& path_;
  std::string_view bytes_;
};

std::string trimmedText(std::string_view text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace

DicomElements::DicomElements(const std::string& path) : path_(path), bytes_(readText(path)) {
  if (bytes_.size() < kPreamble + 4 || bytes_.compare(kPreamble, 4, "DICM") != 0)
    throw Error(Location{path}, "is not a DICOM file (\"DICM\" must stand at byte 128)");
  Walker walker(path_, bytes_);
  walker.at = kPreamble + 4;
  bool inHeader = true;
  for (DicomTag last = 0; walker.at < bytes_.size();) {
    const std::string_view group = walker.take(2);
    if (inHeader && group != std::string_view("\2\0", 2)) {
      inHeader = false;
      const std::string syntax = text(kSyntax);
      walker.implicit = syntax == "1.2.840.10008.1.2";
      if (syntax.empty() || syntax == "1.2.840.10008.1.2.2" || syntax == "1.2.840.10008.1.2.1.99" ||
          syntax == kRunLengths)
        throw Error(Location{path},
                    "has the transfer syntax \"" + syntax +
                        "\", must be little endian, neither deflated as a whole nor of run lengths (gdcmconv --raw)");
    }
    const Element element = walker.element();
    if (element.tag <= last || (!inHeader && element.tag >> 16 == 2)) walker.fail();
    last = element.tag;
    const std::size_t begin = walker.at;
    walker.skipValue(element, 0);
    elements_[element.tag] = std::string_view(bytes_).substr(begin, walker.at - begin);
  }
}

std::string DicomElements::text(DicomTag tag) const {
  const auto at = elements_.find(tag);
  return at == elements_.end() ? std::string() : trimmedText(at->second);
}

std::uint32_t DicomElements::integer(DicomTag tag, const char* name) const {
  const auto at = elements_.find(tag);
  if (at == elements_.end() || at->second.size() != 2)
    throw Error(Location{path_}, "has no " + std::string(name) + ", must have one");
  return static_cast<unsigned char>(at->second[0]) |
         static_cast<std::uint32_t>(static_cast<unsigned char>(at->second[1])) << 8;
}

}  // namespace cdsm::io
