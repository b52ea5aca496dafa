// SPDX-License-Identifier: Apache-2.0
#include "cluster/light_space.hpp"

#include <algorithm>
#include <cmath>

namespace cdsm::cluster {

namespace {

/// Objects nearer to the light than this part of the scene's size do not take part in the perspective.
constexpr double kNearPart = 1e-4;
/// How far outside of the square [-1, 1]^2 a point may end up.
constexpr double kFarthest = 3.0;
/// Part of the way from the reference point to the near plane, nearer than which points count as this near.
constexpr double kNearestPart = 0.1;

/// The scene's box is larger by this part of its size, and of its place: corners of boxes have been rounded, and a
/// scene may be flat.
constexpr float kRoomPart = 1e-4f, kRoundingPart = 1e-6f;

scene::Bounds withRoom(scene::Bounds bounds) {
  if (bounds.low.x > bounds.high.x) return bounds;
  const float farthest = std::max(glm::length(bounds.low), glm::length(bounds.high));
  const glm::vec3 room(std::max({kRoomPart * bounds.diagonal(), kRoundingPart * farthest, 1e-20f}));
  bounds.low -= room;
  bounds.high += room;
  return bounds;
}

double clampToSquare(double x) { return std::clamp(x, -kFarthest, kFarthest); }

}  // namespace

void completeFrame(LightFrame& frame) {
  const glm::dvec3 up = std::abs(frame.axis.y) > 0.99 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  frame.right = glm::normalize(glm::cross(frame.axis, up));
  frame.down = glm::cross(frame.axis, frame.right);
}

std::vector<LightFrame> lightFrames(const Light& light) {
  LightFrame frame;
  frame.parallel = light.type == LightType::Directional;
  frame.position = light.position;
  if (light.type == LightType::Omni) {
    std::vector<LightFrame> frames;
    for (int face = 0; face < 6; ++face) {
      frame.axis = glm::dvec3(0.0);
      frame.axis[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
      completeFrame(frame);
      frames.push_back(frame);
    }
    return frames;
  }
  frame.axis = glm::normalize(glm::dvec3(frame.parallel ? light.direction : light.target - light.position));
  if (!frame.parallel) frame.tangent = std::tan(glm::radians(double(light.cutoff)));
  completeFrame(frame);
  return {frame};
}

VisibleSpace visibleSpace(const Camera& camera, double aspect, double nearDepth, const scene::Bounds& scene) {
  VisibleSpace visible;
  visible.scene = withRoom(scene);
  visible.eye = camera.position;
  visible.forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position));
  visible.nearDepth = nearDepth;
  const glm::dvec3 right = glm::normalize(glm::cross(visible.forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, visible.forward);
  const double tanY = std::tan(glm::radians(double(camera.fov)) * 0.5), tanX = tanY * aspect;
  double farDepth = 2.0 * nearDepth;
  for (const glm::dvec3& corner : ConvexBody::box(visible.scene).vertices())
    farDepth = std::max(farDepth, 1.001 * glm::dot(corner - visible.eye, visible.forward));
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    const double depth = i >> 2 ? farDepth : nearDepth;
    corners.push_back(visible.eye +
                      depth * (visible.forward + (i & 1 ? tanX : -tanX) * right + (i >> 1 & 1 ? tanY : -tanY) * up));
  }
  visible.frustum = ConvexBody::hexahedron(corners);
  return visible;
}

std::vector<HalfSpace> frustumOf(const LightFrame& frame, double nearDepth) {
  if (frame.parallel) return {};
  std::vector<HalfSpace> sides{halfSpace(frame.axis, frame.position + nearDepth * frame.axis)};
  for (const double sign : {-1.0, 1.0}) {
    sides.push_back(halfSpace(frame.tangent * frame.axis + sign * frame.right, frame.position));
    sides.push_back(halfSpace(frame.tangent * frame.axis + sign * frame.down, frame.position));
  }
  return sides;
}

ConvexBody bodyOf(const VisibleSpace& visible, const LightFrame& frame) {
  const double size = visible.scene.diagonal();
  ConvexBody body = visible.frustum;
  if (frame.parallel) {
    // as far as the scene may reach from anywhere in the frustum
    double reach = size;
    for (const glm::dvec3& p : body.vertices())
      reach = std::max(reach, size + glm::distance(p, glm::dvec3(visible.scene.low)));
    body = body.sweptAlong(-reach * frame.axis);
  } else {
    body = body.hullWith(frame.position);
  }
  body.clip(ConvexBody::box(visible.scene).halfSpaces());
  body.clip(frustumOf(frame, 0.0));
  return body;
}

