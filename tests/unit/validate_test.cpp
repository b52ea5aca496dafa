// SPDX-License-Identifier: Apache-2.0
// validate(): a small scene that is right, and one change at a time that makes it wrong.
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cdsm/error.hpp>
#include <cdsm/scene.hpp>

#include "reference/parts.hpp"
#include "scene/transform.hpp"

namespace cdsm {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

MeshData tetrahedron() {
  reference::MeshParts mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

MeshData openMesh() {
  reference::MeshParts mesh = reference::partsOf(tetrahedron());
  mesh.triangles.pop_back();
  return mesh;
}

VolumeData smallGrid() {
  VolumeData grid;
  grid.type = VoxelType::Float32;
  grid.size = {2, 3, 4};
  grid.voxels.resize(2 * 3 * 4 * 4);
  return grid;
}

template <typename Data>
std::shared_ptr<const Data> share(Data data) {
  return std::make_shared<const Data>(std::move(data));
}

Scene goodScene() {
  Scene scene;
  scene.lights = {{"key"}};
  scene.materials = {{"glass"}};
  scene.meshes = {{"cup", share(tetrahedron())}};
  Volume smoke;
  smoke.name = "smoke";
  smoke.data = share(smallGrid());
  smoke.transfer.opacity = {{0.0f, 0.0f}, {1.0f, 0.5f}};
  smoke.transfer.color = {{0.0f, {1, 1, 1}}};
  scene.volumes = {smoke};
  return scene;
}

/// The message for the good scene after `change`, or "" when it is still good.
std::string complaint(const std::function<void(Scene&)>& change) {
  Scene scene = goodScene();
  change(scene);
  try {
    validate(scene);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

struct Case {
  std::string part;  ///< of the message
  std::function<void(Scene&)> change;
};

void expectComplaints(const std::vector<Case>& cases) {
  for (const Case& wrong : cases) {
    const std::string message = complaint(wrong.change);
    EXPECT_NE(message.find(wrong.part), std::string::npos) << "'" << message << "' lacks '" << wrong.part << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(Validate, AGoodSceneAndAnEmptyOneAreGood) {
  EXPECT_EQ(complaint([](Scene&) {}), "");
  EXPECT_EQ(complaint([](Scene& s) { s = Scene(); }), "");
}

TEST(Validate, ALightInsideAVolumeIsGood) {
  EXPECT_EQ(complaint([](Scene& s) { s.lights[0].position = {0.5f, 1.0f, 1.5f}; }), "");
}

TEST(Validate, CameraAndImage) {
  expectComplaints({
      {"camera: position and target are the same", [](Scene& s) { s.camera.position = s.camera.target; }},
      {"parallel to the view",
       [](Scene& s) {
         s.camera.up = {0, 0, -2};
       }},
      {"camera up has no length",
       [](Scene& s) {
         s.camera.up = {0, 0, 0};
       }},
      {"camera fov is 0, must be in (0, 180) degrees", [](Scene& s) { s.camera.fov = 0.0f; }},
      {"camera fov is 180", [](Scene& s) { s.camera.fov = 180.0f; }},
      {"camera fov is nan", [](Scene& s) { s.camera.fov = kNan; }},
      {"camera position is inf", [](Scene& s) { s.camera.position.y = kInfinity; }},
      {"camera target is 1e+10", [](Scene& s) { s.camera.target.x = 1e10f; }},
      {"image width is 0, must be in [1, 16384]", [](Scene& s) { s.image.width = 0; }},
      {"image height is 16385", [](Scene& s) { s.image.height = 16385; }},
      {"supersampling is 9, must be in [1, 8]", [](Scene& s) { s.image.supersampling = 9; }},
      {"ambient is -1", [](Scene& s) { s.image.ambient.g = -1.0f; }},
      {"background is nan", [](Scene& s) { s.image.background.b = kNan; }},
  });
}

TEST(Validate, ShadowsAndLights) {
  expectComplaints({
      {"map_size is 7, must be in [8, 16384]", [](Scene& s) { s.shadows.mapSize = 7; }},
      {"unorm16 is 1e-05, must be in [2e-05, 1)",
       [](Scene& s) {
         s.shadows.nodeFormat = "unorm16";
         s.shadows.tolerance = 1e-5f;
       }},
      {"node_format is 'half'", [](Scene& s) { s.shadows.nodeFormat = "half"; }},
      {"tolerance is 1, must be in [0, 1)", [](Scene& s) { s.shadows.tolerance = 1.0f; }},
      {"clusters is 0, must be in [1, 64]", [](Scene& s) { s.shadows.clusters = 0; }},
      {"clusters is 65", [](Scene& s) { s.shadows.clusters = 65; }},
      {"cluster_distance is 0, must be in (0, 2.83]", [](Scene& s) { s.shadows.clusterDistance = 0.0f; }},
      {"cluster_distance is nan", [](Scene& s) { s.shadows.clusterDistance = kNan; }},
      {"step is -1, must be at least 0", [](Scene& s) { s.shadows.step = -1.0f; }},
      {"bias is nan", [](Scene& s) { s.shadows.bias = kNan; }},
      {"filter is 'cubic', must be bilinear or nearest", [](Scene& s) { s.shadows.filter = "cubic"; }},
      {"light 'key': position and target", [](Scene& s) { s.lights[0].position = s.lights[0].target; }},
      {"light 'key': cutoff is 90, must be in (0, 90)", [](Scene& s) { s.lights[0].cutoff = 90.0f; }},
      {"light 'key': color is nan", [](Scene& s) { s.lights[0].color.r = kNan; }},
  });
}

TEST(Validate, LightsOfOtherTypes) {
  const auto typed = [](LightType type, const std::function<void(Light&)>& change) {
    return [=](Scene& s) {
      s.lights[0].type = type;
      change(s.lights[0]);
    };
  };
  expectComplaints({
      {"light 'key': direction has no length, must be a direction",
       typed(LightType::Directional, [](Light& l) { l.direction = glm::vec3(0.0f); })},
      {"light 'key': direction is nan", typed(LightType::Directional, [](Light& l) { l.direction.y = kNan; })},
      {"light 'key': position is inf", typed(LightType::Omni, [](Light& l) { l.position.y = kInfinity; })},
  });
  // what is of other types does not matter
  EXPECT_EQ(complaint(typed(LightType::Omni, [](Light& l) { l.target = l.position; })), "");
  EXPECT_EQ(complaint(typed(LightType::Directional, [](Light& l) { l.cutoff = -1.0f; })), "");
}

TEST(Validate, MaterialsAndMeshes) {
  expectComplaints({
      {"material 'glass': opacity is 1.5, must be in [0, 1]", [](Scene& s) { s.materials[0].opacity = 1.5f; }},
      {"material 'glass': shininess is -1", [](Scene& s) { s.materials[0].shininess = -1.0f; }},
      {"mesh 'cup': material index is 1", [](Scene& s) { s.meshes[0].material = 1; }},
      {"mesh 'cup': material index is -1", [](Scene& s) { s.meshes[0].material = -1; }},
      {"mesh 'cup' has no data", [](Scene& s) { s.meshes[0].data.reset(); }},
      {"cannot be inverted", [](Scene& s) { s.meshes[0].worldFromObject[1] = glm::vec4(0.0f); }},
      {"cannot be inverted", [](Scene& s) { s.meshes[0].worldFromObject[0][3] = 0.1f; }},
      {"cannot be inverted", [](Scene& s) { s.meshes[0].worldFromObject[2][2] = kNan; }},
      {"mesh 'cup' has 3 open edges, must be closed to have an interior_extinction",
       [](Scene& s) {
         s.meshes[0].data = share(openMesh());
         s.meshes[0].interiorExtinction = 1.0f;
       }},
  });
  EXPECT_EQ(complaint([](Scene& s) { s.meshes[0].interiorExtinction = 1.0f; }), "");
  EXPECT_EQ(complaint([](Scene& s) { s.meshes[0].data = share(openMesh()); }), "") << "without an interior";
}

TEST(Validate, ShadowRoles) {
  expectComplaints({
      {"mesh 'cup': cluster_weight is 0, must be in (0, 1000]", [](Scene& s) { s.meshes[0].shadow.weight = 0.0f; }},
      {"mesh 'cup': cluster_weight is inf", [](Scene& s) { s.meshes[0].shadow.weight = kInfinity; }},
      {"volume 'smoke': cluster_weight is -1", [](Scene& s) { s.volumes[0].shadow.weight = -1.0f; }},
      {"volume 'smoke': cluster_weight is nan", [](Scene& s) { s.volumes[0].shadow.weight = kNan; }},
  });
  EXPECT_EQ(complaint([](Scene& s) { s.meshes[0].shadow = s.volumes[0].shadow = {false, false, 1000.0f}; }), "");
}

TEST(Validate, Spheres) {
  const auto with = [](const std::function<void(Spheres&, reference::SphereParts&)>& change) {
    return [change](Scene& s) {
      reference::SphereParts data{{{0, 0, 0}, {1, 0, 0}}, {0.5f, 0.2f}, {}};
      Spheres spheres;
      spheres.name = "atoms";
      change(spheres, data);
      spheres.data = std::make_shared<const SphereData>(data);
      s.spheres = {spheres};
    };
  };
  expectComplaints({
      {"spheres 'atoms' have no data", [](Scene& s) { s.spheres.resize(1), s.spheres[0].name = "atoms"; }},
      {"spheres 'atoms' has no spheres", with([](Spheres&, reference::SphereParts& d) { d = {}; })},
      {"has 1 radii for 2 centres", with([](Spheres&, reference::SphereParts& d) { d.radii.pop_back(); })},
      {"has 1 colours for 2 centres", with([](Spheres&, reference::SphereParts& d) { d.colors.resize(1); })},
      {"radius 1 is 0, must be above 0", with([](Spheres&, reference::SphereParts& d) { d.radii[1] = 0.0f; })},
      {"radius 0 is nan", with([](Spheres&, reference::SphereParts& d) { d.radii[0] = kNan; })},
      {"radius 0 is inf", with([](Spheres&, reference::SphereParts& d) { d.radii[0] = kInfinity; })},
      {"centre 1 is not finite", with([](Spheres&, reference::SphereParts& d) { d.centers[1].y = kInfinity; })},
      {"colour 1 is -1", with([](Spheres&, reference::SphereParts& d) {
         d.colors = {{1, 1, 1}, {1, -1, 1}};
       })},
      {"material index is 7", with([](Spheres& s, reference::SphereParts&) { s.material = 7; })},
      {"cluster_weight is 0", with([](Spheres& s, reference::SphereParts&) { s.shadow.weight = 0.0f; })},
      {"cannot be inverted", with([](Spheres& s, reference::SphereParts&) { s.worldFromObject[1] = glm::vec4(0.0f); })},
      {"must scale all axes alike", with([](Spheres& s, reference::SphereParts&) { s.worldFromObject[1][1] = 1.01f; })},
      {"must scale all axes alike", with([](Spheres& s, reference::SphereParts&) { s.worldFromObject[1][0] = 0.01f; })},
      {"its lowest coordinate in the world is -2e+09",
       with([](Spheres&, reference::SphereParts& d) { d.radii[0] = 2e9f; })},
  });
  EXPECT_EQ(complaint(with([](Spheres& s, reference::SphereParts&) {
              s.worldFromObject = scene::composeTransform({1, 2, 3}, {1, 1, 0}, 33.0f, glm::vec3(-2.0f));
            })),
            "");
}

TEST(Validate, MeshData) {
  const auto changed = [](const std::function<void(reference::MeshParts&)>& change) {
    return [change](Scene& s) {
      reference::MeshParts mesh = reference::partsOf(tetrahedron());
      change(mesh);
      s.meshes[0].data = share(MeshData(mesh));
    };
  };
  expectComplaints({
      {"triangle 2 has the index 4, must be below the number of positions, 4",
       changed([](reference::MeshParts& m) { m.triangles[2].y = 4; })},
      {"has 1 normals for 4 positions", changed([](reference::MeshParts& m) { m.normals.resize(1); })},
      {"position 3 is not finite", changed([](reference::MeshParts& m) { m.positions[3].z = kNan; })},
      {"mesh 'cup': its highest coordinate in the world is 2e+09, must be in [-1e+09, 1e+09]",
       changed([](reference::MeshParts& m) { m.positions[3].z = 2e9f; })},
      {"has no triangles", changed([](reference::MeshParts& m) { m.triangles.clear(); })},
  });
}

TEST(Validate, Volumes) {
  const auto changed = [](const std::function<void(VolumeData&)>& change) {
    return [change](Scene& s) {
      VolumeData grid = smallGrid();
      change(grid);
      s.volumes[0].data = share(grid);
    };
  };
  expectComplaints({
      {"has 96 bytes for 2 x 3 x 5 voxels, must be 120", changed([](VolumeData& v) { v.size.z = 5; })},
      {"has 0 x 3 x 4 voxels", changed([](VolumeData& v) { v.size.x = 0; })},
      {"must be at least one along each axis and fit memory", changed([](VolumeData& v) { v.size = glm::uvec3(~0u); })},
      {"axes span no space", changed([](VolumeData& v) { v.objectFromIndex[0] = v.objectFromIndex[1]; })},
      {"volume 'smoke': its lowest coordinate in the world is -5e+09, must be in [-1e+09, 1e+09]",
       changed([](VolumeData& v) { v.objectFromIndex[1][1] = 1e10f; })},
      {"voxel 1 is not finite",
       changed([](VolumeData& v) { v.voxels[6] = v.voxels[7] = std::byte{0xff}; })},  // bytes 4 to 7: a NaN
      {"volume 'smoke' has no data", [](Scene& s) { s.volumes[0].data.reset(); }},
      {"boundary index is 1", [](Scene& s) { s.volumes[0].boundary = 1; }},
      {"must be closed to be the boundary of volume 'smoke'",
       [](Scene& s) {
         s.meshes[0].data = share(openMesh());
         s.volumes[0].boundary = 0;
       }},
  });
}

TEST(Validate, TransferFunctions) {
  expectComplaints({
      {"opacity has no points", [](Scene& s) { s.volumes[0].transfer.opacity.clear(); }},
      {"opacity is 2, must be in [0, 1]", [](Scene& s) { s.volumes[0].transfer.opacity[1].opacity = 2.0f; }},
      {"value 0 follows 1, must be ascending",
       [](Scene& s) {
         s.volumes[0].transfer.opacity = {{1.0f, 0.0f}, {0.0f, 0.0f}};
       }},
      {"color is nan", [](Scene& s) { s.volumes[0].transfer.color[0].color.r = kNan; }},
      {"unit_distance is 0, must be above 0", [](Scene& s) { s.volumes[0].transfer.unitDistance = 0.0f; }},
  });
  EXPECT_EQ(complaint([](Scene& s) { s.volumes[0].transfer.opacity = {{1.0f, 0.0f}, {1.0f, 0.5f}}; }), "");
}

TEST(Error, IsOneLineWithItsPlace) {
  EXPECT_STREQ(Error({"a.toml", 3, 7}, "wrong\nname").what(), "a.toml:3:7: wrong name");
  EXPECT_STREQ(Error({"a.toml", 0, 0}, "wrong").what(), "a.toml: wrong");
  EXPECT_EQ(Error({"a.toml", 3, 7}, "wrong").message(), "wrong");
  EXPECT_FALSE(Error("wrong").where().has_value());
}

TEST(VoxelType, HasItsBytes) {
  EXPECT_EQ(voxelBytes(VoxelType::Int8), 1u);
  EXPECT_EQ(voxelBytes(VoxelType::UInt16), 2u);
  EXPECT_EQ(voxelBytes(VoxelType::Float32), 4u);
}

}  // namespace
}  // namespace cdsm
