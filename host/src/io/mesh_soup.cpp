// SPDX-License-Identifier: Apache-2.0
// Joining of corners; see mesh_soup.hpp.
#include "io/mesh_soup.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace cdsm::io {

namespace {

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    char bytes[sizeof(Corner)];
    std::memcpy(bytes, &corner, sizeof(Corner));
    return std::hash<std::string_view>{}(std::string_view(bytes, sizeof(Corner)));
  }
};

struct CornerEqual {
  bool operator()(const Corner& a, const Corner& b) const { return std::memcmp(&a, &b, sizeof(Corner)) == 0; }
};

bool hasNormal(const Corner& corner) { return glm::length(glm::dvec3(corner.normal)) > 0.0; }

/// The key under which a corner is joined: + 0.0f makes -0 to 0.
Corner keyOf(const Corner& corner, bool normals) {
  Corner key{corner.position + 0.0f, glm::vec3(0.0f)};
  if (normals) key.normal = glm::vec3(glm::normalize(glm::dvec3(corner.normal))) + 0.0f;
  return key;
}

/// In double the products of float differences are exact enough that only flat triangles give 0.
bool hasArea(const Corner* corner) {
  const glm::dvec3 a(corner[0].position), b(corner[1].position), c(corner[2].position);
  return glm::cross(b - a, c - a) != glm::dvec3(0.0);
}

}  // namespace

MeshData joinCorners(const std::vector<Corner>& corners) {
  const bool hasNormals = std::all_of(corners.begin(), corners.end(), hasNormal);
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  std::unordered_map<Corner, glm::uint, CornerHash, CornerEqual> indices;
  const auto indexOf = [&](const Corner& corner) {
    const Corner key = keyOf(corner, hasNormals);
    const auto [at, isNew] = indices.emplace(key, static_cast<glm::uint>(positions.size()));
    if (isNew) positions.push_back(key.position);
    if (isNew && hasNormals) normals.push_back(key.normal);
    return at->second;
  };
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (!hasArea(&corners[i])) continue;
    const glm::uint a = indexOf(corners[i]), b = indexOf(corners[i + 1]), c = indexOf(corners[i + 2]);
    triangles.emplace_back(a, b, c);
  }
  return {std::move(positions), std::move(normals), std::move(triangles)};
}

}  // namespace cdsm::io
