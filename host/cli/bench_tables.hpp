// SPDX-License-Identifier: Apache-2.0
// Tables of the benchmarks: figures measured here beside those of [Knecht 2011, §5.7], as values and as ratios.
#pragma once

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace cdsm::cli {

/// Stands for a figure that there is none of.
constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

/// One quantity in all columns of a table. `thesis` and `wanted` are empty or as long as `ours`.
struct Row {
  std::string label;
  std::string unit;            ///< "ms", "nodes"; empty: a plain number
  std::vector<double> ours;    ///< measured here
  std::vector<double> thesis;  ///< in the same unit
  std::vector<double> wanted;  ///< the goal: at most this, unless the label says "at least"
  double ourBase = 0.0;        ///< what ours is divided by; 0: no ratios
  double thesisBase = 0.0;     ///< what the thesis's figures are divided by; 0: no ratios
};

struct Table {
  std::string name;   ///< key of reports and plots: letters, digits, dots, dashes
  std::string title;  ///< with the number that it has in the thesis
  std::string parameter;
  std::vector<std::string> columns;
  std::vector<Row> rows;
  std::vector<std::string> notes = {};  ///< below the table: why a column has no figures
  std::string source = "thesis";        ///< of the figures beside ours
};

/// A row without ratios, whose figures are still to come.
Row plainRow(std::string label, std::string unit = "", std::vector<double> wanted = {});

/// A row whose ratios are to the column where the thesis has its smallest value; where it has none, to ours.
Row rowToSmallest(std::string label, std::string unit, std::vector<double> ours, std::vector<double> thesis);

/// A row whose ratios are to figures of other rows or tables, such as the frame without shadows.
Row rowToBase(std::string label, std::vector<double> ours, double ourBase, std::vector<double> thesis,
              double thesisBase);

/// `count` values from `first` on.
std::vector<double> slice(const std::vector<double>& values, std::size_t first, std::size_t count);

/// The middle value, the upper one of two. `values` must not be empty.
double median(std::vector<double> values);

/// Exponent p of the power law y = c x^p that fits best: least squares of the logarithms. All values are above 0 and
/// two x differ; otherwise the result is NaN.
double powerLawExponent(const std::vector<double>& x, const std::vector<double>& y);

/// Three significant digits, or all of those before the point; "-" for kNoFigure.
std::string numberText(double value);

void printTable(std::ostream& out, const Table& table);

nlohmann::ordered_json tableJson(const Table& table);

}  // namespace cdsm::cli
