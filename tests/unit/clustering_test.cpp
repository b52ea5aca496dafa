// SPDX-License-Identifier: Apache-2.0
// Laws of clusters on random items, distances worked out pair by pair.
#include "cluster/clustering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "cluster_parts.hpp"

namespace cdsm::cluster {
namespace {

using reference::Random;

ClusterItem randomItem(Random& random, int directions, double largest) {
  ClusterItem item;
  item.weight = random.integer(0, 3) == 0 ? random.uniform(0.2, 3.0) : 1.0;
  for (int d = 0; d < directions; ++d) {
    Extents e;
    e.seen = d == 0 || random.integer(0, 2) == 0;
    e.squareLow = {random.uniform(-1.0, 1.0 - largest), random.uniform(-1.0, 1.0 - largest)};
    e.squareHigh = e.squareLow + glm::dvec2(random.uniform(0.0, largest), random.uniform(0.0, largest));
    e.pictureLow = 0.5 * e.squareLow;
    e.pictureHigh = 0.5 * e.squareHigh;
    e.nearDepth = random.uniform(1.0, 5.0);
    e.farDepth = e.nearDepth + random.uniform(0.0, 3.0);
    item.directions.push_back(e);
  }
  return item;
}

std::vector<ClusterItem> randomItems(Random& random, int count, int directions = 1, double largest = 0.5) {
  std::vector<ClusterItem> items;
  for (int i = 0; i < count; ++i) items.push_back(randomItem(random, directions, largest));
  return items;
}

/// Of the thesis's definition, written out.
double slowDistance(const ClusterItem& a, const ClusterItem& b) {
  double distance = -1.0;
  for (std::size_t d = 0; d < a.directions.size(); ++d) {
    if (!a.directions[d].seen || !b.directions[d].seen) continue;
    const glm::dvec2 low = a.directions[d].squareLow - b.directions[d].squareLow;
    const glm::dvec2 high = a.directions[d].squareHigh - b.directions[d].squareHigh;
    distance = std::max({distance, std::hypot(low.x, low.y), std::hypot(high.x, high.y)});
  }
  if (distance < 0.0) distance = std::sqrt(8.0);
  return distance * std::max(a.weight, b.weight);
}

void expectEachOnce(const std::vector<Cluster>& clusters, std::size_t count, std::size_t most) {
  std::multiset<unsigned> all;
  for (const Cluster& cluster : clusters) {
    EXPECT_FALSE(cluster.empty());
    all.insert(cluster.begin(), cluster.end());
  }
  EXPECT_EQ(all.size(), count);
  EXPECT_EQ(std::set<unsigned>(all.begin(), all.end()).size(), count);
  if (!all.empty()) EXPECT_EQ(*all.rbegin(), count - 1);
  EXPECT_LE(clusters.size(), most);
  EXPECT_EQ(clusters.empty(), count == 0);
}

TEST(Clustering, DistancesOfPairs) {
  Random random(1);
  for (const int directions : {1, 6}) {
    const std::vector<ClusterItem> items = randomItems(random, 40, directions);
    for (const ClusterItem& a : items)
      for (const ClusterItem& b : items) {
        EXPECT_DOUBLE_EQ(itemDistance(a, b), slowDistance(a, b));
        EXPECT_EQ(itemDistance(a, b), itemDistance(b, a));
      }
  }
}

TEST(Clustering, PutsEveryItemInOneCluster) {
  Random random(2);
  for (const int count : {0, 1, 2, 3, 7, 30, 300, 1000})
    for (const unsigned most : {1u, 2u, 4u, 8u, 64u})
      for (const double distance : {0.0, 0.25, 3.0}) {
        if (count == 1000 && (most != 4 || distance != 0.25)) continue;
        SCOPED_TRACE(std::to_string(count) + " items, " + std::to_string(most) + " clusters");
        const std::vector<ClusterItem> items = randomItems(random, count, count % 2 ? 6 : 1);
        expectEachOnce(formClusters(items, most, distance), std::size_t(count), most);
      }
}

TEST(Clustering, KeepsDistantItemsApartWhileThereAreClusters) {
  Random random(3);
  int fewer = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<ClusterItem> items = randomItems(random, random.integer(1, 20), i % 2 ? 6 : 1);
    const double distance = random.uniform(0.1, 3.0);
    const std::vector<Cluster> clusters = formClusters(items, 6, distance);
    if (clusters.size() == 6) continue;
    ++fewer;
    for (const Cluster& cluster : clusters)
      for (const unsigned a : cluster)
        for (const unsigned b : cluster)
          if (a != b) EXPECT_LT(slowDistance(items[a], items[b]), distance);
  }
  EXPECT_GT(fewer, 50);
}

std::set<std::set<unsigned>> partition(const std::vector<Cluster>& clusters, const std::vector<unsigned>& names) {
  std::set<std::set<unsigned>> sets;
  for (const Cluster& cluster : clusters) {
    std::set<unsigned> set;
    for (const unsigned item : cluster) set.insert(names[item]);
    sets.insert(set);
  }
  return sets;
}

/// Items of distinct sizes and distances.
TEST(Clustering, DoesNotDependOnTheOrderOfItems) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const std::vector<ClusterItem> items = randomItems(random, 15);
    std::vector<unsigned> order(items.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto ordered = partition(formClusters(items, 4, 0.4), order);
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[std::size_t(random.integer(0, int(k) - 1))]);
    std::vector<ClusterItem> mixed;
    for (const unsigned item : order) mixed.push_back(items[item]);
    EXPECT_EQ(partition(formClusters(mixed, 4, 0.4), order), ordered) << i;
  }
}

