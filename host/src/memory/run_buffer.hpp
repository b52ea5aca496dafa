// SPDX-License-Identifier: Apache-2.0
// A buffer of runs of elements side by side, one of each map: it grows at its end and is cut to size when all are
// there.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "device/buffer.hpp"
#include "device/copy.hpp"

namespace cdsm::memory {

/// Where the elements of a map are.
struct Run {
  std::size_t first = 0, count = 0;
};

/// An element is `values` values of type T.
template <class T>
class RunBuffer {
 public:
  /// Elements that must be allocated so that so many can be used.
  using SizeOf = std::function<std::size_t(std::size_t used)>;

  RunBuffer(
      device::Device& device, std::string name, std::size_t values = 1,
      SizeOf sizeOf = [](std::size_t used) { return used; })
      : device_(device), name_(std::move(name)), values_(values), sizeOf_(std::move(sizeOf)) {}

  /// Keeps these runs alone, side by side; says in each where it is now. Makes room for `more` elements behind them.
  void keep(const std::vector<Run*>& runs, std::size_t more = 0) {
    std::size_t kept = 0;
    for (const Run* run : runs) kept += run->count;
    device::Buffer<T> before = std::move(buffer_);
    if (kept == 0) before = {};
    used_ = 0;
    buffer_ = allocate(kept + more);
    for (Run* run : runs) {
      copy(before, run->first, run->count, buffer_, used_);
      run->first = used_;
      used_ += run->count;
    }
  }

  /// Room for a run of `count` elements, of which the first `written` are there already. Behind other runs there will
  /// be more of them: then it grows by half at least, so that not every run moves all others.
  void makeRoom(std::size_t count, std::size_t written = 0) {
    if (room() >= count && sizeOf_(used_ + count) <= size()) return;
    device::Buffer<T> larger = allocate(used_ + std::max(count, used_ / 2));
    copy(buffer_, 0, used_ + std::min(written, count), larger, 0);
    buffer_ = std::move(larger);
  }

  /// The next `count` elements are a run.
  Run append(std::size_t count) {
    const Run run{used_, count};
    used_ += count;
    return run;
  }

  /// Gives back what is behind the last run.
  void trim() {
    if (sizeOf_(used_) == size()) return;
    device::Buffer<T> exact = allocate(used_);
    copy(buffer_, 0, used_, exact, 0);
    buffer_ = std::move(exact);
  }

  std::size_t used() const { return used_; }
  /// Elements behind the last run.
  std::size_t room() const { return size() > used_ ? size() - used_ : 0; }
  std::size_t bytes() const { return buffer_.bytes(); }
  std::size_t bytesUsed() const { return used_ * values_ * sizeof(T); }
  device::Buffer<T>& buffer() { return buffer_; }
  const device::Buffer<T>& buffer() const { return buffer_; }

 private:
  std::size_t size() const { return buffer_.size() / values_; }

  void copy(const device::Buffer<T>& from, std::size_t first, std::size_t count, device::Buffer<T>& to,
            std::size_t offset) {
    device::copyElements(device_, from, first * values_, count * values_, to, offset * values_);
  }

  device::Buffer<T> allocate(std::size_t used) const {
    const std::size_t size = sizeOf_(used);
    if (size > 0xffffffffu)
      throw DeviceError("'" + name_ + "' needs " + std::to_string(size) +
                        " elements, more than 2^32; take smaller maps, fewer lights or a larger tolerance");
    return device::Buffer<T>(device_, size * values_, name_);
  }

  device::Device& device_;
  std::string name_;
  std::size_t values_;
  SizeOf sizeOf_;
  std::size_t used_ = 0;
  device::Buffer<T> buffer_;
};

}  // namespace cdsm::memory
