// SPDX-License-Identifier: Apache-2.0
#include "build/device_scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/gtc/matrix_access.hpp>

#include "build/unit_cube.hpp"
#include "scene/closed_mesh.hpp"
#include "scene/objects.hpp"
#include "scene/range.hpp"

namespace cdsm::build {

namespace {

/// Sets of casters whose buffers are kept for the next scenes.
constexpr std::size_t kMostCastingSets = 64;

shared::Affine affineOf(const glm::mat4& m) {
  const auto row = [&](int i) {
    const glm::vec4 r = glm::row(m, i);
    return shared::float4(glm::vec3(r), r.w);
  };
  return {row(0), row(1), row(2)};
}

/// Smallest edge of a voxel in world units.
float voxelEdge(const glm::mat4& worldFromIndex) {
  float edge = INFINITY;
  for (int i = 0; i < 3; ++i) edge = std::min(edge, glm::length(glm::vec3(worldFromIndex[i])));
  return edge;
}

/// Six times the enclosed volume in object space, positive if triangles run counter-clockwise seen from outside.
double signedVolume(const MeshData& data) {
  double sum = 0.0;
  for (const glm::uvec3& t : data.triangles) {
    const glm::dvec3 a(data.positions[t.x]), b(data.positions[t.y]), c(data.positions[t.z]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum;
}

/// Boxes of the volumes follow the meshes.
unsigned boxObject(const Scene& scene, const Volume& volume) {
  return unsigned(scene.meshes.size() + std::size_t(&volume - scene.volumes.data()));
}

/// Fine enough for shadows in constant media of at most `extinction` and for their own fall-off.
float interiorStepOf(const ShadowSettings& shadows, float extinction, float diagonal) {
  if (shadows.step > 0.0f) return shadows.step;
  // linear nodes between samples of exp(-tau) are off by at most (step of tau)^2 / 8
  const float opticalStep = 0.5f * std::sqrt(8.0f * std::max(shadows.tolerance, 1e-3f));
  const float most = std::max(diagonal, 1e-20f), step = most / 512.0f;
  return extinction > 0.0f ? std::clamp(opticalStep / extinction, most / float(CDSM_MOST_STEPS), step) : step;
}

void setMaterial(shared::ObjectData& object, const Material& material) {
  object.diffuse = {material.diffuse, material.opacity};
  object.specular = {material.specular, material.shininess};
  object.transmission = {material.transmission, 0.0f};
  object.hides = material.opacity >= 1.0f;
}

/// Joined with the range before it if they are neighbours.
void addRange(std::vector<PrimitiveRange>& ranges, const PrimitiveRange& range) {
  if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first)
    ranges.back().count += range.count;
  else
    ranges.push_back(range);
}

}  // namespace

void DeviceScene::clear() {
  objectTriangles_.clear();
  hostObjects_.clear();
  mediumLists_.clear();
  hostMedia_.clear();
  mediumOwner_.clear();
  curves_.clear();
  extinctionLut_.clear();
  lightLut_.clear();
  eitherLut_.clear();
  colorLut_.clear();
  cellCount_ = 0;
  grids_.clear();
  shadowBlocks_ = 0;
}

void DeviceScene::addVolumeMedium(const Scene& scene, const Volume& volume) {
  const glm::mat4 worldFromIndex = scene::worldFromIndex(volume);
  TransferFunction transfer = volume.transfer;
  if (spectrum().channels == 1) transfer.transmission.clear();
  const TransferTable table = makeTransferTable(transfer);
  const glm::uvec3 size = volume.data->size, cells = cellCounts(*volume.data);
  shared::MediumData medium{};
  medium.indexFromWorld = affineOf(glm::mat4(glm::inverse(glm::dmat4(worldFromIndex))));
  medium.specular = {volume.specular, volume.shininess};
  medium.size = {int(size.x), int(size.y), int(size.z), slots_.slotOf(volume.data.get())};
  medium.cells = {int(cells.x), int(cells.y), int(cells.z), int(cellCount_)};
  medium.lutScale = table.scale;
  medium.lutBias = table.bias;
  medium.lutOffset = shared::uint(colorLut_.size());
  medium.lutLast = shared::uint(table.entries.size() - 1);
  medium.step = scene.shadows.step > 0.0f ? scene.shadows.step : 0.5f * voxelEdge(worldFromIndex);
  medium.shading = volume.shading;
  medium.receives = volume.shadow.receives;
  medium.boxObject = volume.boundary < 0 ? ~0u : boxObject(scene, volume);
  medium.firstShadowBlock = shared::uint(shadowBlocks_);
  grids_.push_back({affineOf(worldFromIndex), cells.x * cells.y * cells.z, shared::uint(hostMedia_.size())});
  shadowBlocks_ += (std::size_t(size.x) * size.y * size.z + CDSM_SHADOW_BLOCK - 1) / CDSM_SHADOW_BLOCK;
  addTables(table);
  colorLut_.insert(colorLut_.end(), table.entries.begin(), table.entries.end());
  cellCount_ += std::size_t(cells.x) * cells.y * cells.z;
  mediumLists_.push_back(shared::uint(hostMedia_.size()));
  hostMedia_.push_back(medium);
  curves_.push_back(makeExtinctionCurve(volume.transfer.towardsLights(), volume.transfer.unitDistance));
  mediumOwner_.push_back(boxObject(scene, volume));
}

void DeviceScene::addTables(const TransferTable& table) {
  const bool colored = spectrum().channels > 1;
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const shared::float4& light = table.towardsLights[i];
    extinctionLut_.push_back(table.entries[i].w);
    eitherLut_.push_back(std::max(table.entries[i].w, light.w));
    if (colored)
      lightLut_.insert(lightLut_.end(), {light.x, light.y, light.z, 0.0f});
    else
      lightLut_.push_back(light.w);
  }
}

void DeviceScene::addMesh(const Scene& scene, std::size_t index) {
  const Mesh& mesh = scene.meshes[index];
  const Material& material = scene.materials[mesh.material];
  shared::ObjectData object{};
  object.worldFromObject = affineOf(mesh.worldFromObject);
  setMaterial(object, material);
  object.firstMedium = shared::uint(mediumLists_.size());
  object.hasNormals = !mesh.data->normals.empty();
  object.casts = mesh.shadow.casts;
  object.receives = mesh.shadow.receives;
  if (mesh.interiorExtinction > 0.0f) {
    shared::MediumData medium{};
    medium.interior = {mesh.interiorColor, mesh.interiorExtinction};
    medium.attenuation = {mesh.interiorExtinction * (1.0f - mesh.interiorTransmission), 0.0f};
    medium.size.w = -1;
    medium.boxObject = ~0u;
    medium.receives = mesh.shadow.receives;
    mediumLists_.push_back(shared::uint(hostMedia_.size()));
    hostMedia_.push_back(medium);
    curves_.emplace_back();
    mediumOwner_.push_back(unsigned(index));
  }
  for (const Volume& volume : scene.volumes)
    if (volume.boundary == int(index)) addVolumeMedium(scene, volume);
  object.mediumCount = shared::uint(mediumLists_.size()) - object.firstMedium;
  object.encloses = object.mediumCount > 0;
  // entering and leaving are told by the turn of the triangles, so what encloses media must turn outwards
  const bool inward = object.mediumCount > 0 &&
                      (signedVolume(*mesh.data) < 0.0) != (glm::determinant(glm::mat3(mesh.worldFromObject)) < 0.0f);
  objectTriangles_.push_back({mesh.data, mesh.revision, inward});
  hostObjects_.push_back(object);
}

void DeviceScene::addBox(const Scene& scene, std::size_t index) {
  const Volume& volume = scene.volumes[index];
  const glm::mat4 matrix = worldFromUnitCube(volume);
  shared::ObjectData object{};
  object.worldFromObject = affineOf(matrix);
  object.firstMedium = shared::uint(mediumLists_.size());
  object.encloses = 1;
  object.casts = volume.shadow.casts;
  object.receives = volume.shadow.receives;
  if (volume.boundary < 0) {
    object.mediumCount = 1;
    addVolumeMedium(scene, volume);
  }
  objectTriangles_.push_back({unitCube(), 0, glm::determinant(glm::mat3(matrix)) < 0.0f});
  hostObjects_.push_back(object);
}

void DeviceScene::addSpheres(const Scene& scene, const Spheres& spheres) {
  const Material& material = scene.materials[std::size_t(spheres.material)];
  shared::ObjectData object{};
  object.worldFromObject = affineOf(spheres.worldFromObject);
  setMaterial(object, material);
  object.casts = spheres.shadow.casts;
  object.receives = spheres.shadow.receives;
  object.hasColors = !spheres.data->colors.empty();
  hostObjects_.push_back(object);
}

void DeviceScene::update(const Scene& scene) {
  clear();
  slots_.update(scene.volumes);
  scene_ = scene;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) addMesh(scene, i);
  for (std::size_t i = 0; i < scene.volumes.size(); ++i) addBox(scene, i);
  for (const Spheres& spheres : scene.spheres) addSpheres(scene, spheres);
  updateBounds();
  geometry_.update(objectTriangles_);
  spheres_.update(scene.spheres, scene::firstSpheres(scene));
  upload();
  cells_.run(slots_, hostMedia_, eitherLut_, curves_);  // empty on the way to the camera and to lights
  requireSteps();
}

