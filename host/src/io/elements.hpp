// SPDX-License-Identifier: Apache-2.0
// Chemical elements as molecule files name them, with what space-filling models need of each.
#pragma once

#include <cstdint>
#include <string_view>

#include <glm/glm.hpp>

namespace cdsm::io {

/// Atomic number, or that of deuterium in gemmi's table.
using ElementId = std::uint8_t;
inline constexpr ElementId kUnknownElement = 0;

/// Of one or two letters of either case; kUnknownElement for all else.
ElementId elementOf(std::string_view symbol);

/// In ångström, by gemmi's table. The element is known.
float vanDerWaalsRadius(ElementId element);

/// Linear RGB of Jmol's colours (https://jmol.sourceforge.net/jscolors), the common scheme after Corey, Pauling and
/// Koltun; what it leaves out, and kUnknownElement, has its deep pink.
glm::vec3 elementColor(ElementId element);

}  // namespace cdsm::io
