// SPDX-License-Identifier: Apache-2.0
#include "technique/memory_budget.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <cdsm/error.hpp>

#include "scene/range.hpp"

namespace cdsm::technique {

namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;
/// Of the search, on a logarithmic scale: between 0.01 and 0.99 they come within 2 % of the smallest tolerance that
/// fits.
constexpr int kBisections = 8;
/// Where the search begins for a tolerance of 0, which has no logarithm.
constexpr float kFinestTolerance = 1e-4f;
/// The least bookkeeping of any strategy is 8 bytes for a tile of 64 texels.
constexpr std::uint64_t kTexelsPerLeastByte = 8;

const char* const kMoreRoom = "take smaller maps or a higher limit";

}  // namespace

std::string formatMebibytes(std::uint64_t bytes) {
  char text[32];
  // rounded up, so that what is named would be enough
  std::snprintf(text, sizeof text, "%.*f MiB", bytes < kMebibyte ? 4 : 1,
                bytes < kMebibyte ? std::ceil(double(bytes) / kMebibyte * 1e4) / 1e4
                                  : std::ceil(double(bytes) / kMebibyte * 10.0) / 10.0);
  return text;
}

std::uint64_t MemoryBudget::limit() const {
  const double bytes = double(shadows_.memoryLimitMb) * kMebibyte;
  return bytes <= 0.0 ? 0 : std::uint64_t(std::clamp(bytes, 1.0, 1e18));
}

void MemoryBudget::fail(std::uint64_t bytes, const char* atLeast, const std::string& remedy) const {
  throw Error("the maps need " + std::string(atLeast) + formatMebibytes(bytes) +
              ", more than shadows.memory_limit_mb = " + scene::formatNumber(shadows_.memoryLimitMb) + "; " + remedy);
}

void MemoryBudget::requireRoomFor(std::uint64_t texels) const {
  if (!fits(texels / kTexelsPerLeastByte)) fail(texels / kTexelsPerLeastByte, "at least ", kMoreRoom);
}

float MemoryBudget::fit(const std::function<std::uint64_t(float tolerance)>& build) const {
  const std::uint64_t wanted = build(shadows_.tolerance);
  if (fits(wanted)) return shadows_.tolerance;
  if (shadows_.onOverflow != "coarsen")
    fail(wanted, "", std::string(kMoreRoom) + ", a larger tolerance, or on_overflow = \"coarsen\"");
  float fine = std::max(shadows_.tolerance, kFinestTolerance), coarse = kCoarsestTolerance, built = coarse;
  const std::uint64_t least = shadows_.tolerance < coarse ? build(coarse) : wanted;
  if (!fits(least)) fail(least, "even at the largest tolerance ", kMoreRoom);
  for (int i = 0; i < kBisections; ++i) {
    built = std::sqrt(fine * coarse);
    (fits(build(built)) ? coarse : fine) = built;
  }
  if (built != coarse) build(coarse);
  return coarse;
}

}  // namespace cdsm::technique
