// SPDX-License-Identifier: Apache-2.0
#include "cluster/cluster_plan.hpp"

#include <algorithm>
#include <cmath>

#include "scene/objects.hpp"

namespace cdsm::cluster {

namespace {

/// Points nearer to the light than this part of the scene's size have no place in its picture.
constexpr double kNearPart = 1e-4;
/// Of the outlines of volumes, whose shadows mostly fade out; of others 1.
constexpr double kVolumeSharpness = 0.25;
/// Of outlines that the camera does not see: they should not spoil the maps of what it sees.
constexpr double kHiddenSharpness = 1e-6;
/// An object that reaches through a plane by less than this part of the scene's size stands on it.
constexpr double kStandsPart = 1e-5;

/// One direction of a light: what matters there, and the space in which distances are measured.
struct Direction {
  LightFrame frame;
  ConvexBody reached;               ///< what of the scene the light reaches
  ConvexBody visible;               ///< B: what can have to do with shadows that the camera sees
  std::optional<LightSpace> space;  ///< none if the camera sees nothing that is lit
  double nearDepth = 0.0;
};

Direction makeDirection(const VisibleSpace& visible, const LightFrame& frame) {
  Direction direction;
  direction.frame = frame;
  direction.nearDepth = kNearPart * std::max(double(visible.scene.diagonal()), 1e-20);
  direction.reached = ConvexBody::box(visible.scene);
  direction.reached.clip(frustumOf(frame, 0.0));
  const ConvexBody body = bodyOf(visible, frame);
  direction.space = LightSpace::make(visible, frame, body);
  if (direction.space) direction.visible = body;
  return direction;
}

/// Corners of an object's box in front of the light, clipped to its frustum if some are behind it.
std::vector<glm::dvec3> reachedCorners(const Direction& direction, const Caster& shape) {
  const LightFrame& frame = direction.frame;
  const bool inFront = frame.parallel || std::all_of(shape.corners.begin(), shape.corners.end(), [&](const auto& p) {
                         return glm::dot(frame.axis, p - frame.position) > direction.nearDepth;
                       });
  if (inFront) return shape.corners;
  ConvexBody box = ConvexBody::hexahedron(shape.corners);
  box.clip(frustumOf(frame, direction.nearDepth));
  return box.vertices();
}

Extents extentsIn(const Direction& direction, const Caster& shape) {
  Extents extents;
  const LightFrame& frame = direction.frame;
  if (!direction.reached.mayTouch(shape.corners, {shape.normals.begin(), shape.normals.end()})) return extents;
  extents.squareLow = extents.pictureLow = glm::dvec2(INFINITY);
  extents.squareHigh = extents.pictureHigh = glm::dvec2(-INFINITY);
  extents.nearDepth = INFINITY;
  extents.farDepth = 0.0;
  for (const glm::dvec3& p : reachedCorners(direction, shape)) {
    const glm::dvec3 way = p - frame.position;
    glm::dvec2 picture(glm::dot(frame.right, way), glm::dot(frame.down, way));
    if (!frame.parallel) picture = glm::clamp(picture / glm::dot(frame.axis, way), -frame.tangent, frame.tangent);
    // without a camera's perspective the light's picture is as good as any
    const glm::dvec2 square = direction.space ? direction.space->project(p) : picture / frame.tangent;
    extents.squareLow = glm::min(extents.squareLow, square);
    extents.squareHigh = glm::max(extents.squareHigh, square);
    extents.pictureLow = glm::min(extents.pictureLow, picture);
    extents.pictureHigh = glm::max(extents.pictureHigh, picture);
    const double depth = direction.space ? direction.space->eyeDepth(p) : 1.0;
    extents.nearDepth = std::min(extents.nearDepth, depth);
    extents.farDepth = std::max(extents.farDepth, depth);
    extents.seen = true;
  }
  return extents;
}

/// True if the camera sees nothing of an object behind a flat one: what reaches through it lies under its lid.
bool hiddenBehind(const Caster& flat, double side, double stands, const Caster& other, const glm::dvec3& eye) {
  const auto height = [&](const glm::dvec3& p) { return side * flat.plane->distance(p); };
  if (std::all_of(other.corners.begin(), other.corners.end(), [&](const auto& p) { return height(p) >= -stands; }))
    return true;
  if (flat.lid.empty()) return false;
  ConvexBody behind = ConvexBody::hexahedron(other.corners);
  behind.clip({-side * flat.plane->normal, -side * flat.plane->offset});
  for (const glm::dvec3& p : behind.vertices()) {
    const glm::dvec3 seen = glm::mix(p, eye, std::max(-height(p), 0.0) / (height(eye) - std::min(height(p), 0.0)));
    for (const HalfSpace& edge : flat.lid)
      if (edge.distance(seen) < 0.0) return false;
  }
  return true;
}

/// True if a flat object has nothing behind it, as seen from the light, that the camera could see: a floor.
bool shadowsNothing(const Caster& flat, const std::vector<Caster>& shapes, const LightFrame& light,
                    const VisibleSpace& visible) {
  const double eye = flat.plane->distance(visible.eye);
  const double from = light.parallel ? -glm::dot(flat.plane->normal, light.axis) : flat.plane->distance(light.position);
  if (eye * from <= 0.0) return false;
  const double side = from > 0.0 ? 1.0 : -1.0, stands = kStandsPart * visible.scene.diagonal();
  return std::all_of(shapes.begin(), shapes.end(),
                     [&](const Caster& other) { return hiddenBehind(flat, side, stands, other, visible.eye); });
}

/// True if the camera cannot see any shadow of the object.
bool shadowIsHidden(const Caster& shape, const std::vector<Caster>& shapes, const std::vector<Direction>& directions,
                    const VisibleSpace& visible) {
  const std::vector<glm::dvec3> normals(shape.normals.begin(), shape.normals.end());
  return std::none_of(directions.begin(), directions.end(),
                      [&](const Direction& d) { return d.visible.mayTouch(shape.corners, normals); }) ||
         (shape.plane && shadowsNothing(shape, shapes, directions.front().frame, visible));
}

}  // namespace

LightPlan planLight(const Scene& scene, const Light& light, const std::vector<Caster>& shapes,
                    const VisibleSpace& visible, Purpose purpose) {
  if (shapes.empty()) return {};
  std::vector<Direction> directions;
  for (const LightFrame& frame : lightFrames(light)) directions.push_back(makeDirection(visible, frame));
  LightPlan plan;
  for (const Caster& shape : shapes) {
    if (!casts(scene, shape.object)) continue;
    const bool hidden = shadowIsHidden(shape, shapes, directions, visible);
    if (hidden && purpose == Purpose::Image) continue;
    ClusterItem item;
    item.weight = shape.weight;
    if (scene::placeOf(scene, shape.object).kind == scene::ObjectKind::Volume) item.sharpness = kVolumeSharpness;
    if (hidden) item.sharpness *= kHiddenSharpness;
    for (const Direction& direction : directions) item.directions.push_back(extentsIn(direction, shape));
    if (std::none_of(item.directions.begin(), item.directions.end(), [](const Extents& e) { return e.seen; })) continue;
    plan.items.push_back(std::move(item));
    plan.objects.push_back(shape.object);
  }
  std::vector<Cluster> formed =
      formClusters(plan.items, unsigned(scene.shadows.clusters), scene.shadows.clusterDistance);
  refineClusters(plan.items, formed);
  for (const Cluster& cluster : formed) {
    plan.clusters.emplace_back();
    for (const unsigned item : cluster) plan.clusters.back().push_back(plan.objects[item]);
    std::sort(plan.clusters.back().begin(), plan.clusters.back().end());
  }
  std::sort(plan.clusters.begin(), plan.clusters.end());
  return plan;
}

LightPlan planWithoutClusters(const Scene& scene, const std::vector<Caster>& shapes) {
  LightPlan plan;
  plan.clusters.emplace_back();
  for (const Caster& shape : shapes)
    if (casts(scene, shape.object)) plan.clusters.front().push_back(shape.object);
  return plan;
}

double errorOf(const LightPlan& plan, const LightClusters& clusters) {
  std::vector<Cluster> items;
  std::size_t count = 0;
  for (const auto& cluster : clusters) {
    items.emplace_back();
    for (const unsigned object : cluster) {
      const auto at = std::find(plan.objects.begin(), plan.objects.end(), object);
      if (at == plan.objects.end()) return INFINITY;
      items.back().push_back(unsigned(at - plan.objects.begin()));
      ++count;
    }
  }
  return count == plan.objects.size() ? expectedError(plan.items, items) : INFINITY;
}

}  // namespace cdsm::cluster
