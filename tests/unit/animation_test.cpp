// SPDX-License-Identifier: Apache-2.0
// Values between keyframes; frames and names of images on the command line.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cdsm/error.hpp>

#include "io/animation.hpp"
#include "io/frame_numbers.hpp"

namespace cdsm::io {
namespace {

using Values = std::vector<double>;

TEST(ValuesAt, AreLinearBetweenKeyframesAndConstantOutside) {
  const std::vector<Keyframe> keyframes{{2, {1.0, -4.0}}, {6, {3.0, 4.0}}, {7, {0.0, 0.0}}};
  EXPECT_EQ(valuesAt(keyframes, 0), (Values{1.0, -4.0}));
  EXPECT_EQ(valuesAt(keyframes, 2), (Values{1.0, -4.0}));
  EXPECT_EQ(valuesAt(keyframes, 3), (Values{1.5, -2.0}));
  EXPECT_EQ(valuesAt(keyframes, 5), (Values{2.5, 2.0}));
  EXPECT_EQ(valuesAt(keyframes, 6), (Values{3.0, 4.0}));
  EXPECT_EQ(valuesAt(keyframes, 7), (Values{0.0, 0.0}));
  EXPECT_EQ(valuesAt(keyframes, kLastFrame), (Values{0.0, 0.0}));
}

TEST(ValuesAt, OfOneKeyframeNeverChange) {
  for (const int frame : {0, 5, 9}) EXPECT_EQ(valuesAt({{5, {0.1}}}, frame), Values{0.1});
}

TEST(ValuesAt, AreExactAtKeyframesAndBetweenEqualOnes) {
  const std::vector<Keyframe> keyframes{{0, {0.1}}, {3, {0.7}}, {10, {0.7}}};
  EXPECT_EQ(valuesAt(keyframes, 3), Values{0.7});
  for (int frame = 3; frame <= 10; ++frame) EXPECT_EQ(valuesAt(keyframes, frame), Values{0.7});
}

TEST(ParseFrames, TakesARangeOrANumber) {
  const auto expectRange = [](const char* text, int first, int last) {
    const FrameRange range = parseFrames(text);
    EXPECT_EQ(range.first, first) << text;
    EXPECT_EQ(range.last, last) << text;
  };
  expectRange("0:59", 0, 59);
  expectRange("7", 7, 7);
  expectRange("08:8", 8, 8);
  expectRange("999999", 999999, 999999);
}

TEST(ParseFrames, RefusesAllElse) {
  for (const char* text : {"", ":", "3:", ":3", "5:4", "-1:4", "0:-1", "+1", "1:2:3", "a", "1.5", " 1", "1 ",
                           "0:1000000", "99999999999999999999"}) {
    EXPECT_THROW(parseFrames(text), Error) << text;
  }
}

TEST(FramePattern, PutsTheNumberInItsField) {
  EXPECT_EQ(FramePattern("a/out_%04d.png").path(7), "a/out_0007.png");
  EXPECT_EQ(FramePattern("out_%04d.png").path(123456), "out_123456.png");
  EXPECT_EQ(FramePattern("%d.exr").path(70), "70.exr");
  EXPECT_EQ(FramePattern("%09d").path(0), "000000000");
  EXPECT_EQ(FramePattern("50%%_%01d%%.png").path(3), "50%_3%.png");
  EXPECT_EQ(FramePattern("50%_demo", ".png").path(3), "50%_demo_0003.png");
}

TEST(FramePattern, MayHaveNoField) {
  EXPECT_FALSE(FramePattern("100%%.png").isNumbered());
  EXPECT_EQ(FramePattern("100%%.png").path(3), "100%.png");
  EXPECT_TRUE(FramePattern("%d.png").isNumbered());
}

TEST(FramePattern, RefusesAllOtherFields) {
  for (const char* text : {"%", "out%", "%s.png", "%n.png", "%4d.png", "%00d.png", "%010d.png", "%-4d.png", "%+d.png",
                           "%ld.png", "%x.png", "%0", "%04", "%*d.png", "%d_%d.png", "%d_%04d.png", "% d.png"}) {
    EXPECT_THROW(FramePattern{text}, Error) << text;
  }
}

}  // namespace
}  // namespace cdsm::io
