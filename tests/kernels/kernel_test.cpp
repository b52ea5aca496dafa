// SPDX-License-Identifier: Apache-2.0
// Devices and programs of the kernel tests.
#include "kernel_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "memory/spectrum.hpp"

namespace cdsm::kernels {
namespace {

/// Owns the devices: they must be gone before static objects die, as OpenCL implementations are unloaded then.
class DevicePool : public ::testing::Environment {
 public:
  device::Device& get(const std::string& fetch) {
    std::unique_ptr<device::Device>& device = devices_[fetch];
    if (!device) device = device::Device::open("", fetch);
    return *device;
  }
  void TearDown() override { devices_.clear(); }

 private:
  std::map<std::string, std::unique_ptr<device::Device>> devices_;
};

DevicePool* const pool = new DevicePool;  // owned by the test program below
const ::testing::Environment* const registered = ::testing::AddGlobalTestEnvironment(pool);

constexpr const char* kEntry = "test/kernel.cl";

}  // namespace

device::Device& deviceOf(const std::string& fetch) { return pool->get(fetch); }

bool canFetch(const std::string& fetch) { return fetch != "image" || deviceOf("buffer").description().images; }

const cl::Program& testProgram(device::Device& device, const std::string& text, const Defines& defines,
                               const std::map<std::string, std::string>& generated) {
  device::ProgramSource source{kEntry, defines, generated};
  source.generated[kEntry] = text;
  const auto isSpectrum = [](const auto& define) { return define.first == "CDSM_SPECTRUM"; };
  if (std::none_of(defines.begin(), defines.end(), isSpectrum))
    source.defines.push_back(memory::spectrumDefine(memory::spectrumNamed("grey")));
  return device.programs().get(source);
}

const cl::Program& sceneTestProgram(device::Device& device, const build::DeviceScene& scene, const std::string& text) {
  Defines defines{{"CDSM_BATCH", device.isCpu() ? "8" : "4"}, {"CDSM_SPHERES", "0"}};
  if (device.fetchImages()) defines.emplace_back("CDSM_FETCH_IMAGE", "1");
  return testProgram(device, text, defines, {{"generated/volume_slots.clh", scene.slots().kernelFile()}});
}

}  // namespace cdsm::kernels
