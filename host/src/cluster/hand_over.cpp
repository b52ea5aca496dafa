// SPDX-License-Identifier: Apache-2.0
#include "cluster/hand_over.hpp"

#include <cmath>

namespace cdsm::cluster {

namespace {

/// Clusters with this much more error than the best ones are given up.
constexpr double kWorse = 1.25;

}  // namespace

bool HandOver::fits(const LightPlan& plan) const { return begun_ && !std::isinf(errorOf(plan, current_)); }

void HandOver::next(const LightPlan& plan) {
  if (!fits(plan)) {  // objects came or went: nothing to keep
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
  if (errorOf(plan, current_) <= kWorse * errorOf(plan, plan.clusters)) return;
  former_ = std::move(current_);
  current_ = plan.clusters;
  frame_ = 1;
}

}  // namespace cdsm::cluster
