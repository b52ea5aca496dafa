// SPDX-License-Identifier: Apache-2.0
// Nearest names by edit distance [Levenshtein 1966].
#include "io/spelling.hpp"

#include <algorithm>
#include <numeric>

namespace cdsm::io {
namespace {

/// Letters to insert, delete or replace to get from one word to the other.
std::size_t editDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);  // distances of a prefix of `from` to all prefixes of `to`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[to.size()];
}

/// A third of a word may be wrong, and in any case two letters that changed places in a word of four.
std::size_t tolerated(std::string_view name) { return std::max<std::size_t>(name.size() < 4 ? 1 : 2, name.size() / 3); }

}  // namespace

std::string joinNames(const std::vector<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& names) {
  const std::string* nearest = nullptr;
  std::size_t nearestDistance = 0;
  if (wrong.size() < 64) {  // nothing longer is a misspelling, and the distance takes quadratic time
    for (const std::string& name : names) {
      const std::size_t distance = editDistance(wrong, name);
      if (distance > tolerated(name) || (nearest && distance >= nearestDistance)) continue;
      nearest = &name;
      nearestDistance = distance;
    }
  }
  if (nearest) return ", did you mean '" + *nearest + "'?";
  return names.empty() ? ", there are none" : ", must be one of: " + joinNames(names);
}

}  // namespace cdsm::io
