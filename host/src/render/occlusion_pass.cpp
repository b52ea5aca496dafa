// SPDX-License-Identifier: Apache-2.0
#include "render/occlusion_pass.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "device/program.hpp"
#include "render/occlusion_plan.hpp"
#include "scene/changes.hpp"

namespace cdsm::render {

namespace {

constexpr std::uint32_t kCellsOfLaunch = 1u << 18;  ///< so that no launch keeps a display waiting
constexpr std::size_t kMostSlices = 64;             ///< work items that share a sphere
constexpr float kGathered = 0.9f;                   ///< done before cells are smoothed, of the whole
constexpr const char* kStep = "ambient occlusion";

using Cells = device::Buffer<std::uint32_t>;

/// What of a scene the grid is made of.
Scene partOf(const Scene& scene) {
  Scene part;
  part.materials = scene.materials;
  part.spheres = scene.spheres;
  part.ambientOcclusion = scene.ambientOcclusion;
  return part;
}

/// Launches a kernel for one part of the cells after the other, each finished before the next; told(done) comes before
/// each.
template <class Kernel, class Told, class... Args>
void launchInParts(device::Device& device, const char* name, Kernel& kernel, std::uint32_t count, const Told& told,
                   shared::OcclusionParams params, const Args&... args) {
  for (params.firstCell = 0; params.firstCell < count; params.firstCell = params.lastCell) {
    told(float(params.firstCell) / float(count));
    params.lastCell = std::min(count, params.firstCell + kCellsOfLaunch);
    kernel({name, {params.lastCell - params.firstCell}, {64}}, params, args...);
    device.finish();
  }
}

}  // namespace

void OcclusionPass::drop() {
  filled_.reset();
  grid_ = {};
  seen_ = Seen(device_, 0, "ambient occlusion");
}

void OcclusionPass::prepare(const Scene& scene, const build::DeviceScene& deviceScene, const Progress& progress) {
  fresh_ = false;
  if (scene.ambientOcclusion && filled_ && scene::sameOcclusion(*filled_, scene)) return;
  if (filled_) drop();
  if (!scene.ambientOcclusion) return;
  fill(scene, deviceScene, progress);
  filled_ = partOf(scene);
  fresh_ = true;
}

Cells OcclusionPass::addUp(const shared::OcclusionParams& params, const build::DeviceScene& deviceScene,
                           float greatestRadius) {
  const cl::Program& program = device_.programs().get({"occlusion/density.cl", {}, {}});
  device::Kernel<shared::DensityParams, shared::int4, device::Buffer<shared::SceneSphere>,
                 device::Buffer<shared::ObjectData>, Cells>
      addSpheres(device_, program, "addSpheres");
  device::Kernel<shared::int4, shared::int4, Cells> joinCells(device_, program, "joinCells");
  Cells cells(device_, cellsOf(params), "density of spheres");
  cells.fill(0);
  const auto slices = std::min(std::size_t(2.0f * greatestRadius / params.grid.corner.w) + 2, kMostSlices);
  const build::ObjectSet& objects = deviceScene.allObjects();
  for (const build::PrimitiveRange& range : objects.spheres)
    addSpheres({"add spheres to density", {range.count, slices}, {64, 1}},
               {params.grid, shared::uint(range.first), shared::uint(range.count), shared::uint(slices), 0},
               params.levels[0], deviceScene.spheres(), objects.objects, cells);
  for (std::size_t i = 1; i < CDSM_OCCLUSION_LEVELS; ++i) {
    const shared::int4 level = params.levels[i];
    const std::size_t count = std::size_t(level.x - 2) * std::size_t(level.y - 2) * std::size_t(level.z - 2);
    joinCells({"join cells of density", {count}, {64}}, params.levels[i - 1], level, cells);
  }
  return cells;
}

void OcclusionPass::fill(const Scene& scene, const build::DeviceScene& deviceScene, const Progress& progress) {
  const SphereExtent extent = extentOf(scene);
  if (extent.meanRadius <= 0.0) return;  // none is to be seen
  const shared::OcclusionParams params = planOcclusion(*scene.ambientOcclusion, extent);
  const Cells cells = addUp(params, deviceScene, float(extent.greatestRadius));
  const auto directions = device::Buffer<shared::float4>::fromHost(
      device_, evenDirections(scene.ambientOcclusion->directions), "directions of ambient occlusion");
  const auto count =
      std::uint32_t(params.grid.size.x) * std::uint32_t(params.grid.size.y) * std::uint32_t(params.grid.size.z);
  Seen seen(device_, count, "ambient occlusion");
  const Seen rough(device_, count, "ambient occlusion, rough");
  const cl::Program& program = device_.programs().get({"occlusion/gather.cl", {}, {}});
  device::Kernel<shared::OcclusionParams, device::Buffer<shared::float4>, Cells, Seen> gatherOcclusion(
      device_, program, "gatherOcclusion");
  device::Kernel<shared::OcclusionParams, Cells, Seen, Seen> smoothOcclusion(device_, program, "smoothOcclusion");
  launchInParts(
      device_, "gather ambient occlusion", gatherOcclusion, count,
      [&](float done) { progress(kStep, kGathered * done); }, params, directions, cells, rough);
  launchInParts(
      device_, "smooth ambient occlusion", smoothOcclusion, count,
      [&](float done) { progress(kStep, kGathered + (1.0f - kGathered) * done); }, params, cells, rough, seen);
  seen_ = std::move(seen);
  grid_ = params.grid;
}

std::optional<OcclusionStats> OcclusionPass::stats() const {
  if (!filled_) return std::nullopt;
  return OcclusionStats{seen_.bytes(), grid_.size.x, grid_.size.y, grid_.size.z, fresh_};
}

}  // namespace cdsm::render
