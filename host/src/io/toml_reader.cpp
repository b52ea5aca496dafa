// SPDX-License-Identifier: Apache-2.0
// Typed values out of TOML tables.
#include "io/toml_reader.hpp"

#include <algorithm>
#include <utility>

#include "io/spelling.hpp"

namespace cdsm::io {
namespace {

using scene::Range;

bool startsWith(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

std::string typeName(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array of " + std::to_string(node.as_array()->size());
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number with a fraction";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

[[noreturn]] void failType(const toml::node& node, const std::string& what, const std::string& right) {
  failAt(node.source(), what + " is " + typeName(node) + ", must be " + right);
}

void requireRangeAt(const toml::node& node, double value, const Range& range, const std::string& what) {
  if (!range.contains(value)) {
    failAt(node.source(), what + " is " + scene::formatNumber(value) + ", must be " + range.text());
  }
}

float numberOf(const toml::node& node, const std::string& what, const Range& range) {
  if (!node.is_number()) failType(node, what, range.text());
  const double value = *node.value<double>();
  requireRangeAt(node, value, range, what);
  return static_cast<float>(value);
}

std::vector<float> numbersOf(const toml::node& node, std::size_t count, const std::string& what, const Range& range) {
  const toml::array* array = node.as_array();
  if (!array || array->size() != count) failType(node, what, "an array of " + std::to_string(count) + " numbers");
  std::vector<float> values;
  for (const toml::node& element : *array) values.push_back(numberOf(element, what, range));
  return values;
}

/// A row [value, ...] of a transfer function.
std::vector<float> pointOf(const toml::node& node, std::size_t count, const std::string& what, const Range& range) {
  std::vector<float> values = numbersOf(node, count, what, scene::kAnyNumber);
  for (std::size_t i = 1; i < count; ++i) requireRangeAt((*node.as_array())[i], values[i], range, what);
  return values;
}

}  // namespace

Location locationOf(const toml::source_region& source) {
  const std::string file = source.path ? *source.path : std::string();
  if (startsWith(file, kOverridePrefix) || startsWith(file, kAnimatePrefix)) return {file, 0, 0};
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

void failAt(const toml::source_region& source, const std::string& message) { throw Error(locationOf(source), message); }

TableReader::TableReader(const toml::table& table, std::string title, std::vector<std::string> keys)
    : table_(table), title_(std::move(title)) {
  for (const auto& [key, value] : table_) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    failAt(key.source(), "unknown key '" + std::string(key.str()) + "' in " + title_ + suggestion(key.str(), keys));
  }
}

const toml::source_region& TableReader::placeOf(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node ? node->source() : table_.source();
}

const toml::source_region* TableReader::animatedPlace() const {
  for (const auto& [key, value] : table_) {
    const auto& file = value.source().path;
    if (file && startsWith(*file, kAnimatePrefix)) return &value.source();
  }
  return nullptr;
}

void TableReader::fail(std::string_view key, const std::string& message) const { failAt(placeOf(key), message); }

void TableReader::locate(std::string_view key, const std::function<void()>& action) const {
  try {
    action();
  } catch (const Error& error) {
    if (error.where()) throw;
    const toml::source_region* animated = animatedPlace();
    failAt(animated ? *animated : placeOf(key), error.message());
  }
}

void TableReader::require(std::string_view key) const {
  if (!has(key)) failAt(table_.source(), title_ + " has no '" + std::string(key) + "', must have one");
}

std::string TableReader::text(std::string_view key, const std::string& fallback) const {
  const toml::node* node = table_.get(key);
  if (!node) return fallback;
  if (!node->is_string()) failType(*node, std::string(key), "a string in quotes");
  return *node->value<std::string>();
}

bool TableReader::flag(std::string_view key, bool fallback) const {
  const toml::node* node = table_.get(key);
  if (!node) return fallback;
  if (!node->is_boolean()) failType(*node, std::string(key), "true or false");
  return *node->value<bool>();
}

int TableReader::integer(std::string_view key, int fallback, const Range& range) const {
  const toml::node* node = table_.get(key);
  if (!node) return fallback;
  if (!node->is_integer()) failType(*node, std::string(key), "an integer " + range.text());
  const auto value = *node->value<std::int64_t>();
  requireRangeAt(*node, static_cast<double>(value), range, std::string(key));
  return static_cast<int>(value);
}

int TableReader::integerOr(std::string_view key, int fallback, const Range& range, const std::string& word,
                           int named) const {
  const toml::node* node = table_.get(key);
  if (node && node->is_string() && *node->value<std::string>() == word) return named;
  if (node && !node->is_integer())
    failAt(node->source(), std::string(key) + " must be \"" + word + "\" or an integer " + range.text());
  return integer(key, fallback, range);
}

float TableReader::number(std::string_view key, float fallback, const Range& range) const {
  const toml::node* node = table_.get(key);
  return node ? numberOf(*node, std::string(key), range) : fallback;
}

glm::vec3 TableReader::vector(std::string_view key, const glm::vec3& fallback, const Range& range) const {
  if (!has(key)) return fallback;
  const std::vector<float> values = numbers(key, 3, range);
  return {values[0], values[1], values[2]};
}

std::vector<float> TableReader::numbers(std::string_view key, std::size_t count, const Range& range) const {
  require(key);
  return numbersOf(*table_.get(key), count, std::string(key), range);
}

std::vector<std::vector<float>> TableReader::points(std::string_view key, std::size_t count, const Range& range) const {
  require(key);
  const std::string what(key);
  const toml::array* rows = table_.get(key)->as_array();
  const std::string right = "an array of at least one point of " + std::to_string(count) + " numbers";
  if (!rows || rows->empty()) failType(*table_.get(key), what, right);
  std::vector<std::vector<float>> points;
  for (const toml::node& row : *rows) {
    points.push_back(pointOf(row, count, what, range));
    if (points.size() < 2 || points.back()[0] >= points[points.size() - 2][0]) continue;
    failAt(row.source(), what + " has the value " + scene::formatNumber(points.back()[0]) + " after " +
                             scene::formatNumber(points[points.size() - 2][0]) +
                             ", must be ascending (equal values make a step)");
  }
  return points;
}

std::string TableReader::choice(std::string_view key, const std::string& fallback, const Choices& choices) const {
  const std::string value = text(key, fallback);
  const auto& [supported, later] = choices;
  if (std::find(supported.begin(), supported.end(), value) != supported.end()) return value;
  if (std::find(later.begin(), later.end(), value) != later.end()) {
    fail(key, std::string(key) + " '" + value + "' is not supported yet, must be one of: " + joinNames(supported));
  }
  fail(key, "unknown " + std::string(key) + " '" + value + "'" + suggestion(value, supported));
}

void TableReader::refuseUnlessEmpty(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (!node || (node->is_array() && node->as_array()->empty())) return;
  fail(key, std::string(key) + " other than [] is not supported yet");
}

}  // namespace cdsm::io
