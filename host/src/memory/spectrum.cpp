// SPDX-License-Identifier: Apache-2.0
#include "memory/spectrum.hpp"

#include <cdsm/error.hpp>

namespace cdsm::memory {

namespace {

constexpr Spectrum kSpectra[] = {{"grey", "spectrum/grey.clh", 1, 1}, {"rgb", "spectrum/rgb.clh", 3, 4}};

}  // namespace

std::pair<std::string, std::string> spectrumDefine(const Spectrum& spectrum) {
  return {"CDSM_SPECTRUM", '"' + std::string(spectrum.kernelFile) + '"'};
}

const Spectrum& spectrumNamed(const std::string& name) {
  for (const Spectrum& spectrum : kSpectra)
    if (name == spectrum.name) return spectrum;
  throw Error("there is no transmittance '" + name + "'; known: grey, rgb");
}

}  // namespace cdsm::memory