glm::dvec3 LightSpace::toLight(const glm::dvec3& world) const {
  const glm::dvec3 way = world - frame_.position;
  const double x = glm::dot(frame_.right, way), y = glm::dot(frame_.down, way), z = glm::dot(frame_.axis, way);
  return frame_.parallel ? glm::dvec3(x, y, z) : glm::dvec3(x / z, y / z, z);
}

std::optional<LightSpace> LightSpace::make(const VisibleSpace& visible, const LightFrame& frame,
                                           const ConvexBody& body) {
  LightSpace space;
  space.frame_ = frame;
  ConvexBody lit = body;
  lit.clip(frustumOf(frame, kNearPart * std::max(double(visible.scene.diagonal()), 1e-20)));
  ConvexBody seen = lit;
  seen.clip(visible.frustum.halfSpaces());
  if (seen.empty()) return std::nullopt;

  // the point of the body next to the camera, and the way the camera looks from there, in the light's picture
  const auto depthOf = [&](const glm::dvec3& p) { return glm::dot(p - visible.eye, visible.forward); };
  const std::vector<glm::dvec3> corners = seen.vertices();
  const auto [nearest, farthest] = std::minmax_element(
      corners.begin(), corners.end(), [&](const auto& a, const auto& b) { return depthOf(a) < depthOf(b); });
  const double nearDepth = std::max(depthOf(*nearest), visible.nearDepth);
  const double farDepth = std::max(depthOf(*farthest), nearDepth);
  space.nearEye_ = nearDepth;
  space.farEye_ = farDepth;
  const glm::dvec3 start = space.toLight(*nearest);
  const double step = 1e-3 * std::max(farDepth - nearDepth, nearDepth);
  const glm::dvec2 view = glm::dvec2(space.toLight(*nearest + step * visible.forward)) - glm::dvec2(start);
  const bool slanted = glm::length(view) > 1e-6 * step / (frame.parallel ? 1.0 : start.z);
  if (slanted) space.along_ = glm::normalize(view);
  space.across_ = {space.along_.y, -space.along_.x};

  double high = -INFINITY, low = INFINITY;
  for (const glm::dvec3& p : lit.vertices()) {
    const double z = glm::dot(space.along_, glm::dvec2(space.toLight(p)));
    low = std::min(low, z);
    high = std::max(high, z);
  }
  space.nearest_ = low;
  space.depth_ = std::max(high - low, 1e-300);
  space.center_ = glm::dot(space.across_, glm::dvec2(start));
  // n = d / (sqrt(zf / zn) - 1), which is zn + sqrt(zf zn) where the view is at right angles to the light
  const double warp = std::sqrt(std::max(farDepth / nearDepth, 1.0)) - 1.0;
  space.reference_ = slanted && warp > 1e-6 ? space.depth_ / warp : INFINITY;
  space.low_ = INFINITY;
  space.high_ = -INFINITY;
  for (const glm::dvec3& p : lit.vertices()) {
    const glm::dvec3 q = space.toLight(p);
    const double z = glm::dot(space.along_, glm::dvec2(q)) - low;
    const double x = glm::dot(space.across_, glm::dvec2(q)) - space.center_;
    const double onNear = std::isinf(space.reference_) ? x : x * space.reference_ / (z + space.reference_);
    space.low_ = std::min(space.low_, onNear);
    space.high_ = std::max(space.high_, onNear);
  }
  return space;
}

glm::dvec2 LightSpace::project(const glm::dvec3& world) const {
  const glm::dvec2 q(toLight(world));
  const double z = glm::dot(along_, q) - nearest_, x = glm::dot(across_, q) - center_;
  const double width = std::max(high_ - low_, 1e-300);
  if (std::isinf(reference_))
    return {clampToSquare(2.0 * (x - low_) / width - 1.0), clampToSquare(2.0 * z / depth_ - 1.0)};
  const double n = reference_, f = n + depth_;
  const double away = std::max(z + n, kNearestPart * n);  // from the reference point
  return {clampToSquare(2.0 * (x * n / away - low_) / width - 1.0),
          clampToSquare((f + n) / depth_ - 2.0 * f * n / (depth_ * away))};
}

double LightSpace::eyeDepth(const glm::dvec3& world) const {
  const double part = (glm::dot(along_, glm::dvec2(toLight(world))) - nearest_) / depth_;
  return glm::mix(nearEye_, farEye_, std::clamp(part, 0.0, 1.0));
}

}  // namespace cdsm::cluster
