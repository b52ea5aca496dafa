// SPDX-License-Identifier: Apache-2.0
#include "bench_tables.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace cdsm::cli {
namespace {

constexpr int kLabelWidth = 44;
constexpr int kColumnWidth = 14, kColumnGap = 2;

std::vector<double> ratios(const std::vector<double>& values, double base) {
  std::vector<double> result;
  if (base == 0.0) return result;
  for (const double value : values) result.push_back(value / base);
  return result;
}

/// Nothing where there are no values.
void printLine(std::ostream& out, int width, const std::string& label, const std::vector<double>& values) {
  if (values.empty()) return;
  out << "  " << std::left << std::setw(kLabelWidth) << label << std::right;
  for (const double value : values) out << std::setw(width) << numberText(value);
  out << '\n';
}

std::string inUnit(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " [" + unit + "]";
}

void printRow(std::ostream& out, int width, const Row& row, const std::string& source) {
  printLine(out, width, inUnit(row.label, row.unit), row.ours);
  printLine(out, width, inUnit(row.ours.empty() ? row.label : "  " + source, row.unit), row.thesis);
  printLine(out, width, "  ratio", ratios(row.ours, row.ourBase));
  printLine(out, width, "  ratio in the " + source, ratios(row.thesis, row.thesisBase));
  printLine(out, width, "  wanted", row.wanted);
}

int columnWidth(const Table& table) {
  std::size_t width = kColumnWidth;
  for (const std::string& column : table.columns) width = std::max(width, column.size() + kColumnGap);
  return int(width);
}

}  // namespace

Row plainRow(std::string label, std::string unit, std::vector<double> wanted) {
  return {std::move(label), std::move(unit), {}, {}, std::move(wanted), 0.0, 0.0};
}

Row rowToSmallest(std::string label, std::string unit, std::vector<double> ours, std::vector<double> thesis) {
  Row row{std::move(label), std::move(unit), std::move(ours), std::move(thesis), {}, 0.0, 0.0};
  const std::vector<double>& judged = row.thesis.empty() ? row.ours : row.thesis;
  const auto column = std::size_t(std::min_element(judged.begin(), judged.end()) - judged.begin());
  if (column < row.ours.size()) row.ourBase = row.ours[column];
  if (column < row.thesis.size()) row.thesisBase = row.thesis[column];
  return row;
}

Row rowToBase(std::string label, std::vector<double> ours, double ourBase, std::vector<double> thesis,
              double thesisBase) {
  return {std::move(label), "ms", std::move(ours), std::move(thesis), {}, ourBase, thesisBase};
}

std::vector<double> slice(const std::vector<double>& values, std::size_t first, std::size_t count) {
  const auto from = values.begin() + std::ptrdiff_t(first);
  return {from, from + std::ptrdiff_t(count)};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double powerLawExponent(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = double(x.size());
  double meanX = 0.0, meanY = 0.0, covariance = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    meanX += std::log(x[i]) / n;
    meanY += std::log(y[i]) / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double fromMean = std::log(x[i]) - meanX;
    covariance += fromMean * (std::log(y[i]) - meanY);
    variance += fromMean * fromMean;
  }
  return variance > 0.0 ? covariance / variance : std::numeric_limits<double>::quiet_NaN();
}

std::string numberText(double value) {
  if (std::isnan(value)) return "-";
  std::ostringstream text;
  if (std::abs(value) >= 100.0) {
    text << std::fixed << std::setprecision(0) << value;
  } else {
    text << std::setprecision(3) << value;
  }
  return text.str();
}

void printTable(std::ostream& out, const Table& table) {
  const int width = columnWidth(table);
  out << '\n' << table.title << "\n  " << std::left << std::setw(kLabelWidth) << table.parameter << std::right;
  for (const std::string& column : table.columns) out << std::setw(width) << column;
  out << '\n';
  for (const Row& row : table.rows) printRow(out, width, row, table.source);
  for (const std::string& note : table.notes) out << "  " << note << '\n';
}

nlohmann::ordered_json tableJson(const Table& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Row& row : table.rows) {
    rows.push_back({{"label", row.label},
                    {"unit", row.unit},
                    {"ours", row.ours},
                    {"ours_ratio", ratios(row.ours, row.ourBase)},
                    {"thesis", row.thesis},
                    {"thesis_ratio", ratios(row.thesis, row.thesisBase)},
                    {"wanted", row.wanted}});
  }
  return {{"name", table.name},     {"title", table.title}, {"parameter", table.parameter}, {"columns", table.columns},
          {"source", table.source}, {"rows", rows},         {"notes", table.notes}};
}

}  // namespace cdsm::cli
