#include "lepp/refine/target_buckets.hpp"

#include <algorithm>
#include <cmath>

namespace lepp {

TargetBuckets::TargetBuckets(const Mesh& mesh, const RefineOptions& options)
    : angle_(options.min_angle_deg, options.max_angle_deg), size_(mesh, options) {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double part = static_cast<double>(i + 1) / static_cast<double>(angle_buckets);
    limits_[i] = AngleTest::squared_cos(part * options.min_angle_deg);
  }
}

void TargetBuckets::add(const Mesh& mesh, TriangleId t) {
  if (size_.is_too_large(t)) {
    buckets_.front().push_back({t, mesh.vertices(t)});
    first_ = 0;
    return;
  }
  const auto [a, b, c] = mesh.corners(t);
  const AngleTest::SquaredCos smallest = AngleTest::of_smallest(a, b, c);
  if (angle_.is_below(smallest)) {
    std::size_t bucket = 1;
    for (const double limit : limits_) bucket += smallest > limit ? 0 : 1;
    buckets_[bucket].push_back({t, mesh.vertices(t)});
    first_ = std::min(first_, bucket);
  } else if (angle_.is_above(a, b, c)) {
    buckets_.back().push_back({t, mesh.vertices(t)});
    first_ = std::min(first_, buckets_.size() - 1);
  }
}

std::optional<TriangleId> TargetBuckets::next(const Mesh& mesh) {
  for (; first_ < buckets_.size(); ++first_) {
    auto& bucket = buckets_[first_];
    while (!bucket.empty()) {
      const Entry entry = bucket.back();
      bucket.pop_back();
      if (entry.triangle.index() < mesh.triangle_count() &&
          mesh.vertices(entry.triangle) == entry.vertices) {
        return entry.triangle;
      }
    }
  }
  return std::nullopt;
}

}  // namespace lepp
