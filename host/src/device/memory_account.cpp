// SPDX-License-Identifier: Apache-2.0
// Checks each allocation against the device's limits. In: bytes and a name; out: a claim, or DeviceError.
#include "device/memory_account.hpp"

#include <utility>

#include <cdsm/error.hpp>

namespace cdsm::device {

MemoryClaim::MemoryClaim(std::shared_ptr<MemoryAccount> account, std::uint64_t bytes, const std::string& name) {
  if (bytes > account->maxAllocationBytes) {
    throw DeviceError(name + ": " + std::to_string(bytes) + " bytes asked for, but device '" + account->device +
                      "' allocates at most " + std::to_string(account->maxAllocationBytes) + " bytes at once");
  }
  const std::uint64_t before = account->usedBytes.fetch_add(bytes);
  if (before + bytes > account->totalBytes) {
    account->usedBytes -= bytes;
    throw DeviceError(name + ": " + std::to_string(bytes) + " bytes asked for, but of the " +
                      std::to_string(account->totalBytes) + " bytes of device '" + account->device + "' " +
                      std::to_string(before) + " are in use");
  }
  account_ = std::move(account);
  bytes_ = bytes;
}

MemoryClaim::~MemoryClaim() {
  if (account_) account_->usedBytes -= bytes_;
}

MemoryClaim::MemoryClaim(MemoryClaim&& other) noexcept
    : account_(std::move(other.account_)), bytes_(std::exchange(other.bytes_, 0)) {}

MemoryClaim& MemoryClaim::operator=(MemoryClaim&& other) noexcept {
  MemoryClaim old(std::move(*this));  // given back here, not when `other` goes
  account_ = std::move(other.account_);
  bytes_ = std::exchange(other.bytes_, 0);
  return *this;
}

}  // namespace cdsm::device
