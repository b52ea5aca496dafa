// SPDX-License-Identifier: Apache-2.0
// cdsm::Error: joins place and message to one printable line.
#include <cdsm/error.hpp>

#include <utility>

namespace cdsm {
namespace {

/// Names out of input files may hold line breaks or terminal codes; an error is one line of plain text.
std::string oneLine(std::string text) {
  for (char& c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f) c = ' ';
  }
  return text;
}

std::string withPlace(const Location& where, const std::string& message) {
  std::string place = where.file;
  if (where.line > 0) place += ":" + std::to_string(where.line);
  if (where.line > 0 && where.column > 0) place += ":" + std::to_string(where.column);
  return place.empty() ? message : place + ": " + message;
}

}  // namespace

Error::Error(const std::string& message) : std::runtime_error(oneLine(message)), message_(oneLine(message)) {}

Error::Error(Location where, const std::string& message)
    : std::runtime_error(oneLine(withPlace(where, message))), where_(std::move(where)), message_(oneLine(message)) {}

}  // namespace cdsm
