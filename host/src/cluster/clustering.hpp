// SPDX-License-Identifier: Apache-2.0
// Objects -> clusters, by their distances in light space [Knecht 2011, §3.4.1, Alg. 4.2].
#pragma once

#include <vector>

#include "cluster/casters.hpp"
#include "cluster/light_space.hpp"

namespace cdsm::cluster {

/// What one direction of a light sees of an object. Coordinates of `square` are of the light space perspective
/// [-1, 1]^2, of `picture` of the light's own picture (tangents; world units of parallel light).
struct Extents {
  bool seen = false;
  glm::dvec2 squareLow{0.0}, squareHigh{0.0};
  glm::dvec2 pictureLow{0.0}, pictureHigh{0.0};
  double nearDepth = 1.0, farDepth = 1.0;  ///< from the camera, of its shadow
};

/// An object as clustering sees it: its extents in each direction of the light.
struct ClusterItem {
  double weight = 1.0;
  double sharpness = 1.0;  ///< of its shadow's outline: less for what is soft at its border
  std::vector<Extents> directions;
};

/// The greater of the distances between the least and between the greatest corners, the greatest over all directions;
/// times the greater weight. Objects that no direction sees together are as far apart as the square allows.
double itemDistance(const ClusterItem& a, const ClusterItem& b);

/// Numbers of items.
using Cluster = std::vector<unsigned>;

/// Knecht's algorithm: every item in exactly one of at most `most` clusters, in which no two are farther apart than
/// `distance` unless there are not enough clusters.
std::vector<Cluster> formClusters(const std::vector<ClusterItem>& items, unsigned most, double distance);

/// What is to be expected of the shadows' error in the image, up to a factor: the lengths of the items' outlines times
/// the widths of the texels that they are drawn with, both as large as the camera sees them. The squared RMS error
/// grows with it.
double expectedError(const std::vector<ClusterItem>& items, const std::vector<Cluster>& clusters);

/// Clusters of less expected error, as many as there are or fewer: those given, and items merged two by two, both with
/// items moved as long as that helps; the better of the two. Very large objects come apart from small ones by this
/// [Knecht 2011, §6.1].
void refineClusters(const std::vector<ClusterItem>& items, std::vector<Cluster>& clusters);

}  // namespace cdsm::cluster
