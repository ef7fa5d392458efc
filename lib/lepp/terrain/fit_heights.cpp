#include "lepp/terrain/fit_heights.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/sample_space.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/triangle_scan.hpp"

namespace lepp {

namespace {

// A sweep that lowers the sum of squares by less than this part of it is the last.
constexpr double little_gain = 1e-4;
// Weights below this are rounding: the sample is on the side across.
constexpr double no_weight = 1e-9;
// Squares of weights that sum up to less say nothing of a vertex: no sample is near, and errors far
// away would be divided by next to nothing.
constexpr double least_known = 1.0 / 64;

// What a corner contributes to the height of a place in the triangle: 1 at the corner, 0 across.
class Weight {
 public:
  Weight(const std::array<TerrainCorner, 3>& corners, std::size_t corner) {
    const TerrainCorner& a = corners[corner];
    const TerrainCorner& b = corners[(corner + 1) % 3];
    const TerrainCorner& c = corners[(corner + 2) % 3];
    const double area =
        (b.column - a.column) * (c.line - a.line) - (c.column - a.column) * (b.line - a.line);
    per_column_ = (b.line - c.line) / area;
    per_line_ = (c.column - b.column) / area;
    at_zero_ = -per_column_ * b.column - per_line_ * b.line;
  }
  double operator()(double column, double line) const {
    return at_zero_ + per_column_ * column + per_line_ * line;
  }
  double per_column() const { return per_column_; }

 private:
  double per_column_, per_line_, at_zero_;
};

// The least squares problem: the sum over samples of (H - sum of weights * heights)^2 has a sparse
// matrix with an entry for each vertex and each edge. Edges are kept by triangle, each side's
// samples in one of its two. Heights are looked at from a corner of each triangle: far from 0 their
// differences are exact, or nearly so, where sums are not.
template <class Height>
class Fit {
 public:
  Fit(const HeightGrid& grid, std::span<const Height> heights, Tin& tin, const FitOptions& options)
      : grid_(grid),
        heights_(heights),
        tin_(tin),
        options_(options),
        space_(grid),
        spans_(grid),
        limit_(options.max_error - 4 * interpolation_rounding(grid)),
        first_heights_(tin.heights),
        diagonal_(tin.heights.size()),
        rest_(tin.heights.size()),
        across_(tin.mesh.triangle_count()) {
    list_stars();
    for (std::size_t i = 0; i < across_.size(); ++i) add_triangle(TriangleId(i));
  }

  std::size_t run() {
    std::size_t sweeps = 0;
    double gain = 0;
    do {
      gain = 0;
      for (std::size_t i = 0; i < tin_.heights.size(); ++i) gain += improve(VertexId(i));
      ++sweeps;
      squares_ -= gain;
    } while (gain > little_gain * squares_ && sweeps < options_.max_sweeps &&
             (!options_.go_on || options_.go_on()));
    return sweeps;
  }

 private:
  struct Corners {
    double base;  // heights are above this
    std::array<TerrainCorner, 3> at;
  };

  // A vertex with several fans has all of their triangles.
  void list_stars() {
    const Mesh& mesh = tin_.mesh;
    first_.assign(mesh.vertex_count() + 1, 0);
    for (const Triangle& t : mesh.triangles()) {
      for (const VertexId v : t.vertices) ++first_[v.index() + 1];
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    star_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
      for (const VertexId v : mesh.triangles()[i].vertices) {
        star_[next[v.index()]++] = TriangleId(i);
      }
    }
  }

  std::span<const TriangleId> star(VertexId v) const {
    const std::size_t first = first_[v.index()];
    return std::span(star_).subspan(first, first_[v.index() + 1] - first);
  }

  Corners corners(TriangleId t) const {
    Corners corners;
    corners.base = tin_.heights[tin_.mesh.vertex(t, 0).index()];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const VertexId v = tin_.mesh.vertex(t, k);
      corners.at[k] = space_.corner(tin_.mesh.point(v), tin_.heights[v.index()] - corners.base);
    }
    return corners;
  }

  const Height* samples(const ScanSpan& span) const {
    return &heights_[grid_.index(span.first, grid_.row_of_line(span.line))];
  }

  void add_triangle(TriangleId t) {
    const auto [base, at] = corners(t);
    const std::array<Weight, 3> weights = {Weight(at, 0), Weight(at, 1), Weight(at, 2)};
    spans_(at, [&, base = base](const ScanSpan& span) {
      const Height* const samples = this->samples(span);
      for (std::uint32_t i = 0; i <= span.last - span.first; ++i) {
        const double off = (samples[i] - base) - (span.height + span.slope * i);
        if (std::isnan(off)) continue;
        std::array<double, 3> w;
        for (std::size_t k = 0; k < 3; ++k) {
          w[k] = weights[k](span.first + i, span.line);
          if (w[k] < no_weight) w[k] = 0;
        }
        if (is_counted(t, w)) add_sample(t, w, off);
      }
      return true;
    });
  }

