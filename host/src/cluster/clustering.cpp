// SPDX-License-Identifier: Apache-2.0
#include "cluster/clustering.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cdsm::cluster {

namespace {

/// More items than this take part by joining clusters alone: pairs are as many as their square.
constexpr unsigned kMostPaired = 256;
/// Diagonal of the square [-1, 1]^2.
const double kFarApart = 2.0 * std::sqrt(2.0);
constexpr int kMostRounds = 16;  ///< of refinement

struct Pair {
  double distance;
  unsigned a, b;
};

double squareSize(const ClusterItem& item) {
  double size = 0.0;
  for (const Extents& e : item.directions) {
    if (!e.seen) continue;
    const glm::dvec2 extent = e.squareHigh - e.squareLow;
    size = std::max({size, extent.x, extent.y});
  }
  return size;
}

/// Clusters while they form.
class Forming {
 public:
  Forming(const std::vector<ClusterItem>& items, unsigned most, double distance)
      : items_(items), most_(most), distance_(distance), placed_(items.size(), false) {}

  /// Alg. 4.2, lines 10-34, for one pair.
  void placePair(const Pair& pair) {
    joinNear(pair.a);
    joinNear(pair.b);
    if (!placed_[pair.a] && !placed_[pair.b] && pair.distance < distance_ && clusters_.size() < most_) {
      begin(pair.a);
      add(pair.b, clusters_.size() - 1);
      return;
    }
    placeAnywhere(pair.a);
    placeAnywhere(pair.b);
  }

  /// In a cluster of its own if there may be one more, else in the nearest.
  void placeAnywhere(unsigned item) {
    if (placed_[item]) return;
    if (clusters_.size() < most_)
      begin(item);
    else
      add(item, nearest(item));
  }

  /// In the nearest cluster, if all of that is nearer than the threshold. An item that has been placed stays.
  void joinNear(unsigned item) {
    if (placed_[item] || clusters_.empty()) return;
    const std::size_t cluster = nearest(item);
    if (farthestIn(item, clusters_[cluster]) < distance_) add(item, cluster);
  }

  std::vector<Cluster> take() { return std::move(clusters_); }

 private:
  double farthestIn(unsigned item, const Cluster& cluster) const {
    double most = 0.0;
    for (const unsigned other : cluster) most = std::max(most, itemDistance(items_[item], items_[other]));
    return most;
  }

  /// The cluster whose farthest item is nearest [Knecht 2011, §4.5].
  std::size_t nearest(unsigned item) const {
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      const double distance = farthestIn(item, clusters_[i]);
      if (distance < least) best = i;
      least = std::min(least, distance);
    }
    return best;
  }

  void begin(unsigned item) {
    clusters_.push_back({item});
    placed_[item] = true;
  }
  void add(unsigned item, std::size_t cluster) {
    clusters_[cluster].push_back(item);
    placed_[item] = true;
  }

  const std::vector<ClusterItem>& items_;
  unsigned most_;
  double distance_;
  std::vector<bool> placed_;
  std::vector<Cluster> clusters_;
};

/// Width of the cluster in the picture of one direction; 0 if nothing is seen there.
double pictureWidth(const std::vector<ClusterItem>& items, const Cluster& cluster, std::size_t direction) {
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const unsigned item : cluster) {
    const Extents& e = items[item].directions[direction];
    if (!e.seen) continue;
    low = glm::min(low, e.pictureLow);
    high = glm::max(high, e.pictureHigh);
  }
  return low.x <= high.x ? std::max(high.x - low.x, high.y - low.y) : 0.0;
}

/// Length of an item's outline in the picture of a direction, as far as the camera may see its shadow.
double seenOutline(const Extents& e) {
  const glm::dvec2 picture = e.pictureHigh - e.pictureLow, square = e.squareHigh - e.squareLow;
  const glm::dvec2 seen = glm::max(glm::min(e.squareHigh, 1.0) - glm::max(e.squareLow, -1.0), 0.0);
  return (picture.x + picture.y) * (seen.x + seen.y) / std::max(square.x + square.y, 1e-300);
}

double clusterError(const std::vector<ClusterItem>& items, const Cluster& cluster) {
  double error = 0.0;
  const std::size_t directions = cluster.empty() ? 0 : items[cluster.front()].directions.size();
  for (std::size_t d = 0; d < directions; ++d) {
    double outlines = 0.0;
    for (const unsigned item : cluster) {
      const Extents& e = items[item].directions[d];
      if (e.seen) outlines += items[item].weight * items[item].sharpness * seenOutline(e) / (e.nearDepth * e.farDepth);
    }
    error += outlines * pictureWidth(items, cluster, d);
  }
  return error;
}

/// The best place for one item; true if it moved.
bool moveItem(const std::vector<ClusterItem>& items, std::vector<Cluster>& clusters, std::vector<double>& errors,
              unsigned item) {
  const auto has = [&](const Cluster& c) { return std::find(c.begin(), c.end(), item) != c.end(); };
  const std::size_t from = std::size_t(std::find_if(clusters.begin(), clusters.end(), has) - clusters.begin());
  Cluster without = clusters[from];
  without.erase(std::find(without.begin(), without.end(), item));
  const double errorWithout = clusterError(items, without);
  double best = -1e-9 * errors[from];
  std::size_t to = from;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    if (i == from) continue;
    Cluster with = clusters[i];
    with.push_back(item);
    const double change = errorWithout - errors[from] + clusterError(items, with) - errors[i];
    if (change < best) {
      best = change;
      to = i;
    }
  }
  if (to == from) return false;
  clusters[from] = std::move(without);
  clusters[to].push_back(item);
  errors[from] = errorWithout;
  errors[to] = clusterError(items, clusters[to]);
  return true;
}

