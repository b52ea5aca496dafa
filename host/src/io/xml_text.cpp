// SPDX-License-Identifier: Apache-2.0
// XML with lines; see xml_text.hpp.
#include "io/xml_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <cdsm/error.hpp>

#include "io/text_numbers.hpp"

namespace cdsm::io {

XmlText::XmlText(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {
  const pugi::xml_parse_result result =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) failAt(result.offset, "is not well-formed XML: " + printable(result.description()));
}

double XmlText::number(pugi::xml_node element, const char* attribute) const {
  const std::string_view text = element.attribute(attribute).value();
  const auto value = parseNumber<double>(trimmed(text));
  if (!value || !std::isfinite(*value))
    fail(element, std::string(attribute) + " is " + quoted(text) + ", must be a finite number");
  return *value;
}

void XmlText::fail(pugi::xml_node element, const std::string& message) const {
  failAt(element.offset_debug(), message);
}

void XmlText::failAt(std::ptrdiff_t offset, const std::string& message) const {
  const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
  throw Error(Location{path_, static_cast<int>(std::count(text_.begin(), end, '\n')) + 1, 1}, message);
}

}  // namespace cdsm::io
