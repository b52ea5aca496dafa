// SPDX-License-Identifier: Apache-2.0
// Projection and rays in double precision.
#include "screen_reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdsm::kernels {
namespace {

glm::dvec4 wide(const shared::float4& v) { return {v.x, v.y, v.z, v.w}; }

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 d = b - a;
  const double squared = glm::dot(d, d);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * d);
}

}  // namespace

ScreenReference::ScreenReference(const shared::ViewData& view, const MeshData& mesh)
    : rows_(wide(view.pixelU), wide(view.pixelV), wide(view.depth), wide(view.pixelW)),
      origin_(wide(view.origin)),
      dir_(wide(view.dir)),
      dirU_(wide(view.dirU)),
      dirV_(wide(view.dirV)),
      near_(view.nearDepth) {
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 corners[] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    pictures_.push_back(project(corners));
  }
}

ScreenReference::Picture ScreenReference::project(const glm::dvec3 corners[3]) const {
  Picture picture;
  picture.corner = corners[0];
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  picture.normal = glm::length(normal) > 0.0 ? glm::normalize(normal) : glm::dvec3(0.0);
  std::vector<glm::dvec4> seen;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4 p = glm::dvec4(corners[i], 1.0) * rows_, q = glm::dvec4(corners[(i + 1) % 3], 1.0) * rows_;
    if (p.z >= near_) seen.push_back(p);
    if ((p.z >= near_) != (q.z >= near_)) seen.push_back(p + (q - p) * ((near_ - p.z) / (q.z - p.z)));
  }
  for (const glm::dvec4& p : seen) picture.corners.emplace_back(p.x / p.w, p.y / p.w);
  return picture;
}

Meeting ScreenReference::meet(std::size_t triangle, int x, int y) const {
  const Picture& picture = pictures_[triangle];
  const glm::dvec2 centre(x + 0.5, y + 0.5);
  const std::size_t count = picture.corners.size();
  Meeting meeting;
  meeting.edgePixels = std::numeric_limits<double>::infinity();
  int left = 0, right = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2& a = picture.corners[i];
    const glm::dvec2& b = picture.corners[(i + 1) % count];
    (cross(b - a, centre - a) > 0.0 ? left : right) += 1;
    meeting.edgePixels = std::min(meeting.edgePixels, distanceToSegment(centre, a, b));
  }
  meeting.covers = count >= 3 && (left == 0 || right == 0);
  const glm::dvec3 ray = dir_ + centre.x * dirU_ + centre.y * dirV_;
  const double along = glm::dot(picture.normal, ray);
  meeting.slant = std::abs(along) / glm::length(ray);
  meeting.depth = glm::dot(picture.normal, picture.corner - origin_) / along;
  return meeting;
}

}  // namespace cdsm::kernels
