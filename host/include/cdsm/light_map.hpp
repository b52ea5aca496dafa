// SPDX-License-Identifier: Apache-2.0
// A finished deep shadow map as plain values: how the light fades along the ray of each texel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace cdsm {

/// Transmittance of a texel's ray at a depth, which is the distance from the light's image plane along its axis.
struct MapNode {
  float depth;
  float transmittance;
};

/// One map of a light; those of its clusters are multiplied. Between two nodes of a texel transmittance is linear in
/// depth, in front of the first one it is 1, behind the last one it stays. Two nodes at the same depth are a surface,
/// as is a first node below 1. Depths ascend, transmittances never rise.
struct LightMap {
  int cluster = 0;
  int number = 0;                    ///< among the maps of its cluster
  std::vector<std::string> objects;  ///< names of what casts in it
  std::string side;    ///< of an omni light: "+x", "-x" ... "-z", the only points looked up in it; empty: all points
  float share = 1.0f;  ///< below 1 while clusters are handed over: of the set of maps with this share in the light
  int width = 0;       ///< texels
  int height = 0;
  float nearDepth = 0.0f;  ///< nothing in front of it attenuates
  float farDepth = 0.0f;   ///< of what casts in it
  float tolerance = 0.0f;  ///< that it was built at: larger than asked for if it was coarsened
  /// Homogeneous: x / w in [0, 1] from left to right, y / w from top to bottom, z / w from nearDepth to farDepth.
  glm::mat4 pictureFromWorld{1.0f};
  /// Left-handed: x to the right, y upwards, z is the depth. The origin is the light, or the middle of its image plane.
  glm::mat4 cameraFromWorld{1.0f};
  std::vector<std::uint32_t> firstNode;  ///< of texel y * width + x from the top left; one more at the end
  std::vector<MapNode> nodes;
  /// Of each node the transmittances of red, green and blue light, of which MapNode has the mean; empty where
  /// shadows.transmittance is grey.
  std::vector<glm::vec3> colors;
};

}  // namespace cdsm
