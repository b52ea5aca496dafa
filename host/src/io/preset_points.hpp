// SPDX-License-Identifier: Apache-2.0
// The control points of a ParaView preset as they stand in its file, whatever its format.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace cdsm::io {

struct PresetPoints {
  struct Color {
    double value;
    glm::dvec3 srgb;
  };
  /// Midpoint and sharpness shape the way to the next point.
  struct Opacity {
    double value, opacity, midpoint, sharpness;
  };
  std::vector<Color> color;
  std::vector<Opacity> opacity;
  std::string space = "RGB";
};

PresetPoints readPresetJson(const std::string& path);
PresetPoints readPresetXml(const std::string& path);

}  // namespace cdsm::io
