// SPDX-License-Identifier: Apache-2.0
#include "bench_camera_path.hpp"

#include <glm/ext/matrix_transform.hpp>

namespace cdsm::cli {

Camera turned(const Camera& camera, float degrees) {
  const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), glm::radians(degrees), glm::normalize(camera.up));
  Camera other = camera;
  other.position = camera.target + glm::vec3(turn * glm::vec4(camera.position - camera.target, 0.0f));
  return other;
}

}  // namespace cdsm::cli
