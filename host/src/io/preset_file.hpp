// SPDX-License-Identifier: Apache-2.0
// ParaView's transfer functions: presets as JSON (.json) or XML (.xml). In: control points with midpoints, sharpness
// and a colour space. Out: the same curves as the points of a scene, linear in between.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <cdsm/scene.hpp>

namespace cdsm::io {

/// Colours become linear RGB; between two points of the file the curve is followed to 1 / 2048 of a channel. No points
/// of opacity where the file says nothing of it (an XML file whose o are all 1). `range`: what the values from the
/// first to the last colour are stretched to; nothing: values as in the file. Throws Error for anything but one preset.
TransferFunction readPreset(const std::string& path, const std::optional<std::pair<double, double>>& range);

}  // namespace cdsm::io
