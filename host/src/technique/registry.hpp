// SPDX-License-Identifier: Apache-2.0
// The only list of shadow techniques and memory strategies.
#pragma once

#include <memory>

#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

/// The technique and the memory strategy that the settings name. Throws Error that lists the names there are.
std::unique_ptr<ShadowTechnique> makeTechnique(const ShadowSettings& settings, device::Device& device);

}  // namespace cdsm::technique