template <class Data>
void DeviceScene::addBounds(std::size_t object, const std::shared_ptr<const Data>& data, std::uint64_t revision,
                            const glm::mat4& worldFromObject) {
  KnownBounds& known = objectBounds_[object];
  if (known.data != data || known.revision != revision || known.worldFromObject != worldFromObject)
    known = {data, revision, worldFromObject, scene::boundsOf(*data, worldFromObject)};
  bounds_.add(known.bounds);
}

void DeviceScene::updateBounds() {
  objectBounds_.resize(hostObjects_.size());
  bounds_ = {};
  std::size_t object = 0;
  for (const Mesh& mesh : scene_.meshes) addBounds(object++, mesh.data, mesh.revision, mesh.worldFromObject);
  for (const Volume& volume : scene_.volumes) addBounds(object++, unitCube(), 0, worldFromUnitCube(volume));
  for (const Spheres& spheres : scene_.spheres)
    addBounds(object++, spheres.data, spheres.revision, spheres.worldFromObject);
}

void DeviceScene::requireSteps() const {
  const float step = scene_.shadows.step, least = bounds_.diagonal() / float(CDSM_MOST_STEPS);
  if (hostMedia_.empty() || step <= 0.0f || step >= least) return;
  throw Error("the ray step is " + scene::formatNumber(step) + " world units, must be at least " +
              scene::formatNumber(least) + " in a scene of this size, or 0 for steps chosen by the engine");
}

