// SPDX-License-Identifier: Apache-2.0
// The only list of shadow techniques and memory strategies.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "memory/memory_strategy.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

template <class Made>
using Factory = std::function<std::unique_ptr<Made>(const ShadowSettings&, device::Device&)>;

/// The technique and the memory strategy that the settings name. Throws Error that lists the names there are.
std::unique_ptr<ShadowTechnique> makeTechnique(const ShadowSettings& settings, device::Device& device);

/// One more memory strategy, for programs that bring their own.
void addMemoryStrategy(const std::string& name, Factory<memory::MemoryStrategy> make);

}  // namespace cdsm::technique
