// SPDX-License-Identifier: Apache-2.0
#include "cluster/focus.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "cluster/light_camera.hpp"
#include "cluster/light_space.hpp"
#include "cluster/planar_hull.hpp"
#include "scene/objects.hpp"

namespace cdsm::cluster {

namespace {

using Outline = std::vector<glm::dvec2>;

/// A single camera of an omni light sees at most this far to each side (55 degrees): more would waste its texels.
constexpr double kWidestTangent = 1.43;
/// Sides of the polygon around a spot's circle.
constexpr int kConeSides = 32;
constexpr int kTurns = 3;  ///< of the camera towards the middle of what it sees
/// No picture is narrower than this part of the other side.
constexpr double kNarrowest = 1e-3;
/// The near plane lies this part of the distance in front of the nearest point.
constexpr double kNearMargin = 1e-3;

/// An object in the cluster: points, and the box for when some of them are behind the light.
struct Seen {
  std::vector<glm::dvec3> points;
  const Caster* shape;
  std::vector<glm::dvec3> cut;  ///< of the mesh that cuts a volume: rays must meet all of it that is on their way
};

glm::dvec3 inFrame(const LightFrame& frame, const glm::dvec3& world) {
  const glm::dvec3 way = world - frame.position;
  return {glm::dot(frame.right, way), glm::dot(frame.down, way), glm::dot(frame.axis, way)};
}

glm::dvec2 inPicture(const LightFrame& frame, const glm::dvec3& world) {
  const glm::dvec3 p = inFrame(frame, world);
  return frame.parallel ? glm::dvec2(p) : glm::dvec2(p) / p.z;
}

void append(Outline& outline, const Outline& more) { outline.insert(outline.end(), more.begin(), more.end()); }

/// What a picture can show, around its middle: a polygon around a spot's circle, the square of one side of an omni
/// light.
Outline pictureLimit(const LightFrame& frame, bool circle) {
  Outline corners;
  const int sides = circle ? kConeSides : 4;
  const double radius = frame.tangent / std::cos(glm::pi<double>() / sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = glm::two_pi<double>() * (i + 0.5) / sides;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

/// Sutherland and Hodgman: what of a convex outline lies within a convex polygon around the middle of the picture.
Outline clipOutline(Outline outline, const Outline& limit) {
  for (std::size_t side = 0; side < limit.size(); ++side) {
    const glm::dvec2 corner = limit[side], edge = limit[(side + 1) % limit.size()] - corner;
    const auto inside = [&](const glm::dvec2& p) { return edge.x * (p.y - corner.y) - edge.y * (p.x - corner.x); };
    Outline kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
      const double dp = inside(p), dq = inside(q);
      if (dp >= 0.0) kept.push_back(p);
      if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) kept.push_back(p + (q - p) * (dp / (dp - dq)));
    }
    outline = std::move(kept);
  }
  return outline;
}

/// An object in the picture: hull of its points; of its box clipped to the frustum if it reaches behind the light.
Outline objectOutline(const LightFrame& frame, const Seen& object, double nearDepth) {
  Outline outline;
  const bool inFront = frame.parallel || std::all_of(object.points.begin(), object.points.end(),
                                                     [&](const auto& p) { return inFrame(frame, p).z > nearDepth; });
  if (inFront) {
    for (const glm::dvec3& p : object.points) outline.push_back(inPicture(frame, p));
  } else {
    ConvexBody box = ConvexBody::hexahedron(object.shape->corners);
    box.clip(frustumOf(frame, nearDepth));
    for (const glm::dvec3& p : box.vertices()) outline.push_back(inPicture(frame, p));
  }
  return outline;
}

/// All objects in the picture, within `limit` if that is not null.
Outline clusterOutline(const LightFrame& frame, const std::vector<Seen>& objects, const Outline* limit,
                       double nearDepth) {
  Outline all;
  for (const Seen& object : objects) {
    const Outline outline = objectOutline(frame, object, nearDepth);
    if (outline.empty()) continue;
    append(all, limit ? clipOutline(planarHull(outline), *limit) : planarHull(outline));
  }
  return all.empty() ? all : planarHull(all);
}

struct Rectangle {
  glm::dvec2 center{0.0}, half{0.0};
  glm::dvec2 side{1, 0};  ///< unit, along the first of `half`
};

/// The smallest rectangle around a convex outline has a side along one of its edges.
Rectangle smallestRectangle(const Outline& outline) {
  Rectangle best;
  double least = INFINITY;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 edge = outline[(i + 1) % outline.size()] - outline[i];
    if (i > 0 && glm::length(edge) <= 1e-12 * glm::length(outline[i])) continue;
    const glm::dvec2 u = glm::length(edge) > 0.0 ? glm::normalize(edge) : glm::dvec2(1, 0), v(-u.y, u.x);
    glm::dvec2 low(INFINITY), high(-INFINITY);
    for (const glm::dvec2& p : outline) {
      const glm::dvec2 q(glm::dot(u, p), glm::dot(v, p));
      low = glm::min(low, q);
      high = glm::max(high, q);
    }
    const glm::dvec2 size = high - low;
    if (size.x * size.y >= least) continue;
    least = size.x * size.y;
    const glm::dvec2 middle = 0.5 * (low + high);
    best = {middle.x * u + middle.y * v, 0.5 * size, u};
  }
  const double wide = std::max({best.half.x, best.half.y, 1e-9});
  best.half = glm::max(best.half, glm::dvec2(kNarrowest * wide));
  return best;
}

/// Tangent of the angle halfway between both ends of what reaches `half` to either side. The middle of a wide cone's
/// tangents is so near to the wider end that the other one would be behind a camera turned to it.
double middleTangent(double center, double half) {
  return std::tan(0.5 * (std::atan(center - half) + std::atan(center + half)));
}

/// The frame turned so that its axis goes through the middle of the rectangle and its picture lies along the sides.
LightFrame turned(const LightFrame& frame, const Rectangle& to) {
  LightFrame next = frame;
  const glm::dvec2 other2(-to.side.y, to.side.x);
  const glm::dvec3 side = to.side.x * frame.right + to.side.y * frame.down;
  const glm::dvec3 other = other2.x * frame.right + other2.y * frame.down;
  if (!frame.parallel)
    next.axis = glm::normalize(frame.axis + middleTangent(glm::dot(to.center, to.side), to.half.x) * side +
                               middleTangent(glm::dot(to.center, other2), to.half.y) * other);
  next.right = glm::normalize(side - glm::dot(side, next.axis) * next.axis);
  next.down = glm::cross(next.axis, next.right);
  return next;
}

/// Depths of the nearest point, of cutting meshes too, and of the farthest one.
std::pair<double, double> depthRange(const LightFrame& frame, const std::vector<Seen>& objects) {
  double low = INFINITY, high = -INFINITY;
  for (const Seen& object : objects) {
    for (const glm::dvec3& p : object.points) {
      const double depth = inFrame(frame, p).z;
      low = std::min(low, depth);
      high = std::max(high, depth);
    }
    for (const glm::dvec3& p : object.cut) low = std::min(low, inFrame(frame, p).z);
  }
  return {low, high};
}

/// The camera around an outline of the frame's picture.
MapView viewAround(LightFrame frame, Outline outline, const std::vector<Seen>& objects, double nearDepth, int mapSize) {
  Rectangle rectangle = smallestRectangle(outline);
  const int turns = frame.parallel ? 1 : kTurns;
  for (int i = 0; i < turns; ++i) {
    const LightFrame next = turned(frame, rectangle);
    Outline seen;
    for (const glm::dvec2& p : outline) {
      const glm::dvec3 way = p.x * frame.right + p.y * frame.down + (frame.parallel ? 0.0 : 1.0) * frame.axis;
      seen.push_back(inPicture(next, way + next.position));
    }
    outline = planarHull(seen);
    frame = next;
    rectangle = smallestRectangle(outline);
  }
  MapView map;
  const auto [nearest, farthest] = depthRange(frame, objects);
  map.farDepth = farthest;
  const glm::vec3 right(rectangle.side.x * frame.right + rectangle.side.y * frame.down);
  const glm::vec3 axis(frame.axis), unitRight = glm::normalize(right - glm::dot(right, axis) * axis);
  if (frame.parallel) {
    // the plane lies in front of everything by more than rounding
    const double margin = planeMargin(nearest, farthest);
    const glm::dvec3 eye = frame.position + rectangle.center.x * frame.right + rectangle.center.y * frame.down +
                           (nearest - margin) * frame.axis;
    map.view = scene::parallelView(glm::vec3(eye), axis, unitRight, withMargin(float(rectangle.half.x), mapSize),
                                   withMargin(float(rectangle.half.y), mapSize), mapSize, mapSize);
    map.nearDepth = margin;
    map.farDepth = farthest - nearest + margin;
    return map;
  }
  map.nearDepth = std::max(nearDepth, nearest * (1.0 - kNearMargin));
  // what is left of the turning goes to both sides
  const float tanX =
      withMargin(float(rectangle.half.x + std::abs(glm::dot(rectangle.center, rectangle.side))), mapSize);
  const glm::dvec2 other(-rectangle.side.y, rectangle.side.x);
  const float tanY = withMargin(float(rectangle.half.y + std::abs(glm::dot(rectangle.center, other))), mapSize);
  map.view = scene::perspectiveView(glm::vec3(frame.position), axis, -glm::cross(axis, unitRight), tanX, tanY, mapSize,
                                    mapSize, float(map.nearDepth));
  map.fovX = glm::degrees(2.0 * std::atan(double(tanX)));
  map.fovY = glm::degrees(2.0 * std::atan(double(tanY)));
  return map;
}

/// A frame that looks towards the middle of the objects as seen from an omni light, if one camera can see all of them.
std::optional<LightFrame> singleFrame(const Light& light, const std::vector<Seen>& objects, double nearDepth) {
  LightFrame frame;
  frame.position = light.position;
  glm::dvec3 sum(0.0);
  for (const Seen& object : objects)
    for (const glm::dvec3& corner : object.shape->corners) {
      const glm::dvec3 way = corner - frame.position;
      if (glm::length(way) > 0.0) sum += glm::normalize(way);
    }
  if (glm::length(sum) <= 1e-6) return std::nullopt;
  frame.axis = glm::normalize(sum);
  frame.tangent = kWidestTangent;
  completeFrame(frame);
  for (const Seen& object : objects)
    for (const glm::dvec3& p : object.points) {
      const glm::dvec3 q = inFrame(frame, p);
      if (q.z <= nearDepth || std::max(std::abs(q.x), std::abs(q.y)) > kWidestTangent * q.z) return std::nullopt;
    }
  return frame;
}

std::vector<MapView> omniViews(const Light& light, const std::vector<Seen>& objects, double nearDepth, int mapSize) {
  if (const auto frame = singleFrame(light, objects, nearDepth)) {
    const Outline outline = clusterOutline(*frame, objects, nullptr, nearDepth);
    return {viewAround(*frame, outline, objects, nearDepth, mapSize)};
  }
  std::vector<MapView> views;
  const std::vector<LightFrame> frames = lightFrames(light);
  for (std::size_t face = 0; face < frames.size(); ++face) {
    const Outline limit = pictureLimit(frames[face], false);
    const Outline outline = clusterOutline(frames[face], objects, &limit, nearDepth);
    if (outline.empty()) continue;
    views.push_back(viewAround(frames[face], outline, objects, nearDepth, mapSize));
    views.back().face = shared::uint(face);
  }
  return views;
}

scene::Bounds boundsOf(const std::vector<Caster>& shapes, const std::vector<unsigned>& objects) {
  scene::Bounds bounds;
  for (const unsigned object : objects)
    for (const glm::dvec3& corner : shapes[object].corners) bounds.add(glm::vec3(corner));
  return bounds;
}

}  // namespace

