// SPDX-License-Identifier: Apache-2.0
// The inside of an Engine, for the parts of the public interface that are functions beside it.
#pragma once

#include <cdsm/cdsm.hpp>

#include "engine/frame.hpp"

namespace cdsm {

struct Engine::Impl {
  Impl(const EngineOptions& options, std::unique_ptr<device::Device> device) : frame(options, std::move(device)) {}
  engine::FrameState frame;
};

struct EngineAccess {
  static Engine make(const EngineOptions& options, std::unique_ptr<device::Device> device) {
    return Engine(std::make_unique<Engine::Impl>(options, std::move(device)));
  }
  /// Throws Error for an engine that was moved from.
  static engine::FrameState& frame(const Engine& engine) { return engine.impl().frame; }
};

}  // namespace cdsm
