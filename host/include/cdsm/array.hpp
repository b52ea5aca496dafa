// SPDX-License-Identifier: Apache-2.0
// The arrays that meshes and spheres are made of: of their own or views of somebody else's memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace cdsm {

/// Values that cannot be changed through it, in memory of its own or where somebody else has them. Copies share the
/// memory.
///
/// Memory that an array only shows is read during an engine's calls, those without a scene included. An engine keeps
/// the array, and with it the owner, from the first call with a scene that has it until a call with one that does not
/// has succeeded, Engine::drop() or its own end. Without an owner the memory must stay where it is for as long. Nobody
/// may write to it during a call; after writing to it the next call must give a scene in which all Mesh or Spheres that
/// have it have another `revision` than before.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>, "values are read from bytes");

 public:
  using value_type = T;

  Array() = default;
  Array(std::vector<T> values) {
    const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
    *this = view(owner->data(), owner->size(), sizeof(T), owner);
    isView_ = false;
  }
  Array(std::initializer_list<T> values) : Array(std::vector<T>(values)) {}

  /// `count` values in host memory, the first at `first`, which needs no alignment. `stride`: bytes from a value to the
  /// next, at least sizeof(T) or as much backwards, or 0: one value for all. `owner` of the memory may be empty.
  static Array view(const void* first, std::size_t count, std::ptrdiff_t stride = sizeof(T),
                    std::shared_ptr<const void> owner = {}) {
    Array array;
    array.first_ = static_cast<const std::byte*>(first);
    array.count_ = count;
    array.stride_ = stride;
    array.owner_ = std::move(owner);
    array.isView_ = true;
    return array;
  }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  T operator[](std::size_t index) const {
    T value;
    std::memcpy(&value, first_ + std::ptrdiff_t(index) * stride_, sizeof(T));
    return value;
  }

  /// Whether the memory is somebody else's.
  bool isView() const { return isView_; }
  /// False for a view of memory that is not there.
  bool isSomewhere() const { return first_ || empty(); }
  /// Bytes from a value to the next.
  std::ptrdiff_t stride() const { return stride_; }
  /// The values, if they lie side by side and are aligned; else null.
  const T* sideBySide() const {
    const bool aligned = reinterpret_cast<std::uintptr_t>(first_) % alignof(T) == 0;
    return stride_ == std::ptrdiff_t(sizeof(T)) && aligned ? reinterpret_cast<const T*>(first_) : nullptr;
  }

  /// Reads one value after the other.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = T;

    Iterator() = default;
    Iterator(const Array& array, std::size_t index) : array_(&array), index_(index) {}
    T operator*() const { return (*array_)[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++index_;
      return before;
    }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const Array* array_ = nullptr;
    std::size_t index_ = 0;
  };

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, count_}; }

 private:
  const std::byte* first_ = nullptr;
  std::size_t count_ = 0;
  std::ptrdiff_t stride_ = sizeof(T);
  std::shared_ptr<const void> owner_;
  bool isView_ = false;
};

}  // namespace cdsm
