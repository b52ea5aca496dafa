// SPDX-License-Identifier: Apache-2.0
// Figures of the benchmarks: medians, exponents, ratios, and how tables are printed.
#include "bench_tables.hpp"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

namespace cdsm::cli {
namespace {

TEST(BenchTables, MedianIsTheMiddleValue) {
  EXPECT_EQ(median({7.0}), 7.0);
  EXPECT_EQ(median({9.0, 1.0, 5.0}), 5.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 3.0) << "the upper one of two";
  EXPECT_EQ(median({100.0, 1.0, 2.0, 3.0, 2.0}), 2.0) << "an outlier moves nothing";
}

TEST(BenchTables, SliceTakesWhatFollows) {
  EXPECT_EQ(slice({1.0, 2.0, 3.0, 4.0}, 1, 2), (std::vector<double>{2.0, 3.0}));
  EXPECT_TRUE(slice({1.0}, 1, 0).empty());
}

TEST(BenchTables, ExponentOfAPowerLawIsFound) {
  const std::vector<double> x = {1.0, 2.0, 4.0, 8.0, 24.0};
  for (const double exponent : {-0.5, 0.0, 1.0, 1.5}) {
    std::vector<double> y;
    for (const double value : x) y.push_back(3.7 * std::pow(value, exponent));
    EXPECT_NEAR(powerLawExponent(x, y), exponent, 1e-12);
  }
}

TEST(BenchTables, ExponentIsThatOfLeastSquares) {
  // logarithms to base 2: x = 0, 1, 2 and y = 0, 3, 3; the line of least squares has the slope 3 / 2
  EXPECT_NEAR(powerLawExponent({1.0, 2.0, 4.0}, {1.0, 8.0, 8.0}), 1.5, 1e-12);
}

TEST(BenchTables, AFixedCostLowersTheExponent) {
  const std::vector<double> x = {1.0, 2.0, 4.0, 8.0};
  EXPECT_LT(powerLawExponent(x, {11.0, 12.0, 14.0, 18.0}), 0.3);
}

TEST(BenchTables, ExponentNeedsTwoPlaces) {
  EXPECT_TRUE(std::isnan(powerLawExponent({2.0, 2.0}, {1.0, 3.0})));
  EXPECT_TRUE(std::isnan(powerLawExponent({}, {})));
}

TEST(BenchTables, RatiosAreToTheColumnWhereTheThesisIsSmallest) {
  const Row row = rowToSmallest("frame", "ms", {30.0, 10.0, 20.0}, {9.0, 8.0, 4.0});
  EXPECT_EQ(row.ourBase, 20.0);
  EXPECT_EQ(row.thesisBase, 4.0);
  const Row alone = rowToSmallest("frame", "ms", {30.0, 10.0, 20.0}, {});
  EXPECT_EQ(alone.ourBase, 10.0) << "without the thesis, to our own smallest";
  EXPECT_EQ(alone.thesisBase, 0.0);
}

TEST(BenchTables, NumbersHaveThreeDigitsOrAllBeforeThePoint) {
  EXPECT_EQ(numberText(0.0), "0");
  EXPECT_EQ(numberText(double(0.01f)), "0.01");
  EXPECT_EQ(numberText(0.012345), "0.0123");
  EXPECT_EQ(numberText(3.14159), "3.14");
  EXPECT_EQ(numberText(26.04), "26");
  EXPECT_EQ(numberText(1234567.8), "1234568");
}

TEST(BenchTables, JsonHoldsValuesAndRatios) {
  const Table table{
      "5.1", "Table 5.1", "texels", {"a", "b"}, {rowToBase("build", {10.0, 30.0}, 20.0, {4.0, 8.0}, 8.0)}};
  const auto json = tableJson(table);
  EXPECT_EQ(json.at("name"), "5.1");
  EXPECT_EQ(json.at("columns"), (std::vector<std::string>{"a", "b"}));
  const auto& row = json.at("rows").at(0);
  EXPECT_EQ(row.at("unit"), "ms");
  EXPECT_EQ(row.at("ours"), (std::vector<double>{10.0, 30.0}));
  EXPECT_EQ(row.at("ours_ratio"), (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(row.at("thesis_ratio"), (std::vector<double>{0.5, 1.0}));
  EXPECT_TRUE(row.at("wanted").empty());
}

TEST(BenchTables, LinesWithoutFiguresAreLeftOut) {
  Row row = plainRow("clustering", "ms", {1.0});
  row.ours = {0.5};
  std::ostringstream text;
  printTable(text, {"cpu", "On the CPU", "objects", {"50"}, {row}});
  EXPECT_NE(text.str().find("On the CPU"), std::string::npos);
  EXPECT_NE(text.str().find("clustering [ms]"), std::string::npos);
  EXPECT_NE(text.str().find("wanted"), std::string::npos);
  EXPECT_EQ(text.str().find("thesis"), std::string::npos);
  EXPECT_EQ(text.str().find("ratio"), std::string::npos);
}

}  // namespace
}  // namespace cdsm::cli
