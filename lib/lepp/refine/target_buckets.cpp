#include "lepp/refine/target_buckets.hpp"

#include <algorithm>
#include <cmath>

namespace lepp {

TargetBuckets::TargetBuckets(const Mesh& mesh, const RefineOptions& options)
    : angle_(options.min_angle_deg, options.max_angle_deg),
      size_(mesh, options),
      size_point_(mesh, size_) {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double part = static_cast<double>(i + 1) / static_cast<double>(angle_buckets);
    limits_[i] = AngleTest::squared_cos(part * options.min_angle_deg);
  }
}

void TargetBuckets::add(const Mesh& mesh, TriangleId t) {
  if (size_.is_too_large(t)) {
    if (size_point_.is_on_front(t)) {
      front_.push_back({t, mesh.vertices(t)});
      return;
    }
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

bool TargetBuckets::is_still_there(const Mesh& mesh, const Entry& entry) {
  return entry.triangle.index() < mesh.triangle_count() &&
         mesh.vertices(entry.triangle) == entry.vertices;
}

std::optional<TriangleId> TargetBuckets::next_on_front(const Mesh& mesh) {
  while (first_on_front_ < front_.size()) {
    const Entry entry = front_[first_on_front_++];
    if (2 * first_on_front_ > front_.size()) {  // moves each entry about once
      front_.erase(front_.begin(), front_.begin() + static_cast<std::ptrdiff_t>(first_on_front_));
      first_on_front_ = 0;
    }
    if (is_still_there(mesh, entry)) return entry.triangle;
  }
  return std::nullopt;
}

std::optional<TriangleId> TargetBuckets::next(const Mesh& mesh) {
  if (const auto t = next_on_front(mesh)) return t;
  for (; first_ < buckets_.size(); ++first_) {
    auto& bucket = buckets_[first_];
    while (!bucket.empty()) {
      const Entry entry = bucket.back();
      bucket.pop_back();
      if (is_still_there(mesh, entry)) return entry.triangle;
    }
  }
  return std::nullopt;
}

}  // namespace lepp
