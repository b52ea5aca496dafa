// SPDX-License-Identifier: Apache-2.0
#include "build/unit_cube.hpp"

#include <utility>
#include <vector>

#include "scene/view.hpp"

namespace cdsm::build {

std::shared_ptr<const MeshData> unitCube() {
  static const std::shared_ptr<const MeshData> cube = [] {
    auto data = std::make_shared<MeshData>();
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    data->positions = std::move(corners);
    data->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return data;
  }();
  return cube;
}

glm::mat4 worldFromUnitCube(const Volume& volume) {
  glm::mat4 indexFromUnit(1.0f);
  for (int i = 0; i < 3; ++i) indexFromUnit[i][i] = float(volume.data->size[i]);
  indexFromUnit[3] = glm::vec4(-0.5f, -0.5f, -0.5f, 1.0f);
  return scene::worldFromIndex(volume) * indexFromUnit;
}

}  // namespace cdsm::build
