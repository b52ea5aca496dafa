// SPDX-License-Identifier: Apache-2.0
// shadows.memory_limit_mb: what finished maps may take, and the tolerance at which they fit. Knows no strategy.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <cdsm/scene.hpp>

namespace cdsm::technique {

/// Largest tolerance that coarsening may end at.
inline constexpr float kCoarsestTolerance = 0.99f;

class MemoryBudget {
 public:
  explicit MemoryBudget(const ShadowSettings& shadows) : shadows_(shadows) {}

  /// In bytes; 0: there is none.
  std::uint64_t limit() const;
  bool fits(std::uint64_t bytes) const { return limit() == 0 || bytes <= limit(); }

  /// Throws Error if maps of so many texels cannot fit, whatever the strategy and the tolerance.
  void requireRoomFor(std::uint64_t texels) const;

  /// Builds the maps at shadows.tolerance, or at about the smallest tolerance above it at which they fit, and returns
  /// that; throws Error with the bytes needed if they cannot fit or may not be coarsened. `build` builds all maps at a
  /// tolerance and returns their bytes. The answer depends on what it returns alone: the same tolerances are tried
  /// whatever was built before, at most 11 builds.
  float fit(const std::function<std::uint64_t(float tolerance)>& build) const;

 private:
  [[noreturn]] void fail(std::uint64_t bytes, const char* atLeast, const std::string& remedy) const;

  ShadowSettings shadows_;
};

/// "83.2 MiB".
std::string formatMebibytes(std::uint64_t bytes);

}  // namespace cdsm::technique
