// SPDX-License-Identifier: Apache-2.0
// Views: the camera's, and a light's map, as rows and rays for the kernels (shared/view_data.h).
#pragma once

#include <cdsm/scene.hpp>

#include "shared/view_data.h"

namespace cdsm::scene {

/// An axis-aligned box in world space; empty as made.
struct Bounds {
  glm::vec3 low{INFINITY};
  glm::vec3 high{-INFINITY};

  void add(const glm::vec3& point);
  void add(const Bounds& other);
  bool contains(const glm::vec3& point) const;
  /// Length of the diagonal; 0 if empty.
  float diagonal() const;
};

/// In world space.
Bounds boundsOf(const MeshData& data, const glm::mat4& worldFromObject);
Bounds boundsOf(const SphereData& data, const glm::mat4& worldFromObject);

/// Of a matrix that scales all axes alike.
float scaleOf(const glm::mat4& matrix);

/// All that is drawn: meshes, the boxes of the volumes, spheres.
Bounds worldBounds(const Scene& scene);

/// World position of voxel coordinates of a volume.
glm::mat4 worldFromIndex(const Volume& volume);

/// A perspective view from `eye` towards `forward` (unit), `up` not parallel to it. tanX and tanY: half widths of the
/// picture at distance 1. `nearDepth` > 0: nothing nearer is seen.
shared::ViewData perspectiveView(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& up, float tanX,
                                 float tanY, int width, int height, float nearDepth);

/// A parallel view along `forward` from a plane, whose middle is `eye`. `right`: unit, at right angles to it. halfX and
/// halfY: half widths of the picture in world units. Nothing behind the plane is seen.
shared::ViewData parallelView(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& right, float halfX,
                              float halfY, int width, int height);

/// Nothing nearer to the camera than this is seen. `bounds`: of all that is drawn.
float cameraNearDepth(const Camera& camera, const Bounds& bounds);

/// The camera's view of `width` x `height` rays.
shared::ViewData cameraView(const Camera& camera, int width, int height, float nearDepth);

}  // namespace cdsm::scene
