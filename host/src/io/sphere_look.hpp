// SPDX-License-Identifier: Apache-2.0
// In: atoms of a file, and what the scene says of their looks. Out: spheres.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <glm/glm.hpp>

#include <cdsm/scene.hpp>

#include "io/molecule_file.hpp"

namespace cdsm::io {

struct SphereLook {
  float radius = 0.0f;             ///< of all, in the file's unit; 0: van der Waals, of the element
  std::optional<glm::vec3> color;  ///< of all; none: of the element
  bool waters = true;              ///< false: atoms of water are left out

  /// Tells looks apart.
  std::array<float, 6> key() const;
};

/// One sphere for each atom, without colours where no element of the file is known. Throws Error where an element's
/// radius is asked for and it is not known, and if no atom is left.
std::shared_ptr<const SphereData> makeSpheres(const Molecule& molecule, const SphereLook& look);

}  // namespace cdsm::io
