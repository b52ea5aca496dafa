// SPDX-License-Identifier: Apache-2.0
// Homogeneous segments: every border is collected and sorted, what is active is decided at each segment's middle.
#include "segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace cdsm::reference {
namespace {

/// A surface nearer to the end than this part of the ray's length is the one that the end lies on.
constexpr double kSameSurface = 1e-8;

std::vector<Crossing> crossingsOf(const World& world, const Ray& ray) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    world.surfaces[i].addCrossings(ray, static_cast<int>(i), crossings);
  }
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    world.balls[i].addCrossings(ray, static_cast<int>(i), crossings);
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.t, a.mesh, a.triangle, a.spheres, a.sphere) <
           std::tie(b.t, b.mesh, b.triangle, b.spheres, b.sphere);
  });
  return crossings;
}

std::vector<Interval> boxesOf(const World& world, const Ray& ray) {
  std::vector<Interval> boxes;
  for (const Grid& grid : world.grids) boxes.push_back(grid.inside(ray));
  return boxes;
}

/// All borders in [0, length], ascending, each once.
std::vector<double> bordersOf(const std::vector<Crossing>& crossings, const std::vector<Interval>& boxes,
                              double length) {
  std::vector<double> borders{0.0, length};
  const auto add = [&](double t) {
    if (t > 0.0 && t < length) borders.push_back(t);
  };
  for (const Crossing& crossing : crossings) add(crossing.t);
  for (const Interval& box : boxes) {
    if (box.begin >= box.end) continue;
    add(box.begin);
    add(box.end);
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

void fillSegment(const World& world, const std::vector<Crossing>& crossings, const std::vector<Interval>& boxes,
                 Segment& segment) {
  const double middle = 0.5 * (segment.begin + segment.end);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const int boundary = world.scene.volumes[i].boundary;
    const bool inBox = boxes[i].begin < middle && middle < boxes[i].end;
    if (inBox && (boundary < 0 || windingNumber(crossings, boundary, middle) != 0)) {
      segment.volumes.push_back(static_cast<int>(i));
    }
  }
  for (std::size_t i = 0; i < world.scene.meshes.size(); ++i) {
    const int mesh = static_cast<int>(i);
    if (world.scene.meshes[i].interiorExtinction > 0.0f && windingNumber(crossings, mesh, middle) != 0) {
      segment.media.push_back(mesh);
    }
  }
}

}  // namespace

World::World(const Scene& scene_) : scene(scene_) {
  for (const Mesh& mesh : scene.meshes) surfaces.emplace_back(mesh);
  for (const Spheres& spheres : scene.spheres) balls.emplace_back(spheres);
  for (const Volume& volume : scene.volumes) grids.emplace_back(volume);
}

const Material& materialOf(const World& world, const Crossing& crossing) {
  const int material = crossing.mesh < 0 ? world.scene.spheres[static_cast<std::size_t>(crossing.spheres)].material
                                         : world.scene.meshes[static_cast<std::size_t>(crossing.mesh)].material;
  return world.scene.materials[static_cast<std::size_t>(material)];
}

const ShadowRole& roleOf(const World& world, const Crossing& crossing) {
  return crossing.mesh < 0 ? world.scene.spheres[static_cast<std::size_t>(crossing.spheres)].shadow
                           : world.scene.meshes[static_cast<std::size_t>(crossing.mesh)].shadow;
}

std::vector<Segment> segmentsOf(const World& world, const Ray& ray, double length) {
  const std::vector<Crossing> crossings = crossingsOf(world, ray);
  const std::vector<Interval> boxes = boxesOf(world, ray);
  const std::vector<double> borders = bordersOf(crossings, boxes, length);
  std::vector<Segment> segments;
  auto next = crossings.begin();
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    Segment segment{borders[i], borders[i + 1], {}, {}, {}};
    fillSegment(world, crossings, boxes, segment);
    while (next != crossings.end() && next->t <= segment.end && next->t < length * (1.0 - kSameSurface)) {
      segment.after.push_back(*next++);
    }
    segments.push_back(std::move(segment));
  }
  return segments;
}

double behindAll(const World& world, const Ray& ray) {
  double last = 0.0;
  for (const Crossing& crossing : crossingsOf(world, ray)) last = std::max(last, crossing.t);
  for (const Interval& box : boxesOf(world, ray)) {
    if (box.begin < box.end) last = std::max(last, box.end);
  }
  return last + 1.0;
}

int stepsIn(const Segment& segment, double step) {
  if (segment.volumes.empty()) return 1;
  return std::max(1, static_cast<int>(std::ceil((segment.end - segment.begin) / step)));
}

double smallestEdge(const World& world, const Segment& segment) {
  double edge = std::numeric_limits<double>::infinity();
  for (int volume : segment.volumes) {
    edge = std::min(edge, world.grids[static_cast<std::size_t>(volume)].smallestEdge());
  }
  return edge;
}

double extinction(const World& world, const Segment& segment, const glm::dvec3& point) {
  double sigma = 0.0;
  for (int volume : segment.volumes) sigma += world.grids[static_cast<std::size_t>(volume)].extinction(point);
  for (int mesh : segment.media) {
    sigma += static_cast<double>(world.scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction);
  }
  return sigma;
}

glm::dvec3 absorbed(const World& world, const glm::dvec3& transmission) {
  return world.scene.shadows.transmittance == "rgb" ? 1.0 - transmission : glm::dvec3(1.0);
}

glm::dvec3 attenuation(const World& world, const Segment& segment, const glm::dvec3& point) {
  glm::dvec3 sum(0.0);
  for (int volume : segment.volumes) {
    const Grid& grid = world.grids[static_cast<std::size_t>(volume)];
    sum += grid.extinction(point) * absorbed(world, grid.transmission(point));
  }
  for (int index : segment.media) {
    const Mesh& mesh = world.scene.meshes[static_cast<std::size_t>(index)];
    sum += static_cast<double>(mesh.interiorExtinction) * absorbed(world, glm::dvec3(mesh.interiorTransmission));
  }
  return sum;
}

}  // namespace cdsm::reference