void DeviceScene::upload() {
  media_.follow(device_, hostMedia_, "media");
  extinctions_.follow(device_, extinctionLut_, "extinction tables");
  lightExtinctions_.follow(device_, lightLut_, "extinction tables of light");
  colors_.follow(device_, colorLut_, "colour tables");
  if (casting_.size() > kMostCastingSets || hostObjects_.empty()) casting_.clear();
  float extinction = 0.0f;
  for (const Mesh& mesh : scene_.meshes) extinction = std::max(extinction, mesh.interiorExtinction);
  all_ = makeSet(std::move(all_), hostObjects_, mediumLists_,
                 interiorStepOf(scene_.shadows, extinction, bounds_.diagonal()));
}

ObjectSet DeviceScene::makeSet(ObjectSet former, const std::vector<shared::ObjectData>& objects,
                               const std::vector<std::uint32_t>& lists, float interiorStep) const {
  ObjectSet set = std::move(former);
  set.triangles.clear();
  set.spheres.clear();
  set.enclosing.clear();
  set.interiorStep = interiorStep;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].encloses) set.enclosing.push_back(std::uint32_t(i));
    if (!objects[i].encloses && objects[i].diffuse.w <= 0.0f) continue;
    const scene::ObjectPlace place = scene::placeOf(scene_, i);
    if (place.kind == scene::ObjectKind::Spheres)
      addRange(set.spheres, spheres_.rangeOf(place.index));
    else
      addRange(set.triangles, geometry_.rangeOf(i));
  }
  set.objects.follow(device_, objects, "objects");
  set.lists.follow(device_, lists, "lists of media");
  return set;
}

bool DeviceScene::hidesLight(const shared::ObjectData& object) const {
  const shared::float4& t = object.transmission;
  const bool colored = spectrum().channels > 1 && (t.x > 0.0f || t.y > 0.0f || t.z > 0.0f);
  return object.diffuse.w >= 1.0f && !colored;
}

