// SPDX-License-Identifier: Apache-2.0
// The light space perspective transformation of one direction of a light [Knecht 2011, §2.4.2, §3.4.1, §4.5; Wimmer
// 2004], and the convex body of all that can have to do with visible shadows.
#pragma once

#include <optional>
#include <vector>

#include <cdsm/scene.hpp>

#include "cluster/convex_body.hpp"
#include "scene/view.hpp"

namespace cdsm::cluster {

/// Where one direction of a light looks: a spot's cone, one side of an omni light, parallel light.
struct LightFrame {
  bool parallel = false;
  glm::dvec3 position{0.0};                                 ///< not of parallel light
  glm::dvec3 right{1, 0, 0}, down{0, 1, 0}, axis{0, 0, 1};  ///< unit, at right angles
  double tangent = 1.0;  ///< half the width of the picture at distance 1; not of parallel light
};

/// One frame; six for an omni light, towards +x, -x, +y, -y, +z, -z.
std::vector<LightFrame> lightFrames(const Light& light);

/// Any unit vectors at right angles to each other and to `axis`.
void completeFrame(LightFrame& frame);

/// What the camera sees of the scene's box, and how near it comes: the visible part V and S [Knecht 2011, §2.4.2].
struct VisibleSpace {
  ConvexBody frustum;   ///< V, from the near plane to behind the scene
  scene::Bounds scene;  ///< S, and a little room around it
  glm::dvec3 eye{0.0}, forward{0, 0, -1};
  double nearDepth = 0.0;
};

/// `aspect`: width / height of the image; `nearDepth`: nothing nearer is seen.
VisibleSpace visibleSpace(const Camera& camera, double aspect, double nearDepth, const scene::Bounds& scene);

/// The four planes of the light's frustum, and the one behind which it is; none for parallel light.
std::vector<HalfSpace> frustumOf(const LightFrame& frame, double nearDepth);

/// B = hull of V and the light, within S and the light's frustum [Knecht 2011, Alg. 4.3; Wimmer 2004]: a caster outside
/// of it has no visible shadow.
ConvexBody bodyOf(const VisibleSpace& visible, const LightFrame& frame);

/// World points -> the square [-1, 1]^2 of a light space perspective shadow map.
class LightSpace {
 public:
  /// Nothing if the body is empty.
  static std::optional<LightSpace> make(const VisibleSpace& visible, const LightFrame& frame, const ConvexBody& body);

  /// Points must not lie behind the light; ones that the perspective cannot reach end up at the edge of [-3, 3]^2.
  glm::dvec2 project(const glm::dvec3& world) const;

  /// Depth before the camera of what the light ray through a point meets there, about: it grows along the axis that the
  /// camera looks along in the light's picture. Between the nearest and the farthest depth of what is seen.
  double eyeDepth(const glm::dvec3& world) const;

 private:
  glm::dvec3 toLight(const glm::dvec3& world) const;

  LightFrame frame_;
  glm::dvec2 along_{0, 1}, across_{1, 0};  ///< axes z and x of the light space, in the light's picture
  double nearest_ = 0.0, depth_ = 1.0;     ///< of the body along z: least, and extent
  double reference_ = 0.0;                 ///< n: from the reference point to the near plane; infinite: no perspective
  double nearEye_ = 1.0, farEye_ = 1.0;    ///< depths before the camera of what is seen
  double center_ = 0.0;                    ///< x of the reference point
  double low_ = -1.0, high_ = 1.0;         ///< of the body along x, on the near plane
};

}  // namespace cdsm::cluster
