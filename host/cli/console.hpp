// SPDX-License-Identifier: Apache-2.0
// What the tool tells people on stderr while it works: progress, where somebody is watching.
#pragma once

#include <chrono>
#include <string>

namespace cdsm::cli {

/// Progress is one line that is written over, and gone when the object is; it appears only on a terminal, when not
/// quiet, and after a second of work. For one thread.
class Console {
 public:
  explicit Console(bool quiet);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// What progress is about, before the step.
  void setLabel(const std::string& label) { label_ = label; }

  /// A line "warning: ..." on any stderr, unless quiet.
  void warn(const std::string& message);

  /// `done` of this step in [0, 1].
  void progress(const std::string& step, float done);

 private:
  using Clock = std::chrono::steady_clock;

  void clearLine();

  bool quiet_;
  bool terminal_;
  bool lineShown_ = false;
  std::string label_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point lastShown_{};
};

}  // namespace cdsm::cli
