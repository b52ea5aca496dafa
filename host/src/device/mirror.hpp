// SPDX-License-Identifier: Apache-2.0
// A buffer that follows a list on the host. In: the list as it is now; out: a buffer with it, for the upload of what
// has changed.
#pragma once

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "device/buffer.hpp"

namespace cdsm::device {

/// Move-only. Elements are compared by their bytes, so padding must be named.
template <class T>
class Mirror {
 public:
  /// Uploads the elements that differ from those before, or all of them if there are more or fewer now.
  void follow(Device& device, const std::vector<T>& values, const char* name) {
    const std::vector<T> before = std::exchange(known_, {});
    if (before.size() != values.size() || !buffer_.allocated()) {
      buffer_ = {};
      buffer_ = Buffer<T>::fromHost(device, values, name);
    } else {
      for (std::size_t i = 0; i < values.size();) i = uploadRun(before, values, i);
    }
    known_ = values;
  }

  const Buffer<T>& buffer() const { return buffer_; }
  operator const Buffer<T>&() const { return buffer_; }
  const cl::Buffer& cl() const { return buffer_.cl(); }

 private:
  /// The run of elements from `first` on that differ, if it does. Returns where to go on.
  std::size_t uploadRun(const std::vector<T>& before, const std::vector<T>& values, std::size_t first) {
    std::size_t end = first;
    while (end < values.size() && std::memcmp(&before[end], &values[end], sizeof(T)) != 0) ++end;
    if (end > first) buffer_.upload(&values[first], end - first, first);
    return end + 1;
  }

  std::vector<T> known_;  ///< what is in the buffer; empty after an upload that failed
  Buffer<T> buffer_;
};

}  // namespace cdsm::device
