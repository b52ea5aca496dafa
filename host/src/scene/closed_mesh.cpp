// SPDX-License-Identifier: Apache-2.0
// Closedness by balanced edges, inside by solid angles.
#include "scene/closed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace cdsm::scene {
namespace {

constexpr double kPi = 3.14159265358979323846;

bool isBefore(const glm::vec3& a, const glm::vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// For each position a number that equal positions share.
std::vector<std::uint32_t> joinPositions(const Array<glm::vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return isBefore(positions[a], positions[b]); });
  std::vector<std::uint32_t> joined(positions.size());
  std::uint32_t id = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && positions[order[i]] != positions[order[i - 1]]) ++id;
    joined[order[i]] = id;
  }
  return joined;
}

struct Edge {
  std::uint64_t ends;  ///< lower end in the upper half
  int direction;       ///< +1 from the lower to the higher end, -1 back
};

/// An edge from a vertex to itself (a triangle without an area) is its own opposite and left out.
std::vector<Edge> directedEdges(const MeshData& mesh) {
  const std::vector<std::uint32_t> joined = joinPositions(mesh.positions);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint64_t from = joined[triangle[corner]];
      const std::uint64_t to = joined[triangle[(corner + 1) % 3]];
      if (from != to) edges.push_back({std::min(from, to) << 32 | std::max(from, to), from < to ? 1 : -1});
    }
  }
  return edges;
}

}  // namespace

std::size_t openEdges(const MeshData& mesh) {
  std::vector<Edge> edges = directedEdges(mesh);
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  std::size_t open = 0;
  for (std::size_t first = 0; first < edges.size();) {
    long long balance = 0;
    std::size_t next = first;
    for (; next < edges.size() && edges[next].ends == edges[first].ends; ++next) balance += edges[next].direction;
    open += static_cast<std::size_t>(std::llabs(balance));
    first = next;
  }
  return open;
}

double windingNumber(const MeshData& mesh, const glm::mat4& worldFromObject, const glm::dvec3& pointWorld) {
  const glm::dmat4 transform(worldFromObject);
  const auto fromPoint = [&](std::uint32_t index) {
    return glm::dvec3(transform * glm::dvec4(mesh.positions[index], 1.0)) - pointWorld;
  };
  double halfAngles = 0.0;  // half of each triangle's solid angle
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a = fromPoint(triangle.x), b = fromPoint(triangle.y), c = fromPoint(triangle.z);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double volume = glm::dot(a, glm::cross(b, c));
    const double cosine = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    halfAngles += std::atan2(volume, cosine);
  }
  return halfAngles / (2.0 * kPi);
}

}  // namespace cdsm::scene
