// SPDX-License-Identifier: Apache-2.0
#include "io/frame_numbers.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include <cdsm/error.hpp>

#include "io/text_numbers.hpp"

namespace cdsm::io {
namespace {

constexpr int kDefaultDigits = 4;

/// Digits alone: no sign, no space.
std::optional<int> frameOf(std::string_view text) {
  if (text.empty() || !std::isdigit(static_cast<unsigned char>(text[0]))) return std::nullopt;
  const std::optional<int> frame = parseNumber<int>(text);
  return frame && *frame <= kLastFrame ? frame : std::nullopt;
}

/// The least number of digits of a field that begins at the text's %, or nothing; `text` is left behind the field.
std::optional<int> takeField(std::string_view& text) {
  int digits = 1;
  std::size_t end = 1;
  if (text.size() > 3 && text[1] == '0' && text[2] >= '1' && text[2] <= '9') {
    digits = text[2] - '0';
    end = 3;
  }
  if (end >= text.size() || text[end] != 'd') return std::nullopt;
  text.remove_prefix(end + 1);
  return digits;
}

}  // namespace

FrameRange parseFrames(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::optional<int> first = frameOf(std::string_view(text).substr(0, colon));
  const std::optional<int> last =
      colon == std::string::npos ? first : frameOf(std::string_view(text).substr(colon + 1));
  if (!first || !last || *first > *last) {
    throw Error("frames are " + quoted(text) + ", must be FIRST:LAST or one number, ascending, in [0, " +
                std::to_string(kLastFrame) + "]");
  }
  return {*first, *last};
}

FramePattern::FramePattern(const std::string& text) {
  std::string_view left = text;
  while (!left.empty()) {
    std::string& part = isNumbered() ? after_ : before_;
    if (left[0] != '%' || left.substr(0, 2) == "%%") {
      part += left[0];
      left.remove_prefix(left[0] == '%' ? 2 : 1);
      continue;
    }
    const std::optional<int> digits = takeField(left);
    if (!digits || isNumbered()) {
      throw Error("the image's name is " + quoted(text) + ", must have one %d or %04d for the frame's number, and %% " +
                  "for a percent sign");
    }
    digits_ = *digits;
  }
}

FramePattern::FramePattern(const std::string& name, const std::string& ending)
    : before_(name + "_"), after_(ending), digits_(kDefaultDigits) {}

std::string FramePattern::path(int frame) const {
  if (!isNumbered()) return before_;
  const std::string number = std::to_string(frame);
  const int zeros = std::max(digits_ - static_cast<int>(number.size()), 0);
  return before_ + std::string(static_cast<std::size_t>(zeros), '0') + number + after_;
}

}  // namespace cdsm::io
