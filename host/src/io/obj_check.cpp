// SPDX-License-Identifier: Apache-2.0
// OBJ before assimp; see mesh_check.hpp.
#include <array>
#include <cmath>
#include <cstdint>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/mesh_check.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

/// What a face corner "v/vt/vn" counts into.
constexpr std::array<const char*, 3> kKinds = {"vertex", "texture coordinate", "normal"};

class ObjCheck {
 public:
  explicit ObjCheck(const std::string& path) : path_(path) {}

  void line(std::string_view text, int number) {
    lineNumber_ = number;
    const std::string_view keyword = takeWord(text);
    if (keyword == "v")
      vertex(text, 0, 3);
    else if (keyword == "vt")
      vertex(text, 1, 1);
    else if (keyword == "vn")
      vertex(text, 2, 3);
    else if (keyword == "f")
      face(text);
  }

  /// A face may name vertices that come later, so the largest indices are checked at the end.
  std::uint64_t finish() const {
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
      if (largest_[kind] > counts_[kind])
        throw Error(Location{path_, largestLine_[kind], 1}, "a face uses " + std::string(kKinds[kind]) + " " +
                                                                std::to_string(largest_[kind]) + ", but the file has " +
                                                                std::to_string(counts_[kind]));
    return faces_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Error(Location{path_, lineNumber_, 1}, message); }

  void vertex(std::string_view text, std::size_t kind, int needed) {
    for (int i = 0; i < needed; ++i) {
      const std::string_view word = takeWord(text);
      const std::optional<double> value = parseNumber<double>(word);
      if (!value || !std::isfinite(static_cast<float>(*value)))
        fail(quoted(word) + " is not a finite number; a " + kKinds[kind] + " has " + std::to_string(needed));
    }
    ++counts_[kind];
  }

  void face(std::string_view text) {
    int corners = 0;
    for (std::string_view corner = takeWord(text); !corner.empty(); corner = takeWord(text)) {
      const std::string_view whole = corner;
      if (++corners == 3) ++faces_;  // fewer make a point or a line
      for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        const std::size_t slash = corner.find('/');
        const std::string_view index = corner.substr(0, slash);
        if (kind == 0 || !index.empty()) checkIndex(index, kind, whole);
        if (slash == std::string_view::npos) break;
        corner.remove_prefix(slash + 1);
      }
    }
  }

  void checkIndex(std::string_view text, std::size_t kind, std::string_view corner) {
    const std::optional<std::int64_t> index = parseNumber<std::int64_t>(text);
    if (!index || *index == 0)
      fail(quoted(corner) + " is not a face corner; indices count from 1, or from -1 backwards");
    if (*index < 0 && *index < -counts_[kind])
      fail("a face uses " + std::string(kKinds[kind]) + " " + std::to_string(*index) + ", but there are " +
           std::to_string(counts_[kind]) + " before it");
    if (*index <= largest_[kind]) return;
    largest_[kind] = *index;
    largestLine_[kind] = lineNumber_;
  }

  std::string path_;
  int lineNumber_ = 0;
  std::uint64_t faces_ = 0;
  std::array<std::int64_t, 3> counts_{};
  std::array<std::int64_t, 3> largest_{};
  std::array<int, 3> largestLine_{};
};

}  // namespace

std::uint64_t checkObj(const std::string& path) {
  const std::string text = readText(path);
  ObjCheck check(path);
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const int first = number;
    std::string joined(takeLine(rest));
    for (; !joined.empty() && joined.back() == '\\' && !rest.empty(); ++number) {
      joined.back() = ' ';
      joined += takeLine(rest);
    }
    check.line(std::string_view(joined).substr(0, joined.find('#')), first);
  }
  return check.finish();
}

}  // namespace cdsm::io
