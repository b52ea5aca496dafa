// SPDX-License-Identifier: Apache-2.0
// How a colour map runs from one colour to the next. Colours are sRGB as a display shows them, 0 .. 1.
#pragma once

#include <optional>
#include <string_view>

#include <glm/glm.hpp>

namespace cdsm::io {

/// The colour at 0 .. 1 of the way between two.
using ColorBlend = glm::dvec3 (*)(const glm::dvec3& from, const glm::dvec3& to, double part);

/// By ParaView's names: RGB, HSV, Wrapped (HSV the short way round), Lab or CIELAB, Diverging, Step. Nothing for
/// others.
std::optional<ColorBlend> colorBlendOf(std::string_view space);

}  // namespace cdsm::io
