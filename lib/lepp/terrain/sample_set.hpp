#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lepp {

/// Samples of a grid by their index (HeightGrid::index()), a bit for each.
class SampleSet {
 public:
  static constexpr std::size_t bits = 64;  ///< of a word
  explicit SampleSet(std::size_t size) : words_((size + 63) / 64, 0) {}
  /// Of the word that begins with sample `first`.
  bool contains_all(std::size_t first) const { return words_[first / 64] == ~std::uint64_t{0}; }
  bool contains(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  /// All from `first` to before `end`.
  void add(std::size_t first, std::size_t end) {
    for (; first < end && first % 64 != 0; ++first) add(first);
    for (; first + 64 <= end; first += 64) words_[first / 64] = ~std::uint64_t{0};
    for (; first < end; ++first) add(first);
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace lepp
