// SPDX-License-Identifier: Apache-2.0
#include "memory/node_format.hpp"

#include <algorithm>

#include <cdsm/error.hpp>

namespace cdsm::memory {

namespace {

constexpr NodeFormat kFormats[] = {
    {"float32", "grey", "memory/node_float32.clh", 2, device::PixelType::Floats, false, 0.0f, 0.0f},
    {"unorm16", "grey", "memory/node_unorm16.clh", 1, device::PixelType::Words, true, 0.5f / 65535.0f, 1.0f / 16.0f},
    {"float32", "rgb", "memory/node_float32.clh", 4, device::PixelType::Floats, false, 0.0f, 0.0f},
    {"unorm16", "rgb", "memory/node_unorm16.clh", 2, device::PixelType::Words, true, 0.5f / 65535.0f, 1.0f / 16.0f},
};

}  // namespace

float NodeFormat::compressionTolerance(float tolerance) const {
  return std::max((1.0f - cellShare) * tolerance - valueError, 0.0f);
}

std::pair<std::string, std::string> nodeFormatDefine(const NodeFormat& format) {
  return {"CDSM_NODE_FORMAT", '"' + std::string(format.kernelFile) + '"'};
}

const NodeFormat& nodeFormat(const std::string& name, const std::string& spectrum) {
  std::string known;
  for (const NodeFormat& format : kFormats) {
    if (spectrumNamed(spectrum).name != std::string(format.spectrum)) continue;
    if (name == format.name) return format;
    known += (known.empty() ? "" : ", ") + std::string(format.name);
  }
  throw Error("there is no format of nodes '" + name + "'; known: " + known);
}

}  // namespace cdsm::memory
