// SPDX-License-Identifier: Apache-2.0
// XML through pugixml, with the line of each element for messages.
#pragma once

#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace cdsm::io {

class XmlText {
 public:
  /// `path` is for messages; `text` must outlive this. Throws Error with a line for what is not well-formed.
  XmlText(std::string path, std::string_view text);

  /// The outermost element.
  pugi::xml_node root() const { return document_.document_element(); }

  /// The attribute's number; throws Error at the element when there is none.
  double number(pugi::xml_node element, const char* attribute) const;

  [[noreturn]] void fail(pugi::xml_node element, const std::string& message) const;

 private:
  [[noreturn]] void failAt(std::ptrdiff_t offset, const std::string& message) const;

  std::string path_;
  std::string_view text_;
  pugi::xml_document document_;
};

}  // namespace cdsm::io
