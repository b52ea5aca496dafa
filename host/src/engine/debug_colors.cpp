// SPDX-License-Identifier: Apache-2.0
#include "engine/debug_colors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/objects.hpp"

namespace cdsm::engine {

namespace {

/// Of what casts in no cluster.
constexpr glm::vec3 kNoCluster(0.45f);

/// Number of the cluster that each object of the scene casts in, or kNothing; `light` is number of their light.
std::vector<std::int64_t> clusterOfObjects(const Scene& scene, const std::vector<technique::MapCluster>& clusters,
                                           std::size_t light) {
  std::vector<std::int64_t> numbers(scene::objectCount(scene), kNothing);
  for (const technique::MapCluster& cluster : clusters) {
    if (cluster.light != light || cluster.former) continue;
    for (const unsigned object : cluster.objects) numbers[object] = cluster.number;
  }
  return numbers;
}

/// Linear RGB of Oklab's lightness, chroma and hue (radians) [Ottosson 2020].
glm::vec3 colorOfOklab(float lightness, float chroma, float hue) {
  const float a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const glm::vec3 cones(lightness + 0.3963377774f * a + 0.2158037573f * b,
                        lightness - 0.1055613458f * a - 0.0638541728f * b,
                        lightness - 0.0894841775f * a - 1.2914855480f * b);
  const glm::vec3 c = cones * cones * cones;
  return {4.0767416621f * c.x - 3.3077115913f * c.y + 0.2309699292f * c.z,
          -1.2684380046f * c.x + 2.6097574011f * c.y - 0.3413193965f * c.z,
          -0.0041960863f * c.x - 0.7034186147f * c.y + 1.7076147010f * c.z};
}

}  // namespace

glm::vec3 clusterColor(unsigned number) {
  // the colours of Okabe and Ito, wine in place of black
  static const std::array<glm::vec3, 8> colors{{{0.0f, 0.168f, 0.445f},
                                                {0.791f, 0.347f, 0.0f},
                                                {0.0f, 0.342f, 0.171f},
                                                {0.604f, 0.191f, 0.386f},
                                                {0.871f, 0.776f, 0.054f},
                                                {0.093f, 0.456f, 0.815f},
                                                {0.665f, 0.112f, 0.0f},
                                                {0.246f, 0.016f, 0.091f}}};
  return colors[number % colors.size()];
}

glm::vec3 scaleColor(float part) {
  const float t = std::clamp(part, 0.0f, 1.0f), fromMiddle = 2.0f * t - 1.0f;
  const float lightness = 0.28f + 0.64f * t, hue = glm::radians(310.0f - 205.0f * t);
  // as colourful as the display's greens in the middle and its violets and yellows at the ends allow
  const float chroma = 0.1f + 0.03f * fromMiddle * fromMiddle;
  return glm::clamp(colorOfOklab(lightness, chroma, hue), 0.0f, 1.0f);
}

Scene inClusterColors(Scene scene, const std::vector<technique::MapCluster>& clusters, std::size_t light) {
  const std::vector<std::int64_t> numbers = clusterOfObjects(scene, clusters, light);
  const auto colorOf = [&](std::size_t object) {
    return numbers[object] == kNothing ? kNoCluster : clusterColor(unsigned(numbers[object]));
  };
  std::vector<Material> materials;
  const auto paint = [&](int& index, const glm::vec3& color) {
    Material material = scene.materials[index];
    material.diffuse = color;
    material.specular = glm::vec3(0.0f);
    index = int(materials.size());
    materials.push_back(material);
  };
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    scene.meshes[i].interiorColor = colorOf(i);
    paint(scene.meshes[i].material, colorOf(i));
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    Spheres& spheres = scene.spheres[i];
    paint(spheres.material, colorOf(scene::firstSpheres(scene) + i));
    if (!spheres.data->colors.empty())
      spheres.data = std::make_shared<SphereData>(SphereData{spheres.data->centers, spheres.data->radii, {}});
  }
  scene.materials = std::move(materials);
  for (std::size_t i = 0; i < scene.volumes.size(); ++i) {
    Volume& volume = scene.volumes[i];
    // the points keep their values, on which the tables of opacities depend
    for (auto& point : volume.transfer.color) point.color = colorOf(scene.meshes.size() + i);
    volume.specular = glm::vec3(0.0f);
  }
  return scene;
}

std::vector<shared::float4> countColors(const std::vector<std::int64_t>& counts, std::uint64_t greatest) {
  std::vector<shared::float4> rays;
  rays.reserve(counts.size());
  const float scale = 1.0f / float(std::max<std::uint64_t>(greatest, 1));
  for (const std::int64_t count : counts)
    rays.push_back(count == kNothing ? shared::float4() : shared::float4(scaleColor(float(count) * scale), 1.0f));
  return rays;
}

void tintTexels(std::vector<shared::float4>& rays, const std::vector<shared::MapProbe>& probes,
                const std::vector<technique::MapCluster>& clusters) {
  constexpr float kTint = 0.75f, kDark = 0.45f;  // share of the cluster's colour; dark texels' part of the light
  std::vector<unsigned> clusterOfMap;
  for (const technique::MapCluster& cluster : clusters)
    clusterOfMap.insert(clusterOfMap.end(), cluster.views.size(), cluster.number);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (probes[i].map == 0) continue;
    const glm::vec3 color(rays[i].x, rays[i].y, rays[i].z);
    const float grey = (color.x + color.y + color.z) / 3.0f;
    const glm::vec3 tint = clusterColor(clusterOfMap[probes[i].map - 1]);
    const glm::vec3 tinted = glm::mix(color, tint * (grey / ((tint.x + tint.y + tint.z) / 3.0f)), kTint);
    rays[i] = {tinted * glm::mix(kDark, 1.0f, probes[i].checker), rays[i].w};
  }
}

}  // namespace cdsm::engine
