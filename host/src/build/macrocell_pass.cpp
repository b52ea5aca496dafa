// SPDX-License-Identifier: Apache-2.0
#include "build/macrocell_pass.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "device/program.hpp"

namespace cdsm::build {

namespace {

/// Rings of empty macrocells that a ray may skip at once; further ones cost more to find than they save. Even: the
/// two buffers take turns, and the cells of the other volumes must end in the right one.
constexpr unsigned kMostRings = 6;

/// How many of the first i entries of a medium's table have extinction. A peak of the curve that lies between two
/// entries without counts with the second one.
std::vector<std::uint32_t> solidEntriesBefore(const shared::MediumData& medium, const float* extinctions,
                                              const ExtinctionCurve& curve) {
  std::vector<bool> solid;
  for (shared::uint i = 0; i <= medium.lutLast; ++i) solid.push_back(extinctions[i] > 0.0f);
  for (const shared::float2& corner : curve) {
    const float at = std::clamp(corner.x * medium.lutScale + medium.lutBias, 0.0f, float(medium.lutLast));
    const auto low = std::size_t(at), high = std::size_t(std::ceil(at));
    if (corner.y > 0.0f && extinctions[low] <= 0.0f && extinctions[high] <= 0.0f) solid[high] = true;
  }
  std::vector<std::uint32_t> before{0};
  for (const bool entry : solid) before.push_back(before.back() + entry);
  return before;
}

}  // namespace

void MacrocellPass::run(const VolumeSlots& slots, const std::vector<shared::MediumData>& media,
                        const std::vector<float>& extinctions, const std::vector<ExtinctionCurve>& curves) {
  Classified now;
  now.extinctions = extinctions;
  std::size_t count = 0;
  for (std::size_t i = 0; i < media.size(); ++i) {
    const shared::MediumData& medium = media[i];
    if (medium.size.w < 0) continue;
    count += std::size_t(medium.cells.x) * medium.cells.y * medium.cells.z;
    now.data.push_back(slots.slot(medium.size.w).data);
    now.revisions.push_back(slots.slot(medium.size.w).revision);
    now.tables.insert(now.tables.end(), {medium.lutScale, medium.lutBias, float(medium.lutOffset)});
    for (const shared::float2& corner : curves[i]) now.tables.insert(now.tables.end(), {corner.x, corner.y});
  }
  if (classified_ == now) return;
  classified_.reset();
  cells_ = {};
  cells_ = device::Buffer<std::uint8_t>(device_, count, "macrocells");
  cellsBefore_ = {};
  cellsBefore_ = device::Buffer<std::uint8_t>(device_, count, "macrocells");
  for (std::size_t i = 0; i < media.size(); ++i)
    if (media[i].size.w >= 0) classify(slots, media[i], extinctions, curves[i]);
  classified_ = std::move(now);
}

void MacrocellPass::classify(const VolumeSlots& slots, const shared::MediumData& medium,
                             const std::vector<float>& extinctions, const ExtinctionCurve& curve) {
  using Uints = device::Buffer<std::uint32_t>;
  using Cells = device::Buffer<std::uint8_t>;
  const std::size_t count = std::size_t(medium.cells.x) * medium.cells.y * medium.cells.z;
  const std::vector<std::uint32_t> solidBefore = solidEntriesBefore(medium, &extinctions[medium.lutOffset], curve);
  const Uints solid = Uints::fromHost(device_, solidBefore, "table of extinctions");
  const shared::CellParams params{medium.cells, medium.lutScale, medium.lutBias, medium.lutLast, 0};
  const cl::Program& program = device_.programs().get({"build/macrocells.cl", {}, {}});
  device::Kernel<shared::CellParams, device::Buffer<shared::float2>, Uints, Cells> classifyCells(device_, program,
                                                                                                 "classifyCells");
  device::Kernel<shared::CellParams, std::uint32_t, Cells, Cells> growReach(device_, program, "growReach");
  classifyCells({"classify macrocells", {count}, {64}}, params, slots.slot(medium.size.w).cellBounds, solid, cells_);
  for (unsigned ring = 1; ring <= kMostRings; ++ring) {
    std::swap(cells_, cellsBefore_);
    growReach({"grow empty macrocells", {count}, {64}}, params, ring, cellsBefore_, cells_);
  }
  device_.finish();
}

}  // namespace cdsm::build
