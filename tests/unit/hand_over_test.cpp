// SPDX-License-Identifier: Apache-2.0
// Clusters handed over: when they change, how long it takes, what stays in between.
#include "cluster/hand_over.hpp"

#include <gtest/gtest.h>

namespace cdsm::cluster {
namespace {

/// Four items at the corners of a rectangle: best are two clusters of neighbours across its shorter side.
LightPlan planOfFour(double width, double height) {
  LightPlan plan;
  for (unsigned i = 0; i < 4; ++i) {
    const glm::dvec2 middle = glm::dvec2(i % 2, i / 2) * glm::dvec2(width, height);
    Extents e;
    e.seen = true;
    e.squareLow = e.pictureLow = middle - 0.05;
    e.squareHigh = e.pictureHigh = middle + 0.05;
    plan.items.push_back({1.0, 1.0, {e}});
    plan.objects.push_back(i + 3);
  }
  plan.clusters = width < height ? LightClusters{{3, 4}, {5, 6}} : LightClusters{{3, 5}, {4, 6}};
  return plan;
}

LightPlan planOfFour(bool rows) { return rows ? planOfFour(0.2, 0.9) : planOfFour(0.9, 0.2); }

TEST(HandOver, BeginsWithThePlan) {
  HandOver handOver;
  handOver.next(planOfFour(true));
  EXPECT_EQ(handOver.current(), planOfFour(true).clusters);
  EXPECT_TRUE(handOver.former().empty());
  EXPECT_EQ(handOver.share(), 1.0f);
}

TEST(HandOver, FadesFromOneSetToTheOther) {
  HandOver handOver;
  handOver.next(planOfFour(true));
  float before = 0.0f;
  for (int frame = 1; frame < HandOver::kFrames; ++frame) {
    handOver.next(planOfFour(false));
    EXPECT_EQ(handOver.current(), planOfFour(false).clusters);
    EXPECT_EQ(handOver.former(), planOfFour(true).clusters);
    EXPECT_GT(handOver.share(), before);
    EXPECT_LT(handOver.share(), 1.0f);
    EXPECT_LE(handOver.share() - before, 1.01f / HandOver::kFrames);
    before = handOver.share();
  }
  handOver.next(planOfFour(false));
  EXPECT_TRUE(handOver.former().empty());
  EXPECT_EQ(handOver.current(), planOfFour(false).clusters);
}

/// Whatever would be best meanwhile: one fading at a time.
TEST(HandOver, EndsWhatItHasBegun) {
  HandOver handOver;
  handOver.next(planOfFour(true));
  for (int frame = 1; frame <= HandOver::kFrames; ++frame) {
    handOver.next(planOfFour(frame % 2 == 1));
    if (frame == 1) EXPECT_TRUE(handOver.former().empty());  // that plan again
    if (frame > 2 && frame < HandOver::kFrames) {
      EXPECT_EQ(handOver.current(), planOfFour(false).clusters);
      EXPECT_EQ(handOver.former(), planOfFour(true).clusters);
    }
  }
}

TEST(HandOver, KeepsClustersThatAreNotMuchWorse) {
  const LightPlan first = planOfFour(0.5, 0.6), other = planOfFour(0.6, 0.5), distant = planOfFour(0.9, 0.5);
  ASSERT_LT(errorOf(other, other.clusters), errorOf(other, first.clusters));
  HandOver handOver;
  handOver.next(first);
  for (int frame = 0; frame < 3; ++frame) {
    handOver.next(other);
    EXPECT_EQ(handOver.current(), first.clusters);
    EXPECT_TRUE(handOver.former().empty());
  }
  handOver.next(distant);
  EXPECT_EQ(handOver.current(), distant.clusters);
}

/// Other objects: no time to fade.
TEST(HandOver, TakesOtherObjectsAtOnce) {
  HandOver handOver;
  handOver.next(planOfFour(true));
  handOver.next(planOfFour(false));
  LightPlan more = planOfFour(false);
  more.objects.back() = 9;
  more.clusters = {{3, 5}, {4, 9}};
  handOver.next(more);
  EXPECT_EQ(handOver.current(), more.clusters);
  EXPECT_TRUE(handOver.former().empty());
}

TEST(HandOver, OfNothing) {
  HandOver handOver;
  for (int frame = 0; frame < 3; ++frame) {
    handOver.next({});
    EXPECT_TRUE(handOver.current().empty());
    EXPECT_TRUE(handOver.former().empty());
  }
}

}  // namespace
}  // namespace cdsm::cluster
