// SPDX-License-Identifier: Apache-2.0
// Frames of an animation on the command line: which ones, and how their files are called.
#pragma once

#include <string>

namespace cdsm::io {

/// Frames count from 0.
inline constexpr int kLastFrame = 999999;

struct FrameRange {
  int first = 0;
  int last = 0;  ///< rendered, too

  int count() const { return last - first + 1; }
};

/// FIRST:LAST or one number. Throws Error.
FrameRange parseFrames(const std::string& text);

/// A file name with a place for the frame's number.
class FramePattern {
 public:
  /// A text with at most one %d or %0Nd (N digits at least, 1 to 9, filled up with zeros); %% is a percent sign.
  /// Throws Error for any other % in it.
  explicit FramePattern(const std::string& text);
  /// NAME_0000ENDING.
  FramePattern(const std::string& name, const std::string& ending);

  bool isNumbered() const { return digits_ > 0; }
  std::string path(int frame) const;

 private:
  std::string before_, after_;
  int digits_ = 0;  ///< the least; 0: no number
};

}  // namespace cdsm::io
