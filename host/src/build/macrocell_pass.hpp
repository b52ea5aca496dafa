// SPDX-License-Identifier: Apache-2.0
// Which macrocells of the volumes are empty under their transfer functions, and how far around them it is empty too.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "build/extinction_curve.hpp"
#include "build/volume_slots.hpp"
#include "shared/scene_data.h"

namespace cdsm::build {

class MacrocellPass {
 public:
  explicit MacrocellPass(device::Device& device) : device_(device) {}

  /// Classifies the cells of all volumes among the media, unless values and extinctions are as before. `extinctions`:
  /// the tables of all volumes; `curves`: of each medium.
  void run(const VolumeSlots& slots, const std::vector<shared::MediumData>& media,
           const std::vector<float>& extinctions, const std::vector<ExtinctionCurve>& curves);

  /// Of all volumes, see MediumData::cells. 0: extinction somewhere in the cell, else empty.
  const device::Buffer<std::uint8_t>& cells() const { return cells_; }

 private:
  /// What cells were classified from: data, tables and curves of extinctions, where each volume's table is.
  struct Classified {
    std::vector<std::shared_ptr<const VolumeData>> data;
    std::vector<std::uint64_t> revisions;
    std::vector<float> extinctions, tables;

    bool operator==(const Classified& other) const {
      return data == other.data && revisions == other.revisions && extinctions == other.extinctions &&
             tables == other.tables;
    }
  };

  void classify(const VolumeSlots& slots, const shared::MediumData& medium, const std::vector<float>& extinctions,
                const ExtinctionCurve& curve);

  device::Device& device_;
  std::optional<Classified> classified_;
  device::Buffer<std::uint8_t> cells_, cellsBefore_;
};

}  // namespace cdsm::build