/// Three groups far apart, three clusters: the groups.
TEST(Clustering, FindsGroups) {
  Random random(5);
  std::vector<ClusterItem> items = randomItems(random, 30, 1, 0.05);
  for (unsigned i = 0; i < items.size(); ++i) {
    Extents& e = items[i].directions.front();
    const glm::dvec2 middle(i % 3 == 0 ? -0.8 : 0.7, i % 3 == 1 ? -0.8 : 0.7), size = e.squareHigh - e.squareLow;
    e.squareLow = middle + 0.05 * e.squareLow;
    e.squareHigh = e.squareLow + size;
    e.pictureLow = e.squareLow;
    e.pictureHigh = e.squareHigh;
    items[i].weight = 1.0;
  }
  for (const bool refined : {false, true}) {
    std::vector<Cluster> clusters = formClusters(items, 3, 0.25);
    if (refined) refineClusters(items, clusters);
    ASSERT_EQ(clusters.size(), 3u);
    for (const Cluster& cluster : clusters)
      for (const unsigned item : cluster) EXPECT_EQ(item % 3, cluster.front() % 3);
  }
}

TEST(Clustering, WeightsScaleDistancesAndErrors) {
  Random random(6);
  std::vector<ClusterItem> items = randomItems(random, 2);
  items[0].weight = items[1].weight = 1.0;
  const double distance = itemDistance(items[0], items[1]), error = expectedError(items, {{0}, {1}});
  EXPECT_EQ(formClusters(items, 2, 1.01 * distance).size(), 1u);
  items[0].weight = 2.0;
  EXPECT_DOUBLE_EQ(itemDistance(items[0], items[1]), 2.0 * distance);
  EXPECT_EQ(formClusters(items, 2, 1.01 * distance).size(), 2u);
  EXPECT_NEAR(expectedError(items, {{0}, {1}}) - error, expectedError({items[0]}, {{0}}) / 2.0, 1e-12);
}

/// A cluster of two is drawn with wider texels than clusters of one; a cluster of a part of the items with narrower.
TEST(Clustering, MoreClustersHaveLessError) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const std::vector<ClusterItem> items = randomItems(random, 6, i % 2 ? 6 : 1);
    const double one = expectedError(items, {{0, 1, 2, 3, 4, 5}}), two = expectedError(items, {{0, 1, 2}, {3, 4, 5}});
    const double all = expectedError(items, {{0}, {1}, {2}, {3}, {4}, {5}});
    EXPECT_LE(two, one * (1.0 + 1e-12));
    EXPECT_LE(all, two * (1.0 + 1e-12));
    EXPECT_GT(all, 0.0);
  }
}

TEST(Clustering, RefiningNeverRaisesTheError) {
  Random random(8);
  int better = 0;
  for (int i = 0; i < 200; ++i) {
    const int count = random.integer(0, 25);
    const std::vector<ClusterItem> items = randomItems(random, count, i % 2 ? 6 : 1, i % 3 ? 0.3 : 1.8);
    std::vector<Cluster> clusters = formClusters(items, unsigned(random.integer(1, 6)), random.uniform(0.0, 1.0));
    const double before = expectedError(items, clusters);
    const std::size_t most = clusters.size();
    refineClusters(items, clusters);
    expectEachOnce(clusters, std::size_t(count), most);
    EXPECT_LE(expectedError(items, clusters), before * (1.0 + 1e-12));
    better += expectedError(items, clusters) < 0.9 * before;
  }
  EXPECT_GT(better, 30);
}

/// One item as large as the square and small ones in two corners: it gets a cluster of its own.
TEST(Clustering, RefiningSetsAVeryLargeItemApart) {
  Random random(9);
  std::vector<ClusterItem> items = randomItems(random, 9, 1, 0.05);
  for (unsigned i = 0; i < items.size(); ++i) {
    Extents& e = items[i].directions.front();
    const glm::dvec2 size = e.squareHigh - e.squareLow;
    e.squareLow = glm::dvec2(i % 2 ? -0.9 : 0.8) + 0.05 * e.squareLow;
    e.squareHigh = e.squareLow + size;
    if (i == 0) e.squareLow = glm::dvec2(-1), e.squareHigh = glm::dvec2(1);
    e.pictureLow = e.squareLow;
    e.pictureHigh = e.squareHigh;
    e.nearDepth = e.farDepth = 1.0;
    items[i].weight = 1.0;
  }
  std::vector<Cluster> clusters = formClusters(items, 3, 0.25);
  refineClusters(items, clusters);
  ASSERT_EQ(clusters.size(), 3u);
  for (const Cluster& cluster : clusters)
    if (std::find(cluster.begin(), cluster.end(), 0u) != cluster.end()) EXPECT_EQ(cluster.size(), 1u);
}

}  // namespace
}  // namespace cdsm::cluster
