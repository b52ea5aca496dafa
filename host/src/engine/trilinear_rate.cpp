// SPDX-License-Identifier: Apache-2.0
#include "engine/trilinear_rate.hpp"

#include <algorithm>
#include <vector>

#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "device/program.hpp"

namespace cdsm::engine {

double trilinearRate(const std::string& deviceName, int runs) {
  constexpr int kRays = 512, kSteps = 256, kVolume = 256;
  using Floats = device::Buffer<float>;
  const auto device = device::Device::open(deviceName, "auto");
  std::vector<float> voxels(std::size_t(kVolume) * kVolume * kVolume);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = float(i * 2654435761u % 1024u);
  const Floats volume = Floats::fromHost(*device, voxels, "voxels");
  const Floats sums(*device, kRays * kRays, "sums");
  device::Kernel<int, int, int, Floats, Floats> sampleRays(
      *device, device->programs().get({"bench/trilinear.cl", {}, {}}), "sampleRays");
  std::vector<double> rates;
  for (int run = 0; run < runs + 1; ++run) {
    device->profiler().reset();
    device->profiler().beginGroup("sample");
    sampleRays({"sample rays", {kRays * kRays}, {64}}, kRays, kSteps, kVolume, volume, sums);
    const double milliseconds = device->profiler().groupMilliseconds("sample");
    if (run > 0) rates.push_back(double(kRays) * kRays * kSteps / milliseconds / 1000.0);
  }
  std::nth_element(rates.begin(), rates.begin() + rates.size() / 2, rates.end());
  return rates[rates.size() / 2];
}

}  // namespace cdsm::engine
