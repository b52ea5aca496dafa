// SPDX-License-Identifier: Apache-2.0
// In: a scene and a ray. Out: the ray's homogeneous segments, in order: between two borders the same volumes and media
// are active [Knecht 2011, sec. 3.1.2].
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "grid.hpp"
#include "ray.hpp"

namespace cdsm::reference {

/// A scene made ready for double-precision rays. Where a function takes a World, a Scene may be given; make the World
/// once where many rays follow. Keeps a copy of the scene.
struct World {
  World(const Scene& scene);  // NOLINT: implicit on purpose
  Scene scene;
  std::vector<Surface> surfaces;  ///< by mesh index
  std::vector<Balls> balls;       ///< by index of spheres
  std::vector<Grid> grids;        ///< by volume index
};

struct Segment {
  double begin, end;            ///< t along the ray, begin < end
  std::vector<int> volumes;     ///< indices of the volumes that are active
  std::vector<int> media;       ///< indices of the meshes whose interior medium is active
  std::vector<Crossing> after;  ///< surfaces crossed at `end`
};

/// Segments from t = 0 to `length`, without gaps. Surfaces count strictly between: not those at either end.
std::vector<Segment> segmentsOf(const World& world, const Ray& ray, double length);

/// Of the mesh or the spheres that are crossed.
const Material& materialOf(const World& world, const Crossing& crossing);
const ShadowRole& roleOf(const World& world, const Crossing& crossing);

/// A t behind everything that the ray meets.
double behindAll(const World& world, const Ray& ray);

/// The number of equal steps in a segment: 1 without volumes; else with steps no longer than `step` world units.
int stepsIn(const Segment& segment, double step);

/// The shortest voxel edge among the segment's volumes in world units; infinite without one.
double smallestEdge(const World& world, const Segment& segment);

/// Sum of the extinctions of the segment's volumes and media at a point, 1 / world length.
double extinction(const World& world, const Segment& segment, const glm::dvec3& point);

/// The same for red, green and blue light on its way: all alike where shadows.transmittance is grey.
glm::dvec3 attenuation(const World& world, const Segment& segment, const glm::dvec3& point);

/// What is lost of the light's colours where something with this transmission interacts.
glm::dvec3 absorbed(const World& world, const glm::dvec3& transmission);

}  // namespace cdsm::reference
