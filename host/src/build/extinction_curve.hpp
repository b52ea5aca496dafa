// SPDX-License-Identifier: Apache-2.0
// A transfer function's extinction by value as a polygon (kernels/build/curve.clh), for exact integrals along rays.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "shared/types.h"

namespace cdsm::build {

/// Corners (value, extinction in 1 / world length), ascending in value, constant outside; two of equal value make a
/// step.
using ExtinctionCurve = std::vector<shared::float2>;

/// Within 0.02 % of the larger extinction at the ends of each edge. All points of `opacity`, which is valid, are
/// corners.
ExtinctionCurve makeExtinctionCurve(const std::vector<TransferFunction::OpacityPoint>& opacity, float unitDistance);

/// The same of what a channel of light meets, 0 red, 1 green, 2 blue: what the transmission lets pass is not absorbed.
ExtinctionCurve makeAttenuationCurve(const TransferFunction& transfer, int channel);

/// The curves of a scene's media on the device, in their order; of constant media they are empty.
class ExtinctionCurves {
 public:
  ExtinctionCurves(device::Device& device, const std::vector<ExtinctionCurve>& curves);

  /// Arguments of CDSM_MARCH_PARAMS in kernels/build/march_everywhere.clh.
  device::ArgumentList arguments() const { return {ranges_.cl(), corners_.cl(), sums_.cl()}; }

 private:
  device::Buffer<shared::uint2> ranges_;  ///< per curve: its corners [x, y)
  device::Buffer<shared::float2> corners_;
  device::Buffer<shared::float4> sums_;  ///< per corner, from the first of its curve on
};

}  // namespace cdsm::build
