#include "lepp/refine/size_test.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

const double equilateral = std::sqrt(3.0) / 4;  // area at edge 1

// How much smaller than the bounds triangles are made. With areas nine triangles of ten then keep
// the bound at once, and the mesh has about as many triangles as the bound suggests.
constexpr double share_of_area = 0.75, share_of_edge = 0.7;

// Answers of the field are remembered in a table of 2^15 places.
constexpr int memory_bits = 15;

std::size_t place_in_memory(Point p) {
  const std::uint64_t x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y);
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio: spreads all bits
  return static_cast<std::size_t>(((x * odd ^ y) * odd) >> (64 - memory_bits));
}

struct Corners {
  Point a, b, c;
};

}  // namespace

SizeTest::SizeTest(const Mesh& mesh, const RefineOptions& options)
    : mesh_(mesh), options_(options), everywhere_(make_bound(options.max_edge, options.max_area)) {
  for (const SurfaceEntity& s : mesh.entities().surfaces) {
    by_region_.push_back(
        make_bound(std::min(options.max_edge, s.max_edge), std::min(options.max_area, s.max_area)));
  }
  const auto is_limit = [](const Bound& b) { return std::isfinite(b.wanted_edge); };
  has_field_ = options.size || options.size_in;
  any_ = has_field_ || is_limit(everywhere_) || std::ranges::any_of(by_region_, is_limit);
  points_ = options.size.target<SizeField>();
  if (options.size) answers_.resize(std::size_t{1} << memory_bits);
}

SizeTest::Bound SizeTest::make_bound(double edge, double area) {
  const double by_area = std::sqrt(share_of_area * area / equilateral);
  return {edge * edge, area, std::min(share_of_edge * edge, by_area)};
}

double SizeTest::checked(double size, Point p) {
  if (size > 0) return size;
  throw InputError("size field at " + to_text(p), "is " + to_text(size), "give lengths above 0");
}

double SizeTest::field_at(Point p) const {
  Answer& answer = answers_[place_in_memory(p)];
  if (!(answer.at == p) || !(answer.size > 0)) answer = {p, checked(options_.size(p), p)};
  return answer.size;
}

double SizeTest::squared_size_in(Point a, Point b, Point c) const {
  const Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  double size = std::numeric_limits<double>::infinity();
  if (options_.size) {
    size = std::min({field_at(centroid), field_at(a), field_at(b), field_at(c)});
  }
  if (options_.size_in) size = std::min(size, checked(options_.size_in(a, b, c), centroid));
  if (points_ != nullptr) size = points_->least_within(a, b, c, size);
  return size * size;
}

double SizeTest::excess(Point a, Point b, Point c, SurfaceId region) const {
  const Bound& limit = bound(region);
  const double longest =
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  double edge = limit.squared_edge;
  if (has_field_) edge = std::min(edge, squared_size_in(a, b, c));
  return std::max(longest / edge, signed_area(a, b, c) / limit.area);
}

double SizeTest::wanted_edge(Point p, SurfaceId region) const {
  const double wanted = bound(region).wanted_edge;
  return options_.size ? std::min(wanted, share_of_edge * field_at(p)) : wanted;
}

// The field is integrated over equal parts of the triangle, smaller and smaller until the size
// varies little in each.
double SizeTest::predicted_triangles(Point a, Point b, Point c, SurfaceId region) const {
  const Bound& limit = bound(region);
  const double area = std::min(limit.area, equilateral * limit.squared_edge);
  if (!options_.size) return signed_area(a, b, c) / area;
  constexpr std::size_t most_parts = 4096;
  std::vector<Corners> parts{{a, b, c}};
  double predicted = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {  // ends: by the number of parts
    const auto [p, q, r] = parts[i];
    const Point x = midpoint(q, r), y = midpoint(r, p), z = midpoint(p, q);
    const double sizes[] = {field_at(p), field_at(q), field_at(r),
                            field_at(x), field_at(y), field_at(z)};
    const auto [least, most] = std::ranges::minmax(sizes);
    if (most > 1.5 * least && parts.size() < most_parts) {
      for (const Corners& part : {Corners{p, z, y}, {z, q, x}, {y, x, r}, {x, y, z}}) {
        parts.push_back(part);
      }
      continue;
    }
    double density = 0;  // mean of 1 / area of one triangle
    for (const double size : sizes) density += 1 / std::min(area, equilateral * size * size);
    predicted += signed_area(p, q, r) * density / 6;
  }
  return predicted;
}

}  // namespace lepp
