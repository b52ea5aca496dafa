// SPDX-License-Identifier: Apache-2.0
// Warnings and progress on stderr.
#include "console.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace cdsm::cli {
namespace {

constexpr std::chrono::seconds kPatience{1};         // shorter work shows nothing
constexpr std::chrono::milliseconds kInterval{100};  // between two states of the line
constexpr const char* kEraseLine = "\r\033[K";

}  // namespace

Console::Console(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

Console::~Console() { clearLine(); }

void Console::clearLine() {
  if (lineShown_) std::cerr << kEraseLine << std::flush;
  lineShown_ = false;
}

void Console::warn(const std::string& message) {
  if (quiet_) return;
  clearLine();
  std::cerr << "warning: " << label_ << message << std::endl;
}

void Console::progress(const std::string& step, float done) {
  if (quiet_ || !terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now - started_ < kPatience || now - lastShown_ < kInterval) return;
  const int percent = static_cast<int>(100.0f * std::clamp(done, 0.0f, 1.0f));
  std::cerr << kEraseLine << label_ << step << ' ' << percent << " %" << std::flush;
  lineShown_ = true;
  lastShown_ = now;
}

}  // namespace cdsm::cli
