// SPDX-License-Identifier: Apache-2.0
#include "memory/exact.hpp"

#include "device/copy.hpp"
#include "device/program.hpp"

namespace cdsm::memory {

Exact::Exact(device::Device& device, const NodeFormat& format, Mode mode)
    : TileStrategy(device, format, CDSM_EXACT_WORDS, mode),
      narrowTable_(device, device.programs().get({"memory/exact_table.cl", {}, {}}), "narrowTable") {}

void Exact::addMap(std::size_t index, shared::MapData& map, std::size_t stored, const shared::BuildCounters& counters) {
  const std::size_t tiles = tilesOf(map);
  map.wideTable = counters.maxTileNodes > 0xffffu;
  const std::size_t words = tiles * (map.wideTable ? CDSM_EXACT_WORDS : CDSM_EXACT_NARROW_WORDS);
  store_.add(index, map, stored, {stored, counters.maxNodes}, words);
  if (map.wideTable)
    device::copyElements(device_, records_, 0, words, store_.table(), map.firstTexel);
  else
    narrowTable_({"narrow the table", {tiles}, {64}}, std::uint32_t(tiles), records_, store_.table(), map.firstTexel);
}

std::uint32_t Exact::moveRecord(std::uint32_t* record, std::uint32_t first) const {
  const std::uint32_t before = record[0], room = record[CDSM_EXACT_WORDS - 1] - before;
  for (int i = 0; i < CDSM_EXACT_WORDS; ++i) record[i] += first - before;
  return room;
}

}  // namespace cdsm::memory
