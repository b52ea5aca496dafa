// SPDX-License-Identifier: Apache-2.0
#include "cluster/planar_hull.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

namespace cdsm::cluster {

namespace {

namespace bg = boost::geometry;
using Point2 = bg::model::d2::point_xy<double>;

/// Of the grid's cells along an outline: products of two such numbers fit a double.
constexpr int kGridBits = 24;

}  // namespace

std::vector<glm::dvec2> planarHull(const std::vector<glm::dvec2>& points) {
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const glm::dvec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double size = std::max({high.x - low.x, high.y - low.y, 1e-300});
  const double cell = std::exp2(std::ceil(std::log2(size)) - kGridBits);
  const auto onGrid = [&](const glm::dvec2& p) { return glm::round((p - low) / cell); };
  bg::model::multi_point<Point2> list;
  for (const glm::dvec2& p : points) list.push_back({onGrid(p).x, onGrid(p).y});
  bg::model::polygon<Point2> hull;
  bg::convex_hull(list, hull);
  std::map<std::pair<double, double>, std::size_t> cornerOf;  // by its place on the grid
  for (std::size_t i = 0; i + 1 < hull.outer().size(); ++i)
    cornerOf.emplace(std::pair(hull.outer()[i].x(), hull.outer()[i].y()), cornerOf.size());
  std::vector<glm::dvec2> outline(cornerOf.size());
  for (const glm::dvec2& p : points) {
    const auto corner = cornerOf.find({onGrid(p).x, onGrid(p).y});
    if (corner != cornerOf.end()) outline[corner->second] = p;
  }
  return outline;
}

}  // namespace cdsm::cluster
