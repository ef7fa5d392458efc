#include "lepp/bisection/common_parts.hpp"

namespace lepp {
namespace {

std::vector<Point> middles_of(const Mesh& mesh) {
  std::vector<Point> middles;
  middles.reserve(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    middles.push_back((1.0 / 3) * (a + b + c));
  }
  return middles;
}

}  // namespace

CommonParts::CommonParts(const Mesh& before, const Mesh& after)
    : before_(before),
      after_(after),
      middles_(locate(before, middles_of(after))),
      reached_by_(before.triangle_count(), 0) {}

void CommonParts::reach(TriangleId old) {
  if (reached_by_[old.index()] == current_) return;
  reached_by_[old.index()] = current_;
  queue_.push_back(old);
}

void CommonParts::start_at(TriangleId t) {
  current_ = t.value + 1;
  queue_.clear();
  if (const auto& middle = middles_[t.index()]) return reach(middle->triangle);
  if (!locator_) locator_.emplace(before_);
  const auto x = after_.corners(t);
  const Point middle = (1.0 / 3) * (x[0] + x[1] + x[2]);
  for (const Point corner : x) {
    for (const double part : {0.99, 0.5}) {
      const auto place = locator_->locate(part * corner + (1 - part) * middle);
      if (place) reach(place->triangle);
    }
  }
}

}  // namespace lepp
