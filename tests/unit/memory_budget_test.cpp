// SPDX-License-Identifier: Apache-2.0
// The limit of the maps' memory, with maps that are only numbers.
#include "technique/memory_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <cdsm/error.hpp>

namespace cdsm::technique {
namespace {

constexpr std::uint64_t kMebibyte = 1048576;

ShadowSettings settings(float limit, const std::string& onOverflow, float tolerance = 0.01f) {
  ShadowSettings shadows;
  shadows.tolerance = tolerance;
  shadows.memoryLimitMb = limit;
  shadows.onOverflow = onOverflow;
  return shadows;
}

/// Maps of 1 MiB and what the tolerance adds; notes the tolerances.
struct Builder {
  std::vector<float> tried;
  std::uint64_t operator()(float tolerance) {
    tried.push_back(tolerance);
    return kMebibyte + std::uint64_t(1e5 / std::sqrt(double(tolerance) + 1e-4));
  }
};

std::string messageOf(const ShadowSettings& shadows) {
  try {
    MemoryBudget(shadows).fit(Builder());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(MemoryBudget, BuildsOnceWhatFits) {
  for (const float limit : {0.0f, 2.0f}) {
    Builder builder;
    EXPECT_EQ(MemoryBudget(settings(limit, "coarsen")).fit(std::ref(builder)), 0.01f);
    EXPECT_EQ(builder.tried, std::vector<float>{0.01f});
  }
}

TEST(MemoryBudget, NamesWhatIsNeeded) {
  EXPECT_EQ(
      messageOf(settings(1.5f, "error")),
      "the maps need 2.0 MiB, more than shadows.memory_limit_mb = 1.5; take smaller maps or a higher limit, a larger "
      "tolerance, or on_overflow = \"coarsen\"");
  EXPECT_EQ(messageOf(settings(1.0f, "coarsen")).rfind("the maps need even at the largest tolerance 1.1 MiB", 0), 0u);
}

TEST(MemoryBudget, FindsTheSmallestToleranceThatFits) {
  for (const float tolerance : {0.0f, 0.001f, 0.01f}) {
    Builder builder;
    const float found = MemoryBudget(settings(1.25f, "coarsen", tolerance)).fit(std::ref(builder));
    EXPECT_EQ(builder.tried.back(), found) << "the maps that are left are those of the answer";
    EXPECT_LE(builder.tried.size(), 11u);
    EXPECT_LE(Builder()(found), kMebibyte * 5 / 4);
    EXPECT_GT(Builder()(found / 1.05f), kMebibyte * 5 / 4);
  }
}

TEST(MemoryBudget, RefusesTooManyTexelsBeforehand) {
  EXPECT_NO_THROW(MemoryBudget(settings(1.0f, "coarsen")).requireRoomFor(8 * kMebibyte));
  EXPECT_THROW(MemoryBudget(settings(1.0f, "coarsen")).requireRoomFor(8 * kMebibyte + 8), Error);
  EXPECT_NO_THROW(MemoryBudget(settings(0.0f, "error")).requireRoomFor(kMebibyte * kMebibyte));
}

TEST(MemoryBudget, CountsFractionsOfMebibytes) {
  EXPECT_EQ(MemoryBudget(settings(0.5f, "error")).limit(), kMebibyte / 2);
  EXPECT_EQ(MemoryBudget(settings(1e-30f, "error")).limit(), 1u) << "0 would be no limit";
  EXPECT_GT(MemoryBudget(settings(1e38f, "error")).limit(), kMebibyte * kMebibyte);
}

}  // namespace
}  // namespace cdsm::technique
