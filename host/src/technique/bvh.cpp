// SPDX-License-Identifier: Apache-2.0
#include "technique/bvh.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "scene/view.hpp"

namespace cdsm::technique {

namespace {

using scene::Bounds;

constexpr int kBins = 16;
constexpr std::size_t kLeafPrimitives = 4;
/// From here on medians alone: they halve the rest, so 2^31 primitives still end before CDSM_BVH_DEPTH.
constexpr int kMedianDepth = 16;

glm::vec3 xyz(const shared::float4& v) { return {v.x, v.y, v.z}; }

Bounds boundsOf(const shared::BvhPrimitive& t) {
  Bounds bounds;
  if (t.b.w > 0.0f) return {xyz(t.a) - t.b.w, xyz(t.a) + t.b.w};
  bounds.add(xyz(t.a));
  bounds.add(xyz(t.b));
  bounds.add(xyz(t.c));
  return bounds;
}

float area(const Bounds& bounds) {
  const glm::vec3 d = glm::max(bounds.high - bounds.low, 0.0f);
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

class Builder {
 public:
  explicit Builder(std::vector<shared::BvhPrimitive> primitives) : primitives_(std::move(primitives)) {
    order_.resize(primitives_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    for (const shared::BvhPrimitive& t : primitives_) {
      bounds_.push_back(boundsOf(t));
      centers_.push_back(0.5f * (bounds_.back().low + bounds_.back().high));
    }
  }

  Bvh run() {
    if (!primitives_.empty()) build(0, order_.size(), 0);
    Bvh bvh;
    bvh.nodes = std::move(nodes_);
    for (const unsigned i : order_) bvh.primitives.push_back(primitives_[i]);
    return bvh;
  }

 private:
  void build(std::size_t first, std::size_t last, int depth) {
    Bounds bounds, centers;
    for (std::size_t i = first; i < last; ++i) {
      bounds.add(bounds_[order_[i]]);
      centers.add(centers_[order_[i]]);
    }
    const std::size_t number = nodes_.size();
    nodes_.push_back({{bounds.low, 0.0f}, {bounds.high, 0.0f}, unsigned(first), unsigned(last - first), 0, 0});
    if (last - first <= kLeafPrimitives) return;
    const std::size_t middle = split(first, last, centers, depth);
    nodes_[number].count = 0;
    build(first, middle, depth + 1);
    nodes_[number].link = unsigned(nodes_.size());
    build(middle, last, depth + 1);
  }

  std::size_t split(std::size_t first, std::size_t last, const Bounds& centers, int depth) {
    const glm::vec3 size = centers.high - centers.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    if (depth < kMedianDepth && size[axis] > 0.0f) {
      const int bin = cheapestBin(first, last, centers.low[axis], size[axis], axis);
      const auto middle = std::partition(order_.begin() + first, order_.begin() + last, [&](unsigned i) {
        return binOf(i, centers.low[axis], size[axis], axis) <= bin;
      });
      const std::size_t at = std::size_t(middle - order_.begin());
      if (at > first && at < last) return at;
    }
    const std::size_t half = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                     [&](unsigned a, unsigned b) { return centers_[a][axis] < centers_[b][axis]; });
    return half;
  }

  int binOf(unsigned i, float low, float size, int axis) const {
    return std::min(int((centers_[i][axis] - low) / size * kBins), kBins - 1);
  }

  /// Last bin of the left side with the least expected cost of both.
  int cheapestBin(std::size_t first, std::size_t last, float low, float size, int axis) const {
    std::array<Bounds, kBins> boxes;
    std::array<std::size_t, kBins> counts{};
    for (std::size_t i = first; i < last; ++i) {
      const int bin = binOf(order_[i], low, size, axis);
      boxes[bin].add(bounds_[order_[i]]);
      ++counts[bin];
    }
    std::array<float, kBins> right{};
    Bounds side;
    std::size_t count = 0;
    for (int i = kBins - 1; i > 0; --i) {
      if (counts[i] > 0) side.add(boxes[i]);
      count += counts[i];
      right[i - 1] = count > 0 ? area(side) * float(count) : 0.0f;
    }
    side = {};
    count = 0;
    int best = 0;
    float least = INFINITY;
    for (int i = 0; i + 1 < kBins; ++i) {
      if (counts[i] > 0) side.add(boxes[i]);
      count += counts[i];
      const float cost = (count > 0 ? area(side) * float(count) : 0.0f) + right[i];
      if (cost < least) best = i;
      least = std::min(least, cost);
    }
    return best;
  }

  std::vector<shared::BvhPrimitive> primitives_;
  std::vector<unsigned> order_;
  std::vector<Bounds> bounds_;
  std::vector<glm::vec3> centers_;
  std::vector<shared::BvhNode> nodes_;
};

}  // namespace

Bvh buildBvh(std::vector<shared::BvhPrimitive> primitives) { return Builder(std::move(primitives)).run(); }

}  // namespace cdsm::technique
