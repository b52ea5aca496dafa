// SPDX-License-Identifier: Apache-2.0
// One camera ray, front to back, with brute-force shadows at every sample [Knecht 2011, eqs. 3.9 to 3.11].
#include <algorithm>
#include <cmath>

#include "reference.hpp"

namespace cdsm::reference {
namespace {

/// Steps of a segment that holds interior media alone: their light may vary although they do not.
constexpr int kMediumSteps = 64;

struct Phong {
  glm::dvec3 diffuse;   ///< k_d and k_a
  glm::dvec3 specular;  ///< k_s
  double shininess;
  glm::dvec3 normal;  ///< of unit length; 0: lit from everywhere alike
  bool receives;      ///< what is left of the light; false: all of it
};

struct Accumulated {
  glm::dvec3 color{0.0};
  double transparency = 1.0;

  void add(const glm::dvec3& sample, double opacity) {
    color += transparency * opacity * sample;
    transparency *= 1.0 - opacity;
  }
};

glm::dvec3 remainingAt(const World& world, const Light& light, const glm::dvec3& point, bool receives) {
  if (!lit(light, point)) return glm::dvec3(0.0);
  const ShadowSettings& shadows = world.scene.shadows;
  if (!receives || shadows.technique == "none") return glm::dvec3(1.0);
  const bool opaque =
      shadows.technique == "shadow-map" || (shadows.technique == "shadow-rays" && shadows.rays == "opaque");
  if (opaque)
    return glm::dvec3(opaqueTransmittance(world, light, point, static_cast<double>(shadows.threshold), kEngineStep));
  return colorTransmittance(world, light, point);
}

/// What one light without a shadow adds; `view` points to the camera.
glm::dvec3 reflected(const Phong& phong, const Light& light, const glm::dvec3& point, const glm::dvec3& view) {
  const glm::dvec3 intensity(light.color);
  if (phong.normal == glm::dvec3(0.0)) return phong.diffuse * intensity;
  const glm::dvec3 way = towardsLight(light, point);
  const double cosine = glm::dot(way, phong.normal);
  const glm::dvec3 reflection = 2.0 * cosine * phong.normal - way;  // the same for either side's normal
  const double highlight = std::pow(std::max(glm::dot(reflection, view), 0.0), phong.shininess);
  return (phong.diffuse * std::abs(cosine) + phong.specular * highlight) * intensity;
}

glm::dvec3 shade(const World& world, const Phong& phong, const glm::dvec3& point, const glm::dvec3& view) {
  glm::dvec3 color = phong.diffuse * glm::dvec3(world.scene.image.ambient);
  for (const Light& light : world.scene.lights) {
    const glm::dvec3 remaining = remainingAt(world, light, point, phong.receives);
    if (remaining != glm::dvec3(0.0)) color += remaining * reflected(phong, light, point, view);
  }
  return color;
}

glm::dvec3 shadeVolume(const World& world, int index, const glm::dvec3& point, const glm::dvec3& view) {
  const Volume& volume = world.scene.volumes[static_cast<std::size_t>(index)];
  const Grid& grid = world.grids[static_cast<std::size_t>(index)];
  const glm::dvec3 normal = volume.shading ? grid.normal(point) : glm::dvec3(0.0);
  const Phong phong{grid.color(point), glm::dvec3(volume.specular), volume.shininess, normal, volume.shadow.receives};
  return shade(world, phong, point, view);
}

/// Colour of a sample: those of all that is active, weighted by extinction.
glm::dvec3 shadeSample(const World& world, const Segment& segment, const glm::dvec3& point, const glm::dvec3& view) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int volume : segment.volumes) {
    const double sigma = world.grids[static_cast<std::size_t>(volume)].extinction(point);
    if (sigma > 0.0) sum += sigma * shadeVolume(world, volume, point, view);
    weights += sigma;
  }
  for (int index : segment.media) {
    const Mesh& mesh = world.scene.meshes[static_cast<std::size_t>(index)];
    const auto sigma = static_cast<double>(mesh.interiorExtinction);
    const Phong phong{glm::dvec3(mesh.interiorColor), glm::dvec3(0.0), 1.0, glm::dvec3(0.0), mesh.shadow.receives};
    sum += sigma * shade(world, phong, point, view);
    weights += sigma;
  }
  return weights > 0.0 ? sum / weights : sum;
}

int cameraSteps(const World& world, const Segment& segment) {
  if (segment.volumes.empty()) return segment.media.empty() ? 0 : kMediumSteps;
  const auto given = static_cast<double>(world.scene.shadows.step);
  return stepsIn(segment, given > 0.0 ? given : 0.5 * smallestEdge(world, segment));
}

void addSegment(const World& world, const Ray& ray, const Segment& segment, Accumulated& pixel) {
  const int steps = cameraSteps(world, segment);
  const double h = (segment.end - segment.begin) / std::max(steps, 1);
  for (int i = 0; i < steps; ++i) {
    const glm::dvec3 point = ray.at(segment.begin + (i + 0.5) * h);
    const double sigma = extinction(world, segment, point);
    if (sigma > 0.0) pixel.add(shadeSample(world, segment, point, -ray.direction), 1.0 - std::exp(-sigma * h));
  }
}

/// Spheres may have colours of their own.
glm::dvec3 diffuseOf(const World& world, const Crossing& crossing) {
  if (crossing.mesh < 0) {
    const SphereData& data = *world.scene.spheres[static_cast<std::size_t>(crossing.spheres)].data;
    if (!data.colors.empty()) return glm::dvec3(data.colors[static_cast<std::size_t>(crossing.sphere)]);
  }
  return glm::dvec3(materialOf(world, crossing).diffuse);
}

void addSurface(const World& world, const Ray& ray, const Crossing& crossing, Accumulated& pixel) {
  const Material& material = materialOf(world, crossing);
  if (material.opacity <= 0.0f) return;
  const glm::dvec3 point = ray.at(crossing.t);
  const glm::dvec3 normal = crossing.mesh < 0
                                ? world.balls[static_cast<std::size_t>(crossing.spheres)].normal(crossing, point)
                                : world.surfaces[static_cast<std::size_t>(crossing.mesh)].normal(crossing);
  const Phong phong{diffuseOf(world, crossing), glm::dvec3(material.specular), material.shininess, normal,
                    roleOf(world, crossing).receives};
  pixel.add(shade(world, phong, point, -ray.direction), material.opacity);
}

}  // namespace

Ray cameraRay(const Scene& scene, double px, double py) {
  const glm::dvec3 position(scene.camera.position);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(scene.camera.target) - position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(scene.camera.up)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double halfHeight = std::tan(0.5 * glm::radians(static_cast<double>(scene.camera.fov)));
  const double halfWidth = halfHeight * scene.image.width / scene.image.height;
  const double x = (2.0 * px / scene.image.width - 1.0) * halfWidth;
  const double y = (1.0 - 2.0 * py / scene.image.height) * halfHeight;
  return {position, glm::normalize(forward + x * right + y * up)};
}

glm::dvec4 pixel(const World& world, double px, double py) {
  const Ray ray = cameraRay(world.scene, px, py);
  Accumulated result;
  for (const Segment& segment : segmentsOf(world, ray, behindAll(world, ray))) {
    addSegment(world, ray, segment, result);
    for (const Crossing& crossing : segment.after) addSurface(world, ray, crossing, result);
    if (result.transparency <= 0.0) break;
  }
  const glm::dvec3 color = result.color + result.transparency * glm::dvec3(world.scene.image.background);
  return glm::dvec4(color, 1.0 - result.transparency);
}

}  // namespace cdsm::reference
