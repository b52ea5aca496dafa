// SPDX-License-Identifier: Apache-2.0
// What is followed of light on its way, shadows.transmittance: the host's side of kernels/spectrum/*.clh.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace cdsm::memory {

struct Spectrum {
  const char* name;
  const char* kernelFile;
  std::size_t channels;  ///< CDSM_CHANNELS: numbers of a result
  std::size_t stride;    ///< CDSM_SPECTRUM_STRIDE: floats of a Spectrum in memory
};

/// Which kernel file it is: NAME and value of a define.
std::pair<std::string, std::string> spectrumDefine(const Spectrum& spectrum);

/// Throws Error that lists what there is.
const Spectrum& spectrumNamed(const std::string& name);

}  // namespace cdsm::memory
