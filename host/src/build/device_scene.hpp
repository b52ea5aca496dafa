// SPDX-License-Identifier: Apache-2.0
// The scene on the device: triangles, spheres, objects, media, transfer tables and macrocells (shared/scene_data.h).
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <cdsm/scene.hpp>

#include "build/extinction_curve.hpp"
#include "build/geometry.hpp"
#include "build/macrocell_pass.hpp"
#include "build/object_set.hpp"
#include "build/sphere_buffer.hpp"
#include "build/transfer_table.hpp"
#include "build/volume_slots.hpp"
#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "memory/spectrum.hpp"
#include "scene/view.hpp"
#include "shared/scene_data.h"

namespace cdsm::build {

/// The voxels of a volume as points in the world.
struct VolumeGrid {
  shared::Affine worldFromIndex;
  shared::uint cells;   ///< number of its macrocells
  shared::uint medium;  ///< number of its medium
};

class DeviceScene {
 public:
  explicit DeviceScene(device::Device& device)
      : device_(device), slots_(device), geometry_(device), spheres_(device), cells_(device) {}

  /// Uploads a valid scene. Voxels, triangles and spheres that the last scene used too are not uploaded again.
  void update(const Scene& scene);

  const VolumeSlots& slots() const { return slots_; }
  const Geometry& geometry() const { return geometry_; }
  const device::Buffer<shared::SceneSphere>& spheres() const { return spheres_.spheres(); }
  bool hasSpheres() const { return !scene_.spheres.empty(); }
  /// What is followed of light.
  const memory::Spectrum& spectrum() const { return memory::spectrumNamed(scene_.shadows.transmittance); }

  /// All objects, as the camera and points to be answered see them.
  const ObjectSet& allObjects() const { return all_; }
  /// What attenuates light if only these objects cast. Objects are numbered as in scene/objects.hpp.
  /// Valid until the next update().
  const ObjectSet& castingObjects(const std::vector<unsigned>& casters) const;

  /// Arguments of CDSM_SCENE_PARAMS, in its order. `initialObjects`: the objects that contain the eye of the view.
  device::ArgumentList arguments(const ObjectSet& set, const device::Buffer<std::uint32_t>& initialObjects) const;

  /// Those of `objects` whose inside `pointWorld` is in; one that winds around it n times is listed n times.
  std::vector<std::uint32_t> objectsAround(const std::vector<std::uint32_t>& objects,
                                           const glm::vec3& pointWorld) const;

  /// Host copy, for techniques that build structures of their own.
  const std::vector<shared::ObjectData>& hostObjects() const { return hostObjects_; }
  /// Per medium, the object that encloses it.
  std::vector<std::uint32_t> objectsOfMedia() const;
  /// Per medium, the extinction above which a sample's opacity is over `threshold`: that of a volume per its unit
  /// distance, of an interior per world unit. Infinite where no opacity gets over it, capped as it is.
  std::vector<float> opaqueExtinctions(float threshold) const;

  std::size_t mediumCount() const { return hostMedia_.size(); }
  /// Of all volumes.
  const std::vector<VolumeGrid>& volumeGrids() const { return grids_; }
  /// Blocks of CDSM_SHADOW_BLOCK voxels that hold a value for each voxel of each volume.
  std::size_t shadowBlocks() const { return shadowBlocks_; }

  /// Per medium and channel, where light is attenuated.
  std::vector<ExtinctionCurve> curves() const;
  /// The same as tables of all volumes, a Spectrum for each entry, see MediumData::lutOffset.
  const device::Buffer<float>& lightExtinctions() const { return lightExtinctions_; }

  const scene::Bounds& bounds() const { return bounds_; }

 private:
  void clear();
  void addMesh(const Scene& scene, std::size_t index);
  void addBox(const Scene& scene, std::size_t index);
  void addSpheres(const Scene& scene, const Spheres& spheres);
  void addVolumeMedium(const Scene& scene, const Volume& volume);
  void addTables(const TransferTable& table);
  /// Whether no light gets past a crossing of its surface, of none of its colours.
  bool hidesLight(const shared::ObjectData& object) const;
  void updateBounds();
  void upload();
  /// `former`: of the same objects in the scene before, whose buffers it takes over.
  ObjectSet makeSet(ObjectSet former, const std::vector<shared::ObjectData>& objects,
                    const std::vector<std::uint32_t>& lists, float interiorStep) const;
  /// Throws Error for a ray step given by the scene that would take more steps across it than a ray may take.
  void requireSteps() const;

  device::Device& device_;
  Scene scene_;  ///< what is on the device
  VolumeSlots slots_;
  Geometry geometry_;
  SphereBuffer spheres_;
  ObjectSet all_;
  mutable std::map<std::vector<unsigned>, ObjectSet> casting_;  ///< of the last scenes, by casters
  scene::Bounds bounds_;

  /// What an object's bounds were computed from.
  struct KnownBounds {
    std::shared_ptr<const void> data;
    std::uint64_t revision = 0;
    glm::mat4 worldFromObject{1.0f};
    scene::Bounds bounds;
  };
  template <class Data>
  void addBounds(std::size_t object, const std::shared_ptr<const Data>& data, std::uint64_t revision,
                 const glm::mat4& worldFromObject);
  std::vector<KnownBounds> objectBounds_;
  std::vector<ObjectTriangles> objectTriangles_;
  std::vector<shared::ObjectData> hostObjects_;
  std::vector<std::uint32_t> mediumLists_;
  std::vector<shared::MediumData> hostMedia_;
  std::vector<unsigned> mediumOwner_;            ///< per medium: the object whose role it has, a mesh or a volume's box
  std::vector<ExtinctionCurve> curves_;          ///< of grey light
  std::vector<float> extinctionLut_, lightLut_;  ///< as the camera sees it, and where light is attenuated
  std::vector<float> eitherLut_;                 ///< the larger of both
  std::vector<shared::float4> colorLut_;
  std::size_t cellCount_ = 0;
  std::vector<VolumeGrid> grids_;
  std::size_t shadowBlocks_ = 0;

  device::Mirror<shared::MediumData> media_;
  device::Mirror<float> extinctions_, lightExtinctions_;
  device::Mirror<shared::float4> colors_;
  MacrocellPass cells_;
};

}  // namespace cdsm::build
