// SPDX-License-Identifier: Apache-2.0
#include "technique/registry.hpp"

#include "memory/atlas.hpp"
#include "memory/chunked.hpp"
#include "memory/exact.hpp"
#include "memory/fixed.hpp"
#include "memory/tiled.hpp"
#include "technique/deep_shadow_map.hpp"
#include "technique/implicit_sphere.hpp"
#include "technique/none.hpp"
#include "technique/shadow_map.hpp"
#include "technique/shadow_rays.hpp"
#include "technique/stochastic.hpp"

namespace cdsm::technique {

namespace {

template <class Made>
struct Entry {
  std::string name;
  Factory<Made> make;
};

const memory::NodeFormat& formatOf(const ShadowSettings& settings) {
  return memory::nodeFormat(settings.nodeFormat, settings.transmittance);
}

/// A strategy that needs nothing but the device and a format of nodes.
template <class Made>
Factory<memory::MemoryStrategy> plain() {
  return [](const ShadowSettings& settings, device::Device& device) {
    return std::make_unique<Made>(device, formatOf(settings));
  };
}

std::vector<Entry<memory::MemoryStrategy>>& memories() {
  static std::vector<Entry<memory::MemoryStrategy>> list{
      {"chunked", plain<memory::Chunked>()},
      {"atlas", plain<memory::Atlas>()},
      {"exact", plain<memory::Exact>()},
      {"tiled", plain<memory::Tiled>()},
      {"fixed",
       [](auto& settings, auto& device) {
         return std::make_unique<memory::Fixed>(device, formatOf(settings), settings.maxNodes);
       }},
  };
  return list;
}

template <class Made>
const Entry<Made>& find(const std::vector<Entry<Made>>& entries, const std::string& name, const char* what) {
  std::string known;
  for (const Entry<Made>& entry : entries) {
    if (name == entry.name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw Error("there is no " + std::string(what) + " '" + name + "'; known: " + known);
}

const std::vector<Entry<ShadowTechnique>>& techniques() {
  static const std::vector<Entry<ShadowTechnique>> list{
      {"none", [](auto&, auto&) { return std::make_unique<None>(); }},
      {"shadow-rays", [](auto&, auto& device) { return std::make_unique<ShadowRays>(device); }},
      {"shadow-map", [](auto&, auto& device) { return std::make_unique<ShadowMap>(device); }},
      {"deep-shadow-map",
       [](auto& settings, auto& device) {
         const auto make = find(memories(), settings.memory, "memory strategy").make;
         return std::make_unique<DeepShadowMap>(device, [make, settings, &device] { return make(settings, device); });
       }},
      {"stochastic", [](auto&, auto& device) { return std::make_unique<Stochastic>(device); }},
      {"implicit-sphere", [](auto&, auto& device) { return std::make_unique<ImplicitSphere>(device); }},
  };
  return list;
}

}  // namespace

std::unique_ptr<ShadowTechnique> makeTechnique(const ShadowSettings& settings, device::Device& device) {
  return find(techniques(), settings.technique, "shadow technique").make(settings, device);
}

void addMemoryStrategy(const std::string& name, Factory<memory::MemoryStrategy> make) {
  memories().push_back({name, std::move(make)});
}

}  // namespace cdsm::technique
