// SPDX-License-Identifier: Apache-2.0
// The scene on the device: triangles, objects, media, transfer tables and macrocells (shared/scene_data.h).
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

#include "build/volume_slots.hpp"
#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "scene/view.hpp"
#include "shared/scene_data.h"

namespace cdsm::build {

class DeviceScene {
 public:
  explicit DeviceScene(device::Device& device) : device_(device), slots_(device) {}

  /// Uploads a valid scene. Voxels that the last scene used too are not uploaded again.
  void update(const Scene& scene);

  const VolumeSlots& slots() const { return slots_; }
  const device::Buffer<shared::uint4>& triangles() const { return triangles_; }
  const device::Buffer<float>& positions() const { return positions_; }
  const device::Buffer<shared::ObjectData>& objects() const { return objects_; }

  /// Arguments of CDSM_SCENE_PARAMS, in its order. `initialObjects`: the objects that contain the eye of the view.
  device::ArgumentList arguments(const device::Buffer<std::uint32_t>& initialObjects) const;

  /// Objects with media whose inside `pointWorld` is in; one that winds around it n times is listed n times.
  std::vector<std::uint32_t> objectsAround(const glm::vec3& pointWorld) const;

  /// Host copies, for techniques that build structures of their own.
  const std::vector<shared::uint4>& hostTriangles() const { return hostTriangles_; }
  const std::vector<float>& hostPositions() const { return hostPositions_; }
  const std::vector<shared::ObjectData>& hostObjects() const { return hostObjects_; }
  /// True for the box of a volume.
  bool isBox(std::size_t object) const { return objectMesh_[object] < 0; }
  /// Per medium, the object that encloses it.
  std::vector<std::uint32_t> objectsOfMedia() const;

  const scene::Bounds& bounds() const { return bounds_; }
  /// Ray step where a ray is in constant media only: fine enough for shadows in them and for their own fall-off.
  float interiorStep() const { return interiorStep_; }

 private:
  void clear();
  void addMesh(const Scene& scene, std::size_t index);
  void addBox(const Scene& scene, std::size_t index);
  void addVolumeMedium(const Scene& scene, const Volume& volume);
  void addTriangles(const MeshData& data, unsigned object, bool flip);
  void upload();
  /// Throws Error for a ray step given by the scene that would take more steps across it than a ray may take.
  void requireSteps() const;
  void classify(const shared::MediumData& medium);

  device::Device& device_;
  Scene scene_;  ///< what is on the device
  VolumeSlots slots_;
  scene::Bounds bounds_;
  float interiorStep_ = 0.0f;

  std::vector<shared::uint4> hostTriangles_;
  std::vector<float> hostPositions_, hostNormals_;
  std::vector<shared::ObjectData> hostObjects_;
  std::vector<int> objectMesh_;  ///< per object: its mesh, or -1 - volume for a volume's box
  std::vector<std::uint32_t> mediumLists_;
  std::vector<shared::MediumData> hostMedia_;
  std::vector<float> extinctionLut_;
  std::vector<shared::float4> colorLut_;
  std::size_t cellCount_ = 0;

  device::Buffer<shared::uint4> triangles_;
  device::Buffer<float> positions_, normals_;
  device::Buffer<shared::ObjectData> objects_;
  device::Buffer<std::uint32_t> lists_;
  device::Buffer<shared::MediumData> media_;
  device::Buffer<float> extinctions_;
  device::Buffer<shared::float4> colors_;
  device::Buffer<std::uint8_t> cells_, cellsBefore_;
};

}  // namespace cdsm::build
