// SPDX-License-Identifier: Apache-2.0
// How the library says that something went wrong: what, where, and what would be right.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include <cdsm/export.hpp>

namespace cdsm {

/// A place in an input file. Lines and columns count from 1; 0 means "the file as a whole".
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Every failure of the library. `what()` is one line: "FILE:LINE:COLUMN: what is wrong, and what would be right".
/// The library never prints, exits or aborts; whoever calls it decides.
class CDSM_API Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message);
  Error(Location where, const std::string& message);

  const std::optional<Location>& where() const { return where_; }
  /// The message without the place.
  const std::string& message() const { return message_; }

 private:
  std::optional<Location> where_;
  std::string message_;
};

/// A failure of OpenCL or of the device: names the call, the kernel or buffer, the CL code by name and, where it is
/// about memory, the bytes asked for.
class CDSM_API DeviceError : public Error {
 public:
  using Error::Error;
};

}  // namespace cdsm