std::vector<MapView> focusedViews(const Scene& scene, const Light& light, const std::vector<Caster>& shapes,
                                  const std::vector<unsigned>& objects, int mapSize) {
  std::vector<Seen> seen;
  for (const unsigned object : objects) {
    seen.push_back({hullPoints(scene, shapes[object]), &shapes[object], {}});
    const scene::ObjectPlace place = scene::placeOf(scene, object);
    const int cutter = place.kind == scene::ObjectKind::Volume ? scene.volumes[place.index].boundary : -1;
    if (cutter >= 0) seen.back().cut = hullPoints(scene, shapes[std::size_t(cutter)]);
  }
  const double nearDepth = lightNearDepth(light, boundsOf(shapes, objects));
  if (light.type == LightType::Omni) return omniViews(light, seen, nearDepth, mapSize);
  const LightFrame frame = lightFrames(light).front();
  const bool spot = light.type == LightType::Spot;
  const Outline cone = spot ? pictureLimit(frame, true) : Outline();
  const Outline outline = clusterOutline(frame, seen, spot ? &cone : nullptr, nearDepth);
  if (outline.empty()) return {};
  return {viewAround(frame, outline, seen, nearDepth, mapSize)};
}

std::vector<MapView> wholeViews(const Light& light, const std::vector<Caster>& shapes,
                                const std::vector<unsigned>& objects, int mapSize) {
  const scene::Bounds bounds = boundsOf(shapes, objects);
  std::vector<MapView> maps;
  for (const shared::ViewData& view : lightViews(light, bounds, mapSize)) {
    MapView map;
    map.view = view;
    map.face = light.type == LightType::Omni ? shared::uint(maps.size()) : CDSM_FACE_ANY;
    map.fovX = map.fovY = mapFov(view);
    map.nearDepth = view.nearDepth;
    map.farDepth = farthestDepth(view, bounds);
    maps.push_back(map);
  }
  return maps;
}

}  // namespace cdsm::cluster
