#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_point.hpp"
#include "lepp/refine/size_test.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The triangles still to be worked on, in a few buckets: too large, then by smallest angle, then
/// those whose only fault is too large an angle. Worst
/// bucket first, last in first out inside it, so the next target mostly lies beside the last
/// change. Before all others come those that are too large and on the front (SizePoint), first in
/// first out, so that the front advances evenly. Entries are dropped when their triangle has
/// changed by the time they come up.
class TargetBuckets {
 public:
  TargetBuckets(const Mesh& mesh, const RefineOptions& options);
  TargetBuckets(const TargetBuckets&) = delete;  // the point rule refers to the size test
  TargetBuckets& operator=(const TargetBuckets&) = delete;

  /// Adds `t` if it is too large or has a small angle.
  void add(const Mesh& mesh, TriangleId t);
  /// Takes out the next one that is still there.
  std::optional<TriangleId> next(const Mesh& mesh);

  bool is_too_large(TriangleId t) const { return size_.is_too_large(t); }
  const SizeTest& size() const { return size_; }
  const SizePoint& size_point() const { return size_point_; }
  bool has_small_angle(const Mesh& mesh, TriangleId t) const {
    const auto [a, b, c] = mesh.corners(t);
    return angle_.is_below(a, b, c);
  }
  bool has_large_angle(const Mesh& mesh, TriangleId t) const {
    const auto [a, b, c] = mesh.corners(t);
    return angle_.is_above(a, b, c);
  }

 private:
  static constexpr std::size_t angle_buckets = 4;
  struct Entry {
    TriangleId triangle;
    std::array<VertexId, 3> vertices;
  };

  static bool is_still_there(const Mesh& mesh, const Entry& entry);
  std::optional<TriangleId> next_on_front(const Mesh& mesh);

  AngleTest angle_;
  SizeTest size_;
  SizePoint size_point_;
  std::vector<Entry> front_;
  std::size_t first_on_front_ = 0;
  std::size_t first_ = 0;                         // the buckets before it are empty
  std::array<double, angle_buckets - 1> limits_;  // cos^2 of the smallest angle, worst first
  std::array<std::vector<Entry>, angle_buckets + 2> buckets_;
};

}  // namespace lepp
