// SPDX-License-Identifier: Apache-2.0
#include "technique/registry.hpp"

#include <functional>

#include "memory/atlas.hpp"
#include "memory/chunked.hpp"
#include "technique/deep_shadow_map.hpp"
#include "technique/none.hpp"
#include "technique/shadow_map.hpp"
#include "technique/shadow_rays.hpp"

namespace cdsm::technique {

namespace {

template <class Made, class... Args>
struct Entry {
  const char* name;
  std::function<std::unique_ptr<Made>(Args...)> make;
};

using MemoryEntry = Entry<memory::MemoryStrategy, device::Device&>;
using TechniqueEntry = Entry<ShadowTechnique, const ShadowSettings&, device::Device&>;

const MemoryEntry kMemories[] = {
    {"chunked", [](device::Device& device) { return std::make_unique<memory::Chunked>(device); }},
    {"atlas", [](device::Device& device) { return std::make_unique<memory::Atlas>(device); }},
};

template <std::size_t Count, class E>
const E& find(const E (&entries)[Count], const std::string& name, const char* what) {
  std::string known;
  for (const E& entry : entries) {
    if (name == entry.name) return entry;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw Error("there is no " + std::string(what) + " '" + name + "'; known: " + known);
}

const TechniqueEntry kTechniques[] = {
    {"none", [](const ShadowSettings&, device::Device&) { return std::make_unique<None>(); }},
    {"shadow-rays", [](const ShadowSettings&, device::Device& device) { return std::make_unique<ShadowRays>(device); }},
    {"shadow-map", [](const ShadowSettings&, device::Device& device) { return std::make_unique<ShadowMap>(device); }},
    {"deep-shadow-map",
     [](const ShadowSettings& settings, device::Device& device) {
       return std::make_unique<DeepShadowMap>(device, find(kMemories, settings.memory, "memory strategy").make(device));
     }},
};

}  // namespace

std::unique_ptr<ShadowTechnique> makeTechnique(const ShadowSettings& settings, device::Device& device) {
  return find(kTechniques, settings.technique, "shadow technique").make(settings, device);
}

}  // namespace cdsm::technique
