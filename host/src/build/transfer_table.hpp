// SPDX-License-Identifier: Apache-2.0
// A transfer function as a fine table of extinction and colour, for one multiply-add and one interpolation per sample.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "shared/types.h"

namespace cdsm::build {

/// Table coordinate = value * scale + bias; entries 0 .. last, linear between, constant outside.
struct TransferTable {
  float scale = 0.0f;
  float bias = 0.0f;
  std::vector<shared::float4> entries;        ///< rgb and extinction (1 / world length); at least two
  std::vector<shared::float4> towardsLights;  ///< for each entry: extinction that red, green, blue and grey light meet
};

/// Cap of opacities that become extinctions [INTERFACE, 4.2].
constexpr float kMostOpacity = 0.9999f;

/// Extinction -ln(1 - a) / unitDistance of an opacity, which is capped.
float extinctionOf(float opacity, float unitDistance);

/// Points with whole values, spanning at most 65536, lie on entries of the table. Others may fall between two of 8192
/// entries (65536 for whole values): the table is then off near the point by what the function bends within one entry.
/// `transfer` is valid.
TransferTable makeTransferTable(const TransferFunction& transfer);

}  // namespace cdsm::build
