// SPDX-License-Identifier: Apache-2.0
// Ranges in words.
#include "scene/range.hpp"

#include <cstdio>

#include <cdsm/error.hpp>

namespace cdsm::scene {

std::string formatNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

std::string Range::text() const {
  std::string words;
  if (low <= -FLT_MAX) {
    words = "a finite number";
  } else if (high >= FLT_MAX) {
    words = (lowOpen ? "above " : "at least ") + formatNumber(low);
  } else {
    words = std::string("in ") + (lowOpen ? "(" : "[") + formatNumber(low) + ", " + formatNumber(high) +
            (highOpen ? ")" : "]");
  }
  return *unit ? words + " " + unit : words;
}

void requireRange(double value, const Range& range, const std::string& what) {
  if (!range.contains(value)) throw Error(what + " is " + formatNumber(value) + ", must be " + range.text());
}

}  // namespace cdsm::scene
