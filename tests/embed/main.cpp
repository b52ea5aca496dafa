// SPDX-License-Identifier: Apache-2.0
// The library without tool and files: a scene filled in by hand, an image, transmittances. A light shines down through
// two translucent squares; 0.5 * 0.75 of it must arrive below both. Exit status 0 if it does.
#include <cmath>
#include <cstdio>
#include <memory>

#include <cdsm/cdsm.hpp>

namespace {

/// A square of 4 x 4 world units at a height.
cdsm::Mesh square(const char* name, float height, int material) {
  cdsm::MeshData data;
  data.positions = {{-2.0f, 0.0f, -2.0f}, {-2.0f, 0.0f, 2.0f}, {2.0f, 0.0f, 2.0f}, {2.0f, 0.0f, -2.0f}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  cdsm::Mesh mesh;
  mesh.name = name;
  mesh.data = std::make_shared<cdsm::MeshData>(data);
  mesh.material = material;
  mesh.worldFromObject[3] = {0.0f, height, 0.0f, 1.0f};
  return mesh;
}

cdsm::Material translucent(const char* name, float opacity) {
  cdsm::Material material;
  material.name = name;
  material.opacity = opacity;
  return material;
}

cdsm::Scene twoSquares() {
  cdsm::Scene scene;
  scene.camera.position = {0.0f, 3.0f, 8.0f};
  scene.image.width = 48;
  scene.image.height = 32;
  scene.shadows.mapSize = 64;
  scene.materials = {translucent("half", 0.5f), translucent("quarter", 0.25f)};
  scene.meshes = {square("upper", 1.0f, 0), square("lower", 0.0f, 1)};
  cdsm::Light light;
  light.name = "lamp";
  light.position = {0.0f, 4.0f, 0.0f};
  scene.lights = {light};
  return scene;
}

}  // namespace

int main() try {
  cdsm::Engine engine;
  const cdsm::Scene scene = twoSquares();
  const cdsm::Image image = engine.render(scene);
  const auto light = engine.transmittance(scene, "lamp", {{0.1f, 2.0f, 0.1f}, {0.1f, 0.5f, 0.1f}, {0.1f, -1.0f, 0.1f}});
  std::printf("%d x %d pixels on %s; light above, between, below: %.3f %.3f %.3f\n", image.width, image.height,
              engine.device().name.c_str(), light[0].transmittance, light[1].transmittance, light[2].transmittance);
  const float wanted[] = {1.0f, 0.5f, 0.375f};
  for (int i = 0; i < 3; ++i) {
    if (!light[i].lit || std::fabs(light[i].transmittance - wanted[i]) > 0.001f) return 1;
  }
  return image.pixels.size() == 48 * 32 ? 0 : 1;
} catch (const cdsm::Error& error) {
  std::printf("error: %s\n", error.what());
  return 1;
}