  // A sample on a side counts in the triangle with the lower number, one at a vertex in the first
  // of its star.
  bool is_counted(TriangleId t, const std::array<double, 3>& w) const {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (w[k] > 1 - no_weight) return star(tin_.mesh.vertex(t, k)).front() == t;
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (w[k] > 0) continue;
      const auto twin = tin_.mesh.twin({t, k});
      return !twin || t < twin->triangle;
    }
    return true;
  }

  void add_sample(TriangleId t, std::array<double, 3> w, double off) {
    for (double& weight : w) weight = weight < no_weight ? 0 : weight;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::size_t v = tin_.mesh.vertex(t, k).index();
      diagonal_[v] += w[k] * w[k];
      rest_[v] += w[k] * off;
      across_[t.index()][k] += w[next_corner(k)] * w[previous_corner(k)];
    }
    squares_ += off * off;
  }

  // Moves one height to where the sum is least, or as far towards it as the bound allows.
  // Returns by how much the sum of squares is less.
  double improve(VertexId v) {
    const std::size_t i = v.index();
    if (diagonal_[i] < least_known || (!options_.is_fixed.empty() && options_.is_fixed[i]))
      return 0;
    const double best = rest_[i] / diagonal_[i];
    // From where it was a vertex goes no farther than samples may be off: one with little weight
    // in its samples would be sent to the skies for them.
    double step = std::clamp(best, first_heights_[i] - options_.max_error - tin_.heights[i],
                             first_heights_[i] + options_.max_error - tin_.heights[i]);
    for (const TriangleId t : star(v)) step = step == 0 ? 0 : allowed(t, v, step);
    if (step == 0) return 0;
    tin_.heights[i] += step;
    rest_[i] -= diagonal_[i] * step;
    for (const TriangleId t : star(v)) tell_neighbours(t, v, step);
    return diagonal_[i] * step * (2 * best - step);
  }

  void tell_neighbours(TriangleId t, VertexId v, double step) {
    const std::uint32_t k = corner_of(t, v);
    const std::uint32_t next = next_corner(k), previous = previous_corner(k);
    const std::array<double, 3>& across = across_[t.index()];
    rest_[tin_.mesh.vertex(t, next).index()] -= across[previous] * step;
    rest_[tin_.mesh.vertex(t, previous).index()] -= across[next] * step;
  }

  std::uint32_t corner_of(TriangleId t, VertexId v) const {
    const auto& vertices = tin_.mesh.triangles()[t.index()].vertices;
    return vertices[0] == v ? 0 : vertices[1] == v ? 1 : 2;
  }

  // How much of a step no sample of the triangle forbids. One that is beyond the bound already, by
  // rounding or because it was so, only must not come farther off.
  double allowed(TriangleId t, VertexId v, double step) const {
    const auto [base, at] = corners(t);
    const Weight weight(at, corner_of(t, v));
    const double sign = step > 0 ? 1 : -1;
    double length = std::abs(step);
    spans_(at, [&, base = base](const ScanSpan& span) {
      const Height* const samples = this->samples(span);
      const double start = weight(span.first, span.line);
      for (std::uint32_t i = 0; i <= span.last - span.first; ++i) {
        const double above = sign * (span.height + span.slope * i - (samples[i] - base));
        const double w = start + weight.per_column() * i;
        if (!(above + w * length > limit_) || w < no_weight) continue;
        length = std::max(0.0, (limit_ - above) / w);
      }
      return length > 0;
    });
    return sign * length;
  }

  const HeightGrid& grid_;
  std::span<const Height> heights_;
  Tin& tin_;
  const FitOptions& options_;
  SampleSpace space_;
  TriangleSpans spans_;
  const double limit_;  // of errors: another way of interpolating differs by a trifle
  const std::vector<double> first_heights_;
  std::vector<double> diagonal_, rest_;        // by vertex: entry, and sum of weight * (H - H*)
  std::vector<std::array<double, 3>> across_;  // by triangle: entry of the side across a corner
  std::vector<std::size_t> first_;             // by vertex, into star_
  std::vector<TriangleId> star_;
  double squares_ = 0;
};

}  // namespace

std::size_t fit_heights(const HeightGrid& grid, Tin& tin, const FitOptions& options) {
  return grid.heights.visit([&](auto heights) { return Fit(grid, heights, tin, options).run(); });
}

std::vector<bool> fixed_vertices(const HeightGrid& grid, const TerrainDomain& domain,
                                 const Tin& tin) {
  std::vector<bool> fixed = hard_vertices(tin);
  if (domain.kept_border.empty()) return fixed;
  const Point corner = grid.sample(grid.columns - 1, grid.rows - 1);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const Point p = tin.mesh.point(VertexId(i));
    const bool on_border = p.x == 0 || p.y == 0 || p.x == corner.x || p.y == corner.y;
    fixed[i] = fixed[i] || on_border;
  }
  return fixed;
}

}  // namespace lepp
