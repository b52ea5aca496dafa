// SPDX-License-Identifier: Apache-2.0
#include "build/sphere_buffer.hpp"

#include <cstring>
#include <utility>

#include <cdsm/error.hpp>

#include "scene/range.hpp"

namespace cdsm::build {

void SphereBuffer::update(const std::vector<Spheres>& sets, std::size_t firstObject) {
  std::vector<Held> next;
  for (const Spheres& set : sets) next.push_back({set.data, set.revision, firstObject + next.size()});
  const std::vector<Held> former = std::exchange(held_, {});  // none should an upload fail
  const bool inPlace = spheres_.allocated() && former.size() == next.size() && fit(next);
  if (!inPlace) makeRoom(next);
  for (std::size_t i = 0; i < next.size(); ++i)
    if (!inPlace || !(next[i] == former[i])) upload(i, next[i]);
  held_ = std::move(next);
}

bool SphereBuffer::fit(const std::vector<Held>& sets) const {
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (sets[i].data->centers.size() != ranges_[i].count) return false;
  return true;
}

void SphereBuffer::makeRoom(const std::vector<Held>& sets) {
  std::size_t count = 0;
  ranges_.clear();
  for (const Held& set : sets) {
    ranges_.push_back({count, set.data->centers.size()});
    count += ranges_.back().count;
  }
  if (count >= scene::kMostPrimitives)
    throw Error("the scene has " + std::to_string(count) + " spheres, must be below 2^30");
  spheres_ = {};
  spheres_ = {device_, count, "spheres"};
}

void SphereBuffer::upload(std::size_t set, const Held& spheres) {
  const SphereData& data = *spheres.data;
  const auto object = shared::uint(spheres.object);
  float objectBits;
  std::memcpy(&objectBits, &object, sizeof(objectBits));
  std::vector<shared::SceneSphere> records;
  records.reserve(data.centers.size());
  for (std::size_t i = 0; i < data.centers.size(); ++i) {
    const glm::vec3 color = data.colors.empty() ? glm::vec3(0.0f) : data.colors[i];
    records.push_back({{data.centers[i], data.radii[i]}, {color, objectBits}});
  }
  spheres_.upload(records.data(), records.size(), ranges_[set].first);
}

}  // namespace cdsm::build
