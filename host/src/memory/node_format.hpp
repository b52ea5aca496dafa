// SPDX-License-Identifier: Apache-2.0
// How a node of a visibility function lies in memory, shadows.node_format: the host's side of
// kernels/memory/node_*.clh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "device/texture.hpp"
#include "memory/spectrum.hpp"

namespace cdsm::memory {

struct NodeFormat {
  const char* name;
  const char* spectrum;  ///< of its transmittances
  const char* kernelFile;
  std::size_t words;            ///< of 32 bits, per node
  device::PixelType pixelType;  ///< of a texture of nodes, pixels of 16 bytes
  bool tileDepths;              ///< depths count steps of a tile, of which the scale is kept
  float valueError;             ///< of a stored transmittance, at most
  float cellShare;              ///< of the tolerance, left for what V does between two depths that nodes can have

  std::size_t bytes() const { return words * sizeof(std::uint32_t); }
  std::size_t pixelNodes() const { return 4 / words; }
  /// What is left of a tolerance for the compression: what is stored is within all of it.
  float compressionTolerance(float tolerance) const;
};

/// Which kernel file it is: NAME and value of a define.
std::pair<std::string, std::string> nodeFormatDefine(const NodeFormat& format);

/// `spectrum`: name of that of the transmittances. Throws Error that lists the formats there are.
const NodeFormat& nodeFormat(const std::string& name, const std::string& spectrum);

}  // namespace cdsm::memory
