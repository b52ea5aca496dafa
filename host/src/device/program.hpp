// SPDX-License-Identifier: Apache-2.0
// Programs, compiled once. In: a ProgramSource; out: a built cl::Program from memory, from the binary cache on disk
// ($CDSM_CACHE_DIR, else $XDG_CACHE_HOME/cdsm, else ~/.cache/cdsm) or from source, in this order.
#pragma once

#include <map>
#include <string>

#include <CL/opencl.hpp>

#include "device/kernel_source.hpp"

namespace cdsm::device {

class Device;

/// The options every program is built with. No -cl-fast-relaxed-math: it drops NaN and infinity checks.
constexpr const char* kBuildOptions = "-cl-std=CL1.2 -cl-mad-enable -cl-no-signed-zeros";

/// All programs of one device; see Device::programs(). Used by one thread at a time; several processes may share the
/// folder on disk.
class ProgramCache {
 public:
  explicit ProgramCache(Device& device) : device_(device) {}

  /// Stays valid as long as the cache. Throws Error for a missing file, DeviceError with the first errors of the
  /// compiler for a source that does not build. Troubles with the disk cache are never errors.
  const cl::Program& get(const ProgramSource& source);

  struct Counts {
    int memoryHits = 0;
    int diskHits = 0;
    int builds = 0;  ///< from source
  };
  const Counts& counts() const { return counts_; }

 private:
  cl::Program make(const std::string& entry, const std::string& text, const std::string& key);
  cl::Program buildFromSource(const std::string& entry, const std::string& text);
  bool buildFromBinary(const std::string& binary, cl::Program& program);

  Device& device_;
  std::map<std::string, cl::Program> programs_;  ///< by key, see programKey() in program.cpp
  Counts counts_;
};

}  // namespace cdsm::device
