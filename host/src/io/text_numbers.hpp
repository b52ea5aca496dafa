// SPDX-License-Identifier: Apache-2.0
// Numbers in texts, read alike in every locale; words and lines; and how these are quoted in messages.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace cdsm::io {

/// The number that the whole text is (a leading + is allowed), or nothing: also when it does not fit T.
template <typename T>
std::optional<T> parseNumber(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Without spaces, tabs and line ends at both ends.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

/// Takes the first word (ended by white space) off the text; empty when none is left.
inline std::string_view takeWord(std::string_view& text) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return text = {};
  const std::size_t end = std::min(text.find_first_of(kBlank, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// Takes the first line off the text, without its line end (LF or CR LF).
inline std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// For messages: the first line that is not blank, at most `most` bytes, with ? for control characters.
inline std::string printable(std::string_view text, std::size_t most = 200) {
  std::string line;
  while (line.empty() && !text.empty()) line = trimmed(takeLine(text));
  line.resize(std::min(line.size(), most));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return line;
}

/// For messages: a word from a file in quotation marks.
inline std::string quoted(std::string_view word) { return "\"" + printable(word, 40) + "\""; }

/// Of ASCII letters.
inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// All words of a text.
inline std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> list;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) list.push_back(word);
  return list;
}

}  // namespace cdsm::io
