// SPDX-License-Identifier: Apache-2.0
// Deep EXR files as other programs see them: read through OpenImageIO, without the library.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace cdsm::property {

/// Transmittance falls linearly by the factor 1 - alpha from z to zBack.
struct DeepSample {
  float z, zBack, alpha;
};

struct DeepPart {
  std::string name, side;
  int width = 0, height = 0, tileWidth = 0;
  glm::dmat4 ndcFromWorld{1.0}, cameraFromWorld{1.0};
  std::vector<std::vector<DeepSample>> texels;

  /// World point on the ray of a texel's centre.
  glm::dvec3 worldPoint(int x, int y, double depth) const;
  double depthOf(const glm::dvec3& point) const;
  /// Number of the texel that a point falls into, -1 if none; `offCentre`: how far, 0.5 at the texel's border.
  int texelOf(const glm::dvec3& point, double& offCentre) const;
  /// Transmittance in front of a depth.
  double transmittance(int texel, double depth) const;
};

std::vector<DeepPart> readDeepParts(const std::string& path);

/// Channel A of each part of a file without depth.
std::vector<std::vector<float>> readFlatAlphas(const std::string& path);

}  // namespace cdsm::property
