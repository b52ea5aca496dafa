// SPDX-License-Identifier: Apache-2.0
#include "cluster/convex_body.hpp"

#include <algorithm>
#include <map>

#include "cluster/planar_hull.hpp"

namespace cdsm::cluster {

namespace {

/// Corners of cuts nearer than this part of the body's size are one corner.
constexpr double kSamePart = 1e-12;

glm::dvec3 center(const ConvexBody::Polygon& polygon) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& p : polygon) sum += p;
  return sum / double(polygon.size());
}

/// Newell's normal: right for any flat polygon, also with corners in one line.
glm::dvec3 normalOf(const ConvexBody::Polygon& polygon) {
  glm::dvec3 normal(0.0);
  const glm::dvec3 origin = polygon.front();
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    normal += glm::cross(polygon[i] - origin, polygon[i + 1] - origin);
  return normal;
}

glm::dvec3 centerOf(const std::vector<ConvexBody::Polygon>& polygons) {
  glm::dvec3 sum(0.0);
  for (const auto& polygon : polygons) sum += center(polygon);
  return sum / double(std::max<std::size_t>(polygons.size(), 1));
}

/// An edge by the bits of its ends, in either direction.
struct Edge {
  glm::dvec3 from, to;
};

/// Edges that belong to one of these polygons alone.
std::vector<Edge> borderOf(const std::vector<ConvexBody::Polygon>& polygons) {
  std::vector<Edge> open;
  for (const auto& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Edge edge{polygon[i], polygon[(i + 1) % polygon.size()]};
      const auto same = std::find_if(open.begin(), open.end(), [&](const Edge& e) {
        return (e.from == edge.to && e.to == edge.from) || (e.from == edge.from && e.to == edge.to);
      });
      if (same != open.end())
        open.erase(same);
      else
        open.push_back(edge);
    }
  return open;
}

/// Sutherland and Hodgman; corners on the plane belong to both sides. Corners of the cut are added to `cut`.
ConvexBody::Polygon clipPolygon(const ConvexBody::Polygon& polygon, const HalfSpace& inside, double same,
                                ConvexBody::Polygon& cut) {
  ConvexBody::Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = inside.distance(p), dq = inside.distance(q);
    if (dp >= -same) kept.push_back(p);
    if (std::abs(dp) <= same) cut.push_back(p);
    if ((dp > same && dq < -same) || (dp < -same && dq > same)) {
      // from the inner end, so that both polygons at an edge get the same corner
      const glm::dvec3 corner = dp > 0.0 ? p + (q - p) * (dp / (dp - dq)) : q + (p - q) * (dq / (dq - dp));
      kept.push_back(corner);
      cut.push_back(corner);
    }
  }
  return kept.size() >= 3 ? kept : ConvexBody::Polygon{};
}

double sizeOf(const std::vector<ConvexBody::Polygon>& polygons) {
  double size = 0.0;
  for (const auto& polygon : polygons)
    for (const glm::dvec3& p : polygon) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return size;
}

}  // namespace

HalfSpace halfSpace(const glm::dvec3& normal, const glm::dvec3& point) {
  const glm::dvec3 unit = glm::normalize(normal);
  return {unit, -glm::dot(unit, point)};
}

std::vector<glm::dvec3> hullInPlane(const std::vector<glm::dvec3>& points, const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, other)), v = glm::cross(normal, u);
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : points) flat.emplace_back(glm::dot(u, p), glm::dot(v, p));
  const double height = glm::dot(normal, points.front());
  ConvexBody::Polygon polygon;
  for (const glm::dvec2& corner : planarHull(flat)) polygon.push_back(corner.x * u + corner.y * v + height * normal);
  return polygon.size() >= 3 && glm::length(normalOf(polygon)) > 0.0 ? polygon : ConvexBody::Polygon{};
}

ConvexBody ConvexBody::hexahedron(const std::vector<glm::dvec3>& c) {
  ConvexBody body;
  body.polygons_ = {{c[0], c[2], c[3], c[1]}, {c[4], c[5], c[7], c[6]}, {c[0], c[1], c[5], c[4]},
                    {c[2], c[6], c[7], c[3]}, {c[0], c[4], c[6], c[2]}, {c[1], c[3], c[7], c[5]}};
  return body;
}

ConvexBody ConvexBody::box(const scene::Bounds& bounds) {
  std::vector<glm::dvec3> corners;
  const glm::dvec3 low(bounds.low), high(bounds.high);
  for (int i = 0; i < 8; ++i) corners.push_back(glm::mix(low, high, glm::dvec3(i & 1, i >> 1 & 1, i >> 2)));
  return hexahedron(corners);
}