const ObjectSet& DeviceScene::castingObjects(const std::vector<unsigned>& casters) const {
  std::vector<bool> casts(hostObjects_.size(), false), encloses(hostObjects_.size(), false);
  scene::Bounds bounds;
  float extinction = 0.0f;
  for (const unsigned object : casters) {
    casts[object] = true;
    bounds.add(objectBounds_[object].bounds);
    if (object < scene_.meshes.size()) extinction = std::max(extinction, scene_.meshes[object].interiorExtinction);
  }
  std::vector<shared::ObjectData> objects = hostObjects_;
  std::vector<std::uint32_t> lists;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    shared::ObjectData& object = objects[i];
    if (!casts[i]) object.diffuse.w = 0.0f;
    object.hides = casts[i] && hidesLight(object);
    const auto first = shared::uint(lists.size());
    for (unsigned k = 0; k < object.mediumCount; ++k) {
      const std::uint32_t medium = mediumLists_[object.firstMedium + k];
      if (!casts[mediumOwner_[medium]]) continue;
      lists.push_back(medium);
      encloses[i] = true;
      if (hostMedia_[medium].boxObject != ~0u) encloses[hostMedia_[medium].boxObject] = true;
    }
    object.firstMedium = first;
    object.mediumCount = shared::uint(lists.size()) - first;
  }
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].encloses = encloses[i];
  ObjectSet& set = casting_[casters];
  set = makeSet(std::move(set), objects, lists, interiorStepOf(scene_.shadows, extinction, bounds.diagonal()));
  set.towardsLight = true;
  return set;
}

device::ArgumentList DeviceScene::arguments(const ObjectSet& set,
                                            const device::Buffer<std::uint32_t>& initialObjects) const {
  device::ArgumentList list{geometry_.triangles().cl(),
                            geometry_.positions().cl(),
                            geometry_.normals().cl(),
                            spheres_.spheres().cl(),
                            set.objects.cl(),
                            set.lists.cl(),
                            media_.cl(),
                            set.towardsLight ? lightExtinctions_.cl() : extinctions_.cl(),
                            colors_.cl(),
                            cells_.cells().cl(),
                            initialObjects.cl()};
  const device::ArgumentList volumes = slots_.arguments();
  list.insert(list.end(), volumes.begin(), volumes.end());
  return list;
}

std::vector<std::uint32_t> DeviceScene::objectsAround(const std::vector<std::uint32_t>& objects,
                                                      const glm::vec3& pointWorld) const {
  std::vector<std::uint32_t> around;
  for (const std::uint32_t i : objects) {
    if (!objectBounds_[i].bounds.contains(pointWorld)) continue;
    long times = 0;
    if (i < scene_.meshes.size()) {
      const Mesh& m = scene_.meshes[i];
      times = std::lround(std::abs(scene::windingNumber(*m.data, m.worldFromObject, pointWorld)));
    } else {
      const glm::dmat4 unitFromWorld =
          glm::inverse(glm::dmat4(worldFromUnitCube(scene_.volumes[i - scene_.meshes.size()])));
      const glm::dvec3 p(unitFromWorld * glm::dvec4(pointWorld, 1.0));
      times = glm::all(glm::greaterThan(p, glm::dvec3(0.0))) && glm::all(glm::lessThan(p, glm::dvec3(1.0)));
    }
    around.insert(around.end(), std::size_t(times), i);
  }
  return around;
}

std::vector<ExtinctionCurve> DeviceScene::curves() const {
  if (spectrum().channels == 1) return curves_;
  std::vector<ExtinctionCurve> curves;
  for (const unsigned owner : mediumOwner_) {
    const scene::ObjectPlace place = scene::placeOf(scene_, owner);
    for (int channel = 0; channel < int(spectrum().channels); ++channel)
      curves.push_back(place.kind == scene::ObjectKind::Volume
                           ? makeAttenuationCurve(scene_.volumes[place.index].transfer, channel)
                           : ExtinctionCurve());
  }
  return curves;
}

std::vector<std::uint32_t> DeviceScene::objectsOfMedia() const {
  std::vector<std::uint32_t> objects(hostMedia_.size());
  for (std::size_t i = 0; i < hostObjects_.size(); ++i)
    for (unsigned k = 0; k < hostObjects_[i].mediumCount; ++k)
      objects[mediumLists_[hostObjects_[i].firstMedium + k]] = std::uint32_t(i);
  return objects;
}

std::vector<float> DeviceScene::opaqueExtinctions(float threshold) const {
  std::vector<float> extinctions;
  for (std::size_t i = 0; i < hostMedia_.size(); ++i) {
    const scene::ObjectPlace place = scene::placeOf(scene_, mediumOwner_[i]);
    const float unitDistance =
        place.kind == scene::ObjectKind::Volume ? scene_.volumes[place.index].transfer.unitDistance : 1.0f;
    extinctions.push_back(threshold < kMostOpacity ? extinctionOf(threshold, unitDistance) : INFINITY);
  }
  return extinctions;
}

}  // namespace cdsm::build