/// Moves items one at a time as long as the error falls. Returns the error.
double moveItems(const std::vector<ClusterItem>& items, std::vector<Cluster>& clusters) {
  std::vector<double> errors;
  for (const Cluster& cluster : clusters) errors.push_back(clusterError(items, cluster));
  bool moved = true;
  for (int round = 0; moved && round < kMostRounds; ++round) {
    moved = false;
    for (unsigned item = 0; item < items.size(); ++item) moved = moveItem(items, clusters, errors, item) || moved;
  }
  return std::accumulate(errors.begin(), errors.end(), 0.0);
}

/// Starts with a cluster for each item and merges the two that cost least until `count` are left.
std::vector<Cluster> mergedClusters(const std::vector<ClusterItem>& items, std::size_t count) {
  std::vector<Cluster> clusters;
  for (unsigned i = 0; i < items.size(); ++i) clusters.push_back({i});
  std::vector<double> errors;
  for (const Cluster& cluster : clusters) errors.push_back(clusterError(items, cluster));
  const auto united = [&](std::size_t a, std::size_t b) {
    Cluster both = clusters[a];
    both.insert(both.end(), clusters[b].begin(), clusters[b].end());
    return both;
  };
  // costs[b][a], a < b: of merging a and b
  std::vector<std::vector<double>> costs(clusters.size());
  const auto cost = [&](std::size_t a, std::size_t b) {
    return clusterError(items, united(a, b)) - errors[a] - errors[b];
  };
  for (std::size_t b = 0; b < clusters.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) costs[b].push_back(cost(a, b));
  while (clusters.size() > count) {
    std::size_t bestA = 0, bestB = 1;
    for (std::size_t b = 1; b < clusters.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (costs[b][a] < costs[bestB][bestA]) bestA = a, bestB = b;
    clusters[bestA] = united(bestA, bestB);
    errors[bestA] = clusterError(items, clusters[bestA]);
    clusters.erase(clusters.begin() + std::ptrdiff_t(bestB));
    errors.erase(errors.begin() + std::ptrdiff_t(bestB));
    costs.erase(costs.begin() + std::ptrdiff_t(bestB));
    for (std::size_t b = bestB; b < clusters.size(); ++b) costs[b].erase(costs[b].begin() + std::ptrdiff_t(bestB));
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      if (i < bestA) costs[bestA][i] = cost(i, bestA);
      if (i > bestA) costs[i][bestA] = cost(bestA, i);
    }
  }
  return clusters;
}

}  // namespace

double itemDistance(const ClusterItem& a, const ClusterItem& b) {
  double most = -1.0;
  for (std::size_t d = 0; d < a.directions.size(); ++d) {
    const Extents &p = a.directions[d], &q = b.directions[d];
    if (!p.seen || !q.seen) continue;
    most = std::max({most, glm::distance(p.squareLow, q.squareLow), glm::distance(p.squareHigh, q.squareHigh)});
  }
  return std::max(a.weight, b.weight) * (most < 0.0 ? kFarApart : most);
}

std::vector<Cluster> formClusters(const std::vector<ClusterItem>& items, unsigned most, double distance) {
  std::vector<unsigned> order(items.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<double> sizes;
  for (const ClusterItem& item : items) sizes.push_back(squareSize(item));
  std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) { return sizes[a] > sizes[b]; });
  const unsigned paired = std::min(unsigned(items.size()), kMostPaired);

  std::vector<Pair> pairs;
  for (unsigned i = 0; i < paired; ++i)
    for (unsigned k = i + 1; k < paired; ++k)
      pairs.push_back({itemDistance(items[order[i]], items[order[k]]), order[i], order[k]});
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
    if (p.distance != q.distance) return p.distance > q.distance;
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  });

  Forming forming(items, most, distance);
  for (const Pair& pair : pairs) forming.placePair(pair);
  for (const unsigned item : order) {
    forming.joinNear(item);
    forming.placeAnywhere(item);
  }
  return forming.take();
}

double expectedError(const std::vector<ClusterItem>& items, const std::vector<Cluster>& clusters) {
  double error = 0.0;
  for (const Cluster& cluster : clusters) error += clusterError(items, cluster);
  return error;
}

void refineClusters(const std::vector<ClusterItem>& items, std::vector<Cluster>& clusters) {
  if (clusters.size() < 2 || items.size() > kMostPaired) return;
  std::vector<Cluster> merged = mergedClusters(items, clusters.size());
  if (moveItems(items, merged) < moveItems(items, clusters)) clusters = std::move(merged);
  clusters.erase(std::remove_if(clusters.begin(), clusters.end(), [](const Cluster& c) { return c.empty(); }),
                 clusters.end());
}

}  // namespace cdsm::cluster
