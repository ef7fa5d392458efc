#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace lepp {

// What helper programs send over a pipe. RecordWriter and RecordReader walk the same lists of
// fields, fields(archive, structure) for each structure, so that both ends agree. The pipe joins
// two programs of one machine: numbers travel in its own byte order.

template <class T>
concept RecordNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// T or const T: one fields() serves both directions.
template <class T, class U>
concept Is = std::is_same_v<std::remove_const_t<T>, U>;

class RecordWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void put_bytes(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  template <RecordNumber T>
  void put(const T& value) {
    put_bytes(&value, sizeof value);
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    put_bytes(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& items) {
    put(std::uint64_t{items.size()});
    for (const T& item : items) put(item);
  }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& items) {
    for (const T& item : items) put(item);
  }
  template <class T>
  void put(const std::optional<T>& item) {
    put(item.has_value());
    if (item) put(*item);
  }
  template <class T>
  void put(const T& structure) {
    fields(*this, structure);
  }

  std::vector<std::byte> bytes_;
};

class RecordReader {
 public:
  explicit RecordReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }
  bool complete() const { return !failed_ && bytes_.empty(); }
  /// For fields() that see a contradiction.
  void fail() { failed_ = true; }

 private:
  void take_bytes(void* data, std::size_t size) {
    if (size > bytes_.size()) failed_ = true;
    if (failed_) return;
    if (size != 0) std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  template <RecordNumber T>
  void take(T& value) {
    take_bytes(&value, sizeof value);
  }
  void take(bool& value) {
    std::uint8_t byte = 0;
    take_bytes(&byte, 1);
    value = byte != 0;
  }
  /// A count that the bytes left can hold: every item takes at least one.
  std::size_t take_count() {
    std::uint64_t count = 0;
    take(count);
    if (count > bytes_.size()) failed_ = true;
    return failed_ ? 0 : static_cast<std::size_t>(count);
  }
  void take(std::string& text) {
    text.resize(take_count());
    take_bytes(text.data(), text.size());
  }
  template <class T>
  void take(std::vector<T>& items) {
    const std::size_t count = take_count();
    items.clear();
    for (std::size_t i = 0; i < count && !failed_; ++i) take(items.emplace_back());
  }
  template <class T, std::size_t n>
  void take(std::array<T, n>& items) {
    for (T& item : items) take(item);
  }
  template <class T>
  void take(std::optional<T>& item) {
    bool present = false;
    take(present);
    if (present && !failed_) take(item.emplace());
  }
  template <class T>
  void take(T& structure) {
    fields(*this, structure);
  }

  std::span<const std::byte> bytes_;
  bool failed_ = false;
};

/// What tells one kind of record from another.
struct RecordKind {
  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  friend bool operator==(const RecordKind&, const RecordKind&) = default;
};

/// Bytes in front of and behind the payload of a record: kind and length, and a checksum.
inline constexpr std::size_t record_head = 8 + sizeof(std::uint32_t) + sizeof(std::uint64_t);
inline constexpr std::size_t record_tail = sizeof(std::uint64_t);

/// A payload with its head and tail.
std::vector<std::byte> framed(const RecordKind& kind, std::span<const std::byte> payload);
/// The length of the payload that a head announces; nothing if it is none of this kind.
std::optional<std::uint64_t> announced_length(const RecordKind& kind,
                                              std::span<const std::byte, record_head> head);
/// The payload of one complete, undamaged record; nothing for other bytes.
std::optional<std::span<const std::byte>> payload_of(const RecordKind& kind,
                                                     std::span<const std::byte> record);

}  // namespace lepp
