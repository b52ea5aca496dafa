// SPDX-License-Identifier: Apache-2.0
// Elements by gemmi, colours by Jmol; see elements.hpp.
#include "io/elements.hpp"

#include <cstddef>
#include <iterator>
#include <string>

#include <gemmi/elem.hpp>

#include "io/srgb.hpp"

namespace cdsm::io {
namespace {

/// sRGB as a display shows it, by atomic number.
constexpr std::uint32_t kJmolColors[] = {
    0xFF1493,                                                                                  // unknown
    0xFFFFFF, 0xD9FFFF,                                                                        // H to He
    0xCC80FF, 0xC2FF00, 0xFFB5B5, 0x909090, 0x3050F8, 0xFF0D0D, 0x90E050, 0xB3E3F5,            // Li to Ne
    0xAB5CF2, 0x8AFF00, 0xBFA6A6, 0xF0C8A0, 0xFF8000, 0xFFFF30, 0x1FF01F, 0x80D1E3,            // Na to Ar
    0x8F40D4, 0x3DFF00, 0xE6E6E6, 0xBFC2C7, 0xA6A6AB, 0x8A99C7, 0x9C7AC7, 0xE06633, 0xF090A0,  // K to Co
    0x50D050, 0xC88033, 0x7D80B0, 0xC28F8F, 0x668F8F, 0xBD80E3, 0xFFA100, 0xA62929, 0x5CB8D1,  // Ni to Kr
    0x702EB0, 0x00FF00, 0x94FFFF, 0x94E0E0, 0x73C2C9, 0x54B5B5, 0x3B9E9E, 0x248F8F, 0x0A7D8C,  // Rb to Rh
    0x006985, 0xC0C0C0, 0xFFD98F, 0xA67573, 0x668080, 0x9E63B5, 0xD47A00, 0x940094, 0x429EB0,  // Pd to Xe
    0x57178F, 0x00C900, 0x70D4FF, 0xFFFFC7, 0xD9FFC7, 0xC7FFC7, 0xA3FFC7, 0x8FFFC7, 0x61FFC7,  // Cs to Eu
    0x45FFC7, 0x30FFC7, 0x1FFFC7, 0x00FF9C, 0x00E675, 0x00D452, 0x00BF38, 0x00AB24, 0x4DC2FF,  // Gd to Hf
    0x4DA6FF, 0x2194D6, 0x267DAB, 0x266696, 0x175487, 0xD0D0E0, 0xFFD123, 0xB8B8D0, 0xA6544D,  // Ta to Tl
    0x575961, 0x9E4FB5, 0xAB5C00, 0x754F45, 0x428296,                                          // Pb to Rn
    0x420066, 0x007D00, 0x70ABFA, 0x00BAFF, 0x00A1FF, 0x008FFF, 0x0080FF, 0x006BFF, 0x545CF2,  // Fr to Am
    0x785CE3, 0x8A4FE3, 0xA136D4, 0xB31FD4, 0xB31FBA, 0xB30DA6, 0xBD0D87, 0xC70066, 0xCC0059,  // Cm to Rf
    0xD1004F, 0xD90045, 0xE00038, 0xE6002E, 0xEB0026,                                          // Db to Mt
};
constexpr std::uint32_t kDeuterium = 0xFFFFC0;

std::uint32_t jmolColor(ElementId element) {
  if (element == static_cast<ElementId>(gemmi::El::D)) return kDeuterium;
  return kJmolColors[element < std::size(kJmolColors) ? element : kUnknownElement];
}

}  // namespace

ElementId elementOf(std::string_view symbol) {
  constexpr std::size_t kLongest = 2;
  if (symbol.size() > kLongest) return kUnknownElement;
  return static_cast<ElementId>(gemmi::find_element(std::string(symbol).c_str()));
}

float vanDerWaalsRadius(ElementId element) { return gemmi::vdw_radius(static_cast<gemmi::El>(element)); }

glm::vec3 elementColor(ElementId element) {
  const std::uint32_t encoded = jmolColor(element);
  const auto linear = [encoded](int shift) {
    return static_cast<float>(linearOfSrgb(static_cast<double>(encoded >> shift & 0xFFu) / 255.0));
  };
  return {linear(16), linear(8), linear(0)};
}

}  // namespace cdsm::io
