// SPDX-License-Identifier: Apache-2.0
// Brute-force transmittance: every ray against every triangle and every volume [INTERFACE 4.1 to 4.4].
#include <algorithm>
#include <cmath>

#include "reference.hpp"

namespace cdsm::reference {
namespace {

glm::dvec3 axisOf(const Light& light) { return glm::normalize(glm::dvec3(light.target) - glm::dvec3(light.position)); }

/// The segment without what casts no shadow; borders stay, so what does not cast still cuts.
Segment castingPart(const World& world, Segment segment) {
  const auto keepCasting = [](std::vector<int>& indices, const auto& objects) {
    std::vector<int> casting;
    for (const int i : indices)
      if (objects[static_cast<std::size_t>(i)].shadow.casts) casting.push_back(i);
    indices = casting;
  };
  keepCasting(segment.volumes, world.scene.volumes);
  keepCasting(segment.media, world.scene.meshes);
  return segment;
}

double stepOf(const World& world, const Segment& segment, double step) {
  if (step > 0.0) return step;
  if (step == kFineStep) return 0.25 * smallestEdge(world, segment);
  const auto given = static_cast<double>(world.scene.shadows.step);
  return given > 0.0 ? given : 0.5 * smallestEdge(world, segment);
}

/// Where the segment's surfaces interact with light, what of its colour gets through is not lost.
glm::dvec3 surfacesAfter(const World& world, const Segment& segment) {
  glm::dvec3 product(1.0);
  for (const Crossing& crossing : segment.after) {
    const Material& material = materialOf(world, crossing);
    if (!roleOf(world, crossing).casts) continue;
    product *= 1.0 - static_cast<double>(material.opacity) * absorbed(world, glm::dvec3(material.transmission));
  }
  return product;
}

/// Calls visit(t, T) at the end of every step and at every surface, in order; T: of red, green and blue light.
template <typename Visit>
void march(const World& world, const Ray& ray, double length, double step, Visit visit) {
  glm::dvec3 remaining(1.0);
  for (const Segment& whole : segmentsOf(world, ray, length)) {
    const Segment segment = castingPart(world, whole);
    const int steps = stepsIn(segment, stepOf(world, segment, step));
    const double h = (segment.end - segment.begin) / steps;
    for (int i = 0; i < steps; ++i) {
      remaining *= glm::exp(-attenuation(world, segment, ray.at(segment.begin + (i + 0.5) * h)) * h);
      visit(segment.begin + (i + 1.0) * h, remaining);
    }
    if (segment.after.empty()) continue;
    remaining *= surfacesAfter(world, segment);
    visit(segment.end, remaining);
  }
}

constexpr double kMostOpacity = 0.9999;

/// Whether a surface at the segment's end, or a sample of it, is more opaque than the threshold.
bool stops(const World& world, const Segment& segment, const Ray& ray, double threshold, double step) {
  for (const int mesh : segment.media) {
    const auto sigma = static_cast<double>(world.scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction);
    if (std::min(1.0 - std::exp(-sigma), kMostOpacity) > threshold) return true;
  }
  const int steps = stepsIn(segment, stepOf(world, segment, step));
  for (int i = 0; i < steps; ++i) {
    const glm::dvec3 point = ray.at(segment.begin + (i + 0.5) * (segment.end - segment.begin) / steps);
    for (const int volume : segment.volumes) {
      const auto index = static_cast<std::size_t>(volume);
      const double opacity = opacityAt(world.scene.volumes[index].transfer, world.grids[index].value(point));
      if (std::min(opacity, kMostOpacity) > threshold) return true;
    }
  }
  for (const Crossing& crossing : segment.after) {
    const auto opacity = static_cast<double>(materialOf(world, crossing).opacity);
    if (roleOf(world, crossing).casts && opacity > threshold) return true;
  }
  return false;
}

/// Where the ray to a point starts: the light, or behind all that the ray towards parallel light meets.
glm::dvec3 startOf(const World& world, const Light& light, const glm::dvec3& point) {
  if (light.type != LightType::Directional) return glm::dvec3(light.position);
  const Ray back{point, towardsLight(light, point)};
  return back.at(behindAll(world, back));
}

}  // namespace

bool lit(const Light& light, const glm::dvec3& point) {
  if (light.type != LightType::Spot) return true;
  const glm::dvec3 offset = point - glm::dvec3(light.position);
  const double cosine = glm::dot(offset, axisOf(light));
  return cosine >= std::cos(glm::radians(static_cast<double>(light.cutoff))) * glm::length(offset);
}

glm::dvec3 towardsLight(const Light& light, const glm::dvec3& point) {
  if (light.type == LightType::Directional) return -glm::normalize(glm::dvec3(light.direction));
  return glm::normalize(glm::dvec3(light.position) - point);
}

glm::dvec3 colorTransmittance(const World& world, const Light& light, const glm::dvec3& point, double step) {
  const glm::dvec3 position = startOf(world, light, point);
  const double distance = glm::length(point - position);
  glm::dvec3 result(1.0);
  if (distance == 0.0) return result;
  march(world, rayTowards(position, point), distance, step,
        [&](double, const glm::dvec3& remaining) { result = remaining; });
  return result;
}

double transmittance(const World& world, const Light& light, const glm::dvec3& point, double step) {
  const glm::dvec3 colors = colorTransmittance(world, light, point, step);
  return (colors.r + colors.g + colors.b) / 3.0;
}

double opaqueTransmittance(const World& world, const Light& light, const glm::dvec3& point, double threshold,
                           double step) {
  const glm::dvec3 position = startOf(world, light, point);
  const double distance = glm::length(point - position);
  if (distance == 0.0) return 1.0;
  const Ray ray = rayTowards(position, point);
  for (const Segment& segment : segmentsOf(world, ray, distance))
    if (stops(world, castingPart(world, segment), ray, threshold, step)) return 0.0;
  return 1.0;
}

Visibility visibility(const World& world, const Light& light, const glm::dvec3& direction, double step) {
  const Ray ray{glm::dvec3(light.position), glm::normalize(direction)};
  return visibility(world, ray, glm::dot(ray.direction, axisOf(light)), step);
}

Visibility visibility(const World& world, const Ray& ray, double depthPerT, double step, int channel) {
  Visibility result{{0.0, 1.0}};
  march(world, ray, behindAll(world, ray), step,
        [&](double t, const glm::dvec3& remaining) { result.emplace_back(t * depthPerT, remaining[channel]); });
  return result;
}

}  // namespace cdsm::reference
