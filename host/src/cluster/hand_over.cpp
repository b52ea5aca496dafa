// SPDX-License-Identifier: Apache-2.0
#include "cluster/hand_over.hpp"

#include <cmath>

namespace cdsm::cluster {

namespace {

/// Clusters with this much more error than the best ones are given up.
constexpr double kWorse = 1.25;

}  // namespace

void HandOver::next(const LightPlan& plan) {
  const double error = errorOf(plan, current_);
  if (!begun_ || std::isinf(error)) {  // objects came or went: nothing to keep
    begun_ = true;
    current_ = plan.clusters;
    former_.clear();
    return;
  }
  if (!former_.empty()) {
    if (++frame_ < kFrames) return;
    former_.clear();
    return;
  }
  if (error <= kWorse * errorOf(plan, plan.clusters)) return;
  former_ = std::move(current_);
  current_ = plan.clusters;
  frame_ = 1;
}

}  // namespace cdsm::cluster
