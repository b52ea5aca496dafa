// SPDX-License-Identifier: Apache-2.0
#include "build/sphere_buffer.hpp"

#include <cstring>

#include <cdsm/error.hpp>

namespace cdsm::build {

namespace {

void append(std::vector<shared::SceneSphere>& spheres, const SphereData& data, shared::uint object) {
  float objectBits;
  std::memcpy(&objectBits, &object, sizeof(objectBits));
  for (std::size_t i = 0; i < data.centers.size(); ++i) {
    const glm::vec3 color = data.colors.empty() ? glm::vec3(0.0f) : data.colors[i];
    spheres.push_back({{data.centers[i], data.radii[i]}, {color, objectBits}});
  }
}

}  // namespace

void SphereBuffer::update(const std::vector<Spheres>& sets, std::size_t firstObject) {
  std::vector<std::shared_ptr<const SphereData>> data;
  for (const Spheres& set : sets) data.push_back(set.data);
  if (spheres_.allocated() && data == data_ && firstObject == firstObject_) return;
  spheres_ = {};
  ranges_.clear();
  std::size_t count = 0;
  for (const auto& set : data) {
    ranges_.push_back({count, set->centers.size()});
    count += set->centers.size();
  }
  if (count > 0x3fffffffu) throw Error("the scene has " + std::to_string(count) + " spheres, must be below 2^30");
  std::vector<shared::SceneSphere> spheres;
  spheres.reserve(count);
  for (std::size_t i = 0; i < data.size(); ++i) append(spheres, *data[i], shared::uint(firstObject + i));
  spheres_ = device::Buffer<shared::SceneSphere>::fromHost(device_, spheres, "spheres");
  data_ = std::move(data);
  firstObject_ = firstObject;
}

}  // namespace cdsm::build
