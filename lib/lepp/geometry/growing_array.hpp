#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace lepp {

namespace pages {
/// Memory for `bytes` bytes that begins with what was in `old`, which is given back; nothing for 0.
/// Where the system can, the pages of large blocks move, not their bytes.
/// \param old  nothing, or what this function returned for `old_bytes`
/// \throw std::bad_alloc; `old` stays as it was
/// Cost  O(bytes) below a megabyte, and where pages cannot be moved; else one call of the system
void* resize(void* old, std::size_t old_bytes, std::size_t bytes);
void release(void* block, std::size_t bytes) noexcept;
}  // namespace pages

/// Contiguous items, as in a vector, for arrays as large as a mesh. It differs in two things: items
/// that resize() adds are not set, so that large arrays that are filled by two threads, or not in
/// order, need not be swept through twice; and growing does not copy what is there already.
/// \pre  items are trivially copyable; those that resize() adds are assigned before they are read
template <class T>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  using value_type = T;

  GrowingArray() = default;
  explicit GrowingArray(std::size_t size) { resize(size); }
  GrowingArray(const GrowingArray& other) : GrowingArray(other.size_) {
    if (size_ != 0) std::memcpy(static_cast<void*>(items_), other.items_, size_ * sizeof(T));
  }
  GrowingArray(GrowingArray&& other) noexcept { swap(other); }
  GrowingArray& operator=(GrowingArray other) noexcept {
    swap(other);
    return *this;
  }
  ~GrowingArray() { pages::release(items_, room_ * sizeof(T)); }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return room_; }
  bool empty() const { return size_ == 0; }
  T* data() { return items_; }
  const T* data() const { return items_; }
  T* begin() { return items_; }
  T* end() { return items_ + size_; }
  const T* begin() const { return items_; }
  const T* end() const { return items_ + size_; }
  T& operator[](std::size_t i) {
    assert(i < size_);
    return items_[i];
  }
  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return items_[i];
  }
  T& back() { return (*this)[size_ - 1]; }
  const T& back() const { return (*this)[size_ - 1]; }

  void push_back(T item) {
    resize(size_ + 1);
    back() = item;
  }
  void pop_back() {
    assert(size_ > 0);
    --size_;
  }
  void clear() { size_ = 0; }
  /// Items that are new are not set. Room at least doubles where there is not enough.
  void resize(std::size_t size) {
    if (size > room_) make_room(std::max(size, 2 * room_));
    size_ = size;
  }
  /// The next so many items then need no more room, and cannot fail. Doubles, as resize() does.
  void make_room_for(std::size_t more) {
    if (more > room_ - size_) make_room(std::max(size_ + more, 2 * room_));
  }
  void reserve(std::size_t room) {
    if (room > room_) make_room(room);
  }
  void shrink_to_fit() { make_room(size_); }
  void swap(GrowingArray& other) noexcept {
    std::swap(items_, other.items_);
    std::swap(size_, other.size_);
    std::swap(room_, other.room_);
  }

 private:
  void make_room(std::size_t room) {
    if (room > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_alloc();
    items_ = static_cast<T*>(pages::resize(items_, room_ * sizeof(T), room * sizeof(T)));
    room_ = room;
  }

  T* items_ = nullptr;
  std::size_t size_ = 0, room_ = 0;
};

}  // namespace lepp