std::vector<glm::dvec3> ConvexBody::vertices() const {
  std::vector<glm::dvec3> list;
  for (const Polygon& polygon : polygons_) list.insert(list.end(), polygon.begin(), polygon.end());
  return list;
}

std::vector<HalfSpace> ConvexBody::halfSpaces() const {
  std::vector<HalfSpace> list;
  const glm::dvec3 middle = centerOf(polygons_);
  for (const Polygon& polygon : polygons_) {
    const glm::dvec3 normal = normalOf(polygon);
    if (glm::length(normal) <= 0.0) continue;
    HalfSpace side = halfSpace(normal, polygon.front());
    if (side.distance(middle) < 0.0) side = {-side.normal, -side.offset};
    list.push_back(side);
  }
  return list;
}

ConvexBody ConvexBody::hullWith(const glm::dvec3& point) const {
  const std::vector<HalfSpace> sides = halfSpaces();
  if (sides.size() != polygons_.size()) return *this;
  ConvexBody hull;
  std::vector<Polygon> seen;  // from the point: they end up inside of the hull
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    (sides[i].distance(point) < 0.0 ? seen : hull.polygons_).push_back(polygons_[i]);
  for (const Edge& edge : borderOf(seen)) hull.polygons_.push_back({point, edge.from, edge.to});
  return hull;
}

ConvexBody ConvexBody::sweptAlong(const glm::dvec3& way) const {
  const std::vector<HalfSpace> sides = halfSpaces();
  if (sides.size() != polygons_.size()) return *this;
  ConvexBody hull;
  std::vector<Polygon> moved;
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    (glm::dot(sides[i].normal, way) < 0.0 ? moved : hull.polygons_).push_back(polygons_[i]);
  for (const Edge& edge : borderOf(moved))
    hull.polygons_.push_back({edge.from, edge.to, edge.to + way, edge.from + way});
  for (Polygon polygon : moved) {
    for (glm::dvec3& p : polygon) p += way;
    hull.polygons_.push_back(polygon);
  }
  return hull;
}

void ConvexBody::clip(const HalfSpace& inside) {
  if (empty()) return;
  const double same = kSamePart * (sizeOf(polygons_) + std::abs(inside.offset));
  bool cutsAny = false;
  for (const Polygon& polygon : polygons_)
    for (const glm::dvec3& p : polygon) cutsAny = cutsAny || inside.distance(p) < -same;
  if (!cutsAny) return;
  std::vector<Polygon> kept;
  Polygon cut;
  for (const Polygon& polygon : polygons_) {
    Polygon clipped = clipPolygon(polygon, inside, same, cut);
    const bool inPlane = std::all_of(clipped.begin(), clipped.end(),
                                     [&](const glm::dvec3& p) { return std::abs(inside.distance(p)) <= same; });
    if (!inPlane) kept.push_back(std::move(clipped));
  }
  if (kept.empty()) {
    polygons_.clear();
    return;
  }
  Polygon lid = cut.size() >= 3 ? hullInPlane(cut, inside.normal) : Polygon{};
  if (!lid.empty()) kept.push_back(std::move(lid));
  polygons_ = std::move(kept);
}

void ConvexBody::clip(const std::vector<HalfSpace>& inside) {
  for (const HalfSpace& side : inside) clip(side);
}

bool ConvexBody::mayTouch(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& axes) const {
  if (empty()) return false;
  for (const HalfSpace& side : halfSpaces())
    if (std::all_of(points.begin(), points.end(), [&](const glm::dvec3& p) { return side.distance(p) < 0.0; }))
      return false;
  for (const glm::dvec3& axis : axes) {
    double low = INFINITY, high = -INFINITY, bodyLow = INFINITY, bodyHigh = -INFINITY;
    for (const glm::dvec3& p : points) {
      low = std::min(low, glm::dot(axis, p));
      high = std::max(high, glm::dot(axis, p));
    }
    for (const Polygon& polygon : polygons_)
      for (const glm::dvec3& p : polygon) {
        bodyLow = std::min(bodyLow, glm::dot(axis, p));
        bodyHigh = std::max(bodyHigh, glm::dot(axis, p));
      }
    if (high < bodyLow || bodyHigh < low) return false;
  }
  return true;
}

}  // namespace cdsm::cluster
