// SPDX-License-Identifier: Apache-2.0
// Keyframes from TOML, and their values back into it.
#include "io/animation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "io/frame_numbers.hpp"
#include "io/spelling.hpp"
#include "io/toml_reader.hpp"
#include "scene/range.hpp"

namespace cdsm::io {
namespace {

constexpr scene::Range kFrame{0, kLastFrame};
/// Beyond it, doubles are no longer all of the integers; far out of the range of any key.
constexpr double kLargestInteger = 9007199254740992.0;

/// How many numbers a key takes: `count`, or where that is 0 any multiple of `width`.
struct Counts {
  std::size_t count;
  std::size_t width;
};

Counts countsOf(KeyShape shape) {
  switch (shape) {
    case KeyShape::Interval:
      return {2, 0};
    case KeyShape::Vector:
      return {3, 0};
    case KeyShape::Rotation:
      return {4, 0};
    case KeyShape::Matrix:
      return {16, 0};
    case KeyShape::Pairs:
      return {0, 2};
    case KeyShape::Quads:
      return {0, 4};
    default:
      return {1, 0};
  }
}

KeyShape shapeOf(const ScenePath& path, const Location& place) {
  std::vector<std::string> right;
  for (const SceneKey& key : keysOf(path.kind)) {
    const bool hasNumbers = key.shape != KeyShape::Text && key.shape != KeyShape::Flag;
    if (hasNumbers) right.push_back(key.name);
    if (key.name != path.key) continue;
    if (hasNumbers) return key.shape;
    throw Error(place, "'" + path.key + "' is " + (key.shape == KeyShape::Text ? "a text" : "true or false") +
                           ", must be a key with numbers");
  }
  throw Error(place, "unknown key '" + path.key + "' of " + path.kind + suggestion(path.key, right));
}

/// The number of values of each keyframe, from the key's shape, its value in the scene and the first row.
std::size_t valueCount(KeyShape shape, const toml::node* still, std::size_t first) {
  const auto [count, width] = countsOf(shape);
  if (shape == KeyShape::Scale) return first == 3 ? 3 : 1;
  if (count > 0) return count;
  const toml::array* points = still ? still->as_array() : nullptr;
  if (points && !points->empty()) return width * points->size();
  return std::max(width, first / width * width);
}

std::string rightRow(KeyShape shape, std::size_t count) {
  const auto numbers = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " number" : " numbers"); };
  if (shape == KeyShape::Scale) return "[frame, 1 or 3 numbers], alike in all rows";
  const std::size_t width = countsOf(shape).width;
  if (width == 0) return "[frame, " + numbers(count) + "]";
  return "[frame, " + numbers(count) + "]: " + std::to_string(width) + " for each point, as many points as the scene's";
}

Keyframe readKeyframe(const toml::node& node, KeyShape shape, std::size_t count) {
  const toml::array* row = node.as_array();
  if (!row || row->size() != count + 1) {
    const std::string what = row ? "has " + std::to_string(row->size()) + " entries" : "is no array";
    failAt(node.source(), "a row of frames " + what + ", must be " + rightRow(shape, count));
  }
  const toml::node& frame = (*row)[0];
  const auto number = frame.is_integer() ? frame.value<std::int64_t>() : std::nullopt;
  if (!number || !kFrame.contains(static_cast<double>(*number))) {
    failAt(frame.source(), "a row of frames does not begin with a frame, must be an integer " + kFrame.text());
  }
  Keyframe keyframe{static_cast<int>(*number), {}};
  for (std::size_t i = 1; i <= count; ++i) {
    const toml::node& value = (*row)[i];
    if (!value.is_number() || !std::isfinite(*value.value<double>())) {
      failAt(value.source(), "an animated value is none, must be a finite number");
    }
    keyframe.values.push_back(*value.value<double>());
  }
  return keyframe;
}

std::vector<Keyframe> readKeyframes(const TableReader& reader, KeyShape shape, const toml::node* still) {
  reader.require("frames");
  const toml::array* rows = reader.table().get("frames")->as_array();
  if (!rows || rows->empty()) reader.fail("frames", "frames must be an array of at least one row [frame, numbers]");
  const toml::array* first = (*rows)[0].as_array();
  const std::size_t count = valueCount(shape, still, first && !first->empty() ? first->size() - 1 : 0);
  std::vector<Keyframe> keyframes;
  for (const toml::node& row : *rows) {
    Keyframe keyframe = readKeyframe(row, shape, count);
    if (!keyframes.empty() && keyframe.frame <= keyframes.back().frame) {
      failAt(row.source(), "frame " + std::to_string(keyframe.frame) + " follows frame " +
                               std::to_string(keyframes.back().frame) + ", frames must ascend");
    }
    keyframes.push_back(std::move(keyframe));
  }
  return keyframes;
}

/// TOML of the number, exact. With an exponent, so that a large one is not read as an integer that does not fit.
std::string numberText(double value, KeyShape shape) {
  if (shape == KeyShape::Integer) {
    return std::to_string(std::llround(std::clamp(value, -kLargestInteger, kLargestInteger)));
  }
  char text[32] = {};
  std::to_chars(text, text + sizeof text - 1, value, std::chars_format::scientific);
  return text;
}

/// TOML of the numbers in the form that the key has in a scene file.
std::string valueText(const std::vector<double>& values, KeyShape shape) {
  if (values.size() == 1) return numberText(values[0], shape);
  const std::size_t width = countsOf(shape).width;
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (width > 0 && i % width == 0)
      text += i == 0 ? "[" : "], [";
    else if (i > 0)
      text += ", ";
    text += numberText(values[i], shape);
  }
  return "[" + text + (width > 0 ? "]]" : "]");
}

}  // namespace

std::vector<double> valuesAt(const std::vector<Keyframe>& keyframes, int frame) {
  const auto after = std::upper_bound(keyframes.begin(), keyframes.end(), frame,
                                      [](int wanted, const Keyframe& keyframe) { return wanted < keyframe.frame; });
  if (after == keyframes.begin()) return after->values;
  const Keyframe& before = *std::prev(after);
  if (after == keyframes.end() || before.frame == frame) return before.values;
  const double part = static_cast<double>(frame - before.frame) / (after->frame - before.frame);
  std::vector<double> values = before.values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += (after->values[i] - values[i]) * part;
  return values;
}

Animation::Animation(const toml::table& table, toml::table& scene) {
  const TableReader reader(table, "[[animate]]", {"key", "frames"});
  reader.require("key");
  pathText_ = reader.text("key", "");
  place_ = locationOf(reader.placeOf("key"));
  const auto path = splitScenePath(pathText_);
  if (!path)
    reader.fail("key", "'" + pathText_ + "' is no dotted key, must be such as camera.fov or light.NAME.cutoff");
  path_ = *path;
  const toml::table& target = tableAt(scene, path_, place_);
  shape_ = shapeOf(path_, place_);
  keyframes_ = readKeyframes(reader, shape_, target.get(path_.key));
}

std::string Animation::source() const { return std::string(kAnimatePrefix) + pathText_; }

void Animation::apply(toml::table& scene, int frame) const {
  const std::string value = valueText(valuesAt(keyframes_, frame), shape_);
  putEntry(tableAt(scene, path_, place_), parseEntry(path_.key, value, source()));
}

}  // namespace cdsm::io
