#include "lepp/refine/even_out.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

constexpr int most_rounds = 8;

// Cosine of the angle at b.
double cosine(Point a, Point b, Point c) {
  const Point u = a - b, v = c - b;
  return dot(u, v) / std::sqrt(dot(u, u) * dot(v, v));
}

// Of the largest angle around a star with its center at p: the smaller, the larger the angle.
double least_cosine(const Star& star, Point p) {
  double least = 1;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Point a = star.from(i), b = star.to(i);
    least = std::min({least, cosine(p, a, b), cosine(a, b, p), cosine(b, p, a)});
  }
  return least;
}

Point mean_of_link(const Star& star) {
  Point sum{0, 0};
  for (const auto& side : star.link) sum = sum + side.from;
  return (1.0 / static_cast<double>(star.size())) * sum;
}

}  // namespace

EvenOut::EvenOut(Mesh& mesh, const RefineOptions& options, double floor)
    : mesh_(mesh), options_(options), good_star_(mesh, options, floor) {}

void EvenOut::run() {
  for (int i = 0; i < most_rounds; ++i) {
    if (round() == 0) return;
  }
}

// How many vertices were moved.
std::size_t EvenOut::round() {
  std::size_t moved = 0;
  for (std::size_t i = 0; i < mesh_.triangle_count(); ++i) {
    if (options_.progress && i % 4096 == 0 && !options_.progress(mesh_.vertex_count())) return 0;
    const TriangleId t(i);
    for (std::uint32_t k = 0; k < 3 && is_obtuse_at(t); ++k) {
      moved += move_towards_mean(t, k) ? 1 : 0;
    }
  }
  return moved;
}

bool EvenOut::is_obtuse_at(TriangleId t) const {
  const auto [a, b, c] = mesh_.corners(t);
  return dot(a - b, c - b) < 0 || dot(b - c, a - c) < 0 || dot(c - a, b - a) < 0;
}

bool EvenOut::move_towards_mean(TriangleId t, std::uint32_t corner) {
  const VertexId v = mesh_.vertex(t, corner);
  if (mesh_.origin_of(v).kind != VertexOrigin::Kind::interior) return false;
  if (!find_star(mesh_, t, corner, star_)) return false;
  const Point p = mesh_.point(v), mean = mean_of_link(star_);
  const double before = least_cosine(star_, p);
  for (const double part : {1.0, 0.5, 0.25}) {
    const Point q = p + part * (mean - p);
    if (least_cosine(star_, q) <= before + 1e-3) continue;
    changed_.clear();
    if (good_star_.move_corner_to(t, corner, q, changed_)) return true;
  }
  return false;
}

}  // namespace lepp
