// SPDX-License-Identifier: Apache-2.0
// Reads typed values out of a TOML table; whatever is wrong becomes an Error at the place of the key or value.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>
#include <glm/glm.hpp>

#include <cdsm/error.hpp>

#include "scene/range.hpp"

namespace cdsm::io {

/// How the place of a value that came from the command line begins; such a place has no line and column.
inline constexpr std::string_view kOverridePrefix = "--set ";
/// The same for a value that an [[animate]] table gave; SceneReader puts the table's place there.
inline constexpr std::string_view kAnimatePrefix = "[[animate]] ";

Location locationOf(const toml::source_region& source);
[[noreturn]] void failAt(const toml::source_region& source, const std::string& message);

/// Values of a key that stands for one of several names.
struct Choices {
  std::vector<std::string> supported;
  std::vector<std::string> later;  ///< names of the contract that this version refuses
};

/// One table of the file. The table must outlive the reader. Getters give the fallback for a missing key and throw
/// Error for a value of the wrong type, length or range.
class TableReader {
 public:
  /// `title` is how messages call the table, such as "[camera]". Throws for a key that is not in `keys`.
  TableReader(const toml::table& table, std::string title, std::vector<std::string> keys);

  bool has(std::string_view key) const { return table_.contains(key); }
  void require(std::string_view key) const;

  std::string text(std::string_view key, const std::string& fallback) const;
  bool flag(std::string_view key, bool fallback) const;
  int integer(std::string_view key, int fallback, const scene::Range& range) const;
  /// The same, or a word that stands for `named`.
  int integerOr(std::string_view key, int fallback, const scene::Range& range, const std::string& word,
                int named) const;
  float number(std::string_view key, float fallback, const scene::Range& range) const;
  glm::vec3 vector(std::string_view key, const glm::vec3& fallback, const scene::Range& range) const;
  std::string choice(std::string_view key, const std::string& fallback, const Choices& choices) const;

  /// An array of exactly `count` numbers; the key must be there.
  std::vector<float> numbers(std::string_view key, std::size_t count, const scene::Range& range) const;

  /// An array of rows of exactly `count` numbers each, the first of any size and the others in `range`; the first ones
  /// must ascend, equal ones are allowed. At least one row; the key must be there.
  std::vector<std::vector<float>> points(std::string_view key, std::size_t count, const scene::Range& range) const;

  /// Throws "not supported yet" when the key is there, unless it has its default: then nothing depends on it.
  void refuseUnlessEmpty(std::string_view key) const;

  /// Throws at the key's value, or at the table when the key is missing.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;
  /// Runs `action`; an Error without a place gets that of an animated value of the table, without which it would have
  /// come in every frame, else that of the key's value, or of the table when the key is missing.
  void locate(std::string_view key, const std::function<void()>& action) const;

  const toml::source_region& placeOf(std::string_view key) const;
  /// Of any animated value, or nothing.
  const toml::source_region* animatedPlace() const;
  const toml::table& table() const { return table_; }

 private:
  const toml::table& table_;
  std::string title_;
};

}  // namespace cdsm::io
