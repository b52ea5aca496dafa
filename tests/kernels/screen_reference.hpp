// SPDX-License-Identifier: Apache-2.0
// Which triangles a pixel's ray meets, and where, in double precision: what the rasterizer is judged by.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "shared/view_data.h"

namespace cdsm::kernels {

/// A triangle of the scene as a pixel sees it.
struct Meeting {
  bool covers = false;      ///< the pixel's centre lies in the triangle's picture
  double edgePixels = 0.0;  ///< distance of the centre to the nearest edge of the picture, pixels
  double depth = 0.0;       ///< of the ray in the triangle's plane; as ViewData's
  double slant = 0.0;       ///< |cosine| of the angle between ray and normal
};

/// A view in double precision, and triangles cut at its near plane and projected.
class ScreenReference {
 public:
  ScreenReference(const shared::ViewData& view, const MeshData& mesh);

  std::size_t triangleCount() const { return pictures_.size(); }
  Meeting meet(std::size_t triangle, int x, int y) const;

 private:
  struct Picture {
    std::vector<glm::dvec2> corners;  ///< pixels; none: all of it is nearer than the near plane
    glm::dvec3 normal, corner;        ///< world; of length 1, of length 0 without area
  };
  Picture project(const glm::dvec3 corners[3]) const;

  glm::dmat4 rows_;  ///< transposed: pixel u * w, pixel v * w, depth, w
  glm::dvec3 origin_, dir_, dirU_, dirV_;
  double near_;
  std::vector<Picture> pictures_;
};

}  // namespace cdsm::kernels
