// SPDX-License-Identifier: Apache-2.0
#include "device/scan.hpp"

#include "device/program.hpp"

namespace cdsm::device {

namespace {

constexpr std::size_t kBlock = 1024;  // CDSM_SCAN_BLOCK
constexpr std::size_t kGroup = 64;

const cl::Program& scanProgram(Device& device) { return device.programs().get({"build/scan.cl", {}, {}}); }

}  // namespace

Scan::Scan(Device& device)
    : device_(device),
      blockSums_(device, 1024, "block sums of a scan"),
      scanBlockSums_(device, scanProgram(device), "scanBlockSums"),
      scanBlocks_(device, scanProgram(device), "scanBlocks"),
      scanValues_(device, scanProgram(device), "scanValues") {}

std::uint32_t Scan::operator()(std::size_t count, const Uints& values, Uints& sums) {
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  blockSums_.reserve(blocks + 1);
  scanBlockSums_({"scan block sums", {blocks}, {kGroup}}, std::uint32_t(count), values, blockSums_);
  scanBlocks_({"scan blocks", {1}, {1}}, std::uint32_t(blocks), blockSums_);
  const std::uint64_t total = blockSums_.read(blocks);
  if (total > 0xffffffffu)
    throw DeviceError("'" + values.name() + "' add up to " + std::to_string(total) +
                      ", which must be below 2^32; take smaller images or maps, or fewer triangles");
  if (count == 0) sums.upload({0});
  scanValues_({"scan values", {blocks}, {kGroup}}, std::uint32_t(count), values, blockSums_, sums);
  return std::uint32_t(total);
}

}  // namespace cdsm::device
