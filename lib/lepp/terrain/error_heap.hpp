#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The triangles whose error is above a limit, the worst one on top; of equals that with the lower
/// id. A triangle is at most once in it and moves when its error changes.
class ErrorHeap {
 public:
  explicit ErrorHeap(double limit) : limit_(limit) {}

  /// Triangle `t` has this error now. O(log n)
  void set(TriangleId t, double error);
  /// Nothing if no triangle is above the limit.
  std::optional<TriangleId> top() const;
  double top_error() const { return heap_.empty() ? 0 : heap_.front().error; }
  std::size_t size() const { return heap_.size(); }
  double limit() const { return limit_; }

 private:
  struct Entry {
    double error;
    std::uint32_t triangle;
    bool operator<(const Entry& other) const {
      return error != other.error ? error > other.error : triangle < other.triangle;
    }
  };
  static constexpr std::uint32_t nowhere = 0xFFFFFFFFU;

  void put(std::size_t place, const Entry& entry);
  void rise(std::size_t place, const Entry& entry);
  void sink(std::size_t place, const Entry& entry);
  void remove(std::size_t place);

  double limit_;
  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;  // by triangle
};

}  // namespace lepp
