// SPDX-License-Identifier: Apache-2.0
// Clusters that change without a visible jump [Knecht 2011, §6.1]: the maps of the former clusters fade out over some
// frames while those of the new ones fade in.
#pragma once

#include "cluster/cluster_plan.hpp"

namespace cdsm::cluster {

/// Clusters of one light over the frames of an animation. Both sets hold all casters, so that each tells the whole
/// transmittance, only with other texels.
class HandOver {
 public:
  static constexpr int kFrames = 8;  ///< from one set to the other

  /// One more frame, for which `plan` would be best. Clusters stay while they are not much worse than that.
  void next(const LightPlan& plan);

  /// Whether its clusters are of the objects of the plan.
  bool fits(const LightPlan& plan) const;

  const LightClusters& current() const { return current_; }
  const LightClusters& former() const { return former_; }  ///< empty unless they are fading out
  /// Of the current set in the transmittance; the rest is the former set's.
  float share() const { return former_.empty() ? 1.0f : float(frame_) / float(kFrames); }

 private:
  LightClusters current_, former_;
  bool begun_ = false;
  int frame_ = 0;  ///< of the fading
};

}  // namespace cdsm::cluster
