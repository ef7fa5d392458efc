#include "cross_points.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "adaptive_problems.hpp"
#include "drawing.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "multigrid.hpp"
#include "poisson_fe.hpp"
#include "support/random.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

///      c---b        A regular polygon with a vertex in the middle, and a region of its own, 0 to
///     / \ / \       n - 1, in each of n sectors.
///    d---m---a
///     \ / \ /
///      e---f
Mesh wheel(std::size_t n) {
  Drawing draw("a wheel");
  const VertexId middle = draw.point({0, 0});
  std::vector<VertexId> rim;
  const auto at = [&](double i) {
    const double angle = 0.3 + 2 * std::numbers::pi * i / static_cast<double>(n);
    return Point{std::cos(angle), std::sin(angle)};
  };
  for (std::size_t i = 0; i < n; ++i) rim.push_back(draw.point(at(static_cast<double>(i))));
  for (std::size_t i = 0; i < n; ++i) {
    draw.curve("rim " + std::to_string(i), {rim[i], rim[(i + 1) % n]});
    draw.curve("spoke " + std::to_string(i), {middle, rim[i]});
    const Point inside = at(static_cast<double>(i) + 0.5);
    draw.surface(std::to_string(i), 0.5 * inside);
  }
  return constrained_delaunay(draw.pslg()).mesh;
}

std::vector<TriangleId> all_of(const Mesh& mesh) {
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) all.emplace_back(t);
  return all;
}

std::vector<TriangleId> around(const Mesh& mesh, VertexId v) {
  std::vector<TriangleId> found;
  for_each_in_fan(mesh, v, [&](TriangleId t, std::uint32_t) { found.push_back(t); });
  return found;
}

std::vector<char> inner_vertices(const Mesh& mesh) {
  std::vector<char> inner(mesh.vertex_count(), 1);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (mesh.is_boundary(e)) inner[mesh.origin(e).index()] = 0;
    }
  }
  return inner;
}

/// A wheel that is graded to its middle.
struct GradedWheel {
  Forest forest;
  std::vector<NewVertex> made;
  std::vector<double> diffusion;
  LinearSystem system;
  std::vector<char> free;

  explicit GradedWheel(std::vector<double> D, int rounds)
      : forest(wheel(D.size())), diffusion(std::move(D)) {
    for (int i = 0; i < 5; ++i) refine(all_of(forest.mesh()));
    for (int i = 0; i < rounds; ++i) refine(around(forest.mesh(), VertexId(0U)));
    free = inner_vertices(forest.mesh());
    system.K = fe_stiffness(forest.mesh(), diffusion);
    system.b.resize(system.K.cols());
    test::Random random(11);
    for (double& b : system.b) b = random.real(-1, 1);
  }

  void refine(const std::vector<TriangleId>& marked) {
    const Refinement done = forest.bisect(marked);
    made.insert(made.end(), done.vertices.begin(), done.vertices.end());
  }

  std::size_t iterations(const SparseMatrix& modes) const {
    const Multigrid multigrid(system.K, free, made, modes);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(system.b.size());
    const auto solution = solve_iteratively(system, free, multigrid, zero);
    CHECK(solution.converged);
    return solution.iterations;
  }
};

}  // namespace

TEST_CASE("the checkerboard has one cross point with two peaks; other problems have none") {
  const AdaptiveProblem board = kellogg();
  const auto found = cross_points(board.start, board.problem.diffusion);
  REQUIRE(found.size() == 1);
  CHECK(board.start.point(found[0].vertex) == Point{0, 0});
  CHECK(found[0].sectors.size() == 4);
  CHECK(found[0].peaks.size() == 2);
  for (const std::string name : {"l-shape", "front", "peak"}) {
    const AdaptiveProblem other = adaptive_problem(name);
    CHECK(cross_points(other.start, other.problem.diffusion).empty());
    const std::vector<char> free(other.start.vertex_count(), 1);
    CHECK(cross_point_modes(other.start, other.problem.diffusion, free).cols() == 0);
  }
}

TEST_CASE("cross points: peaks are sectors with more than both neighbours, equal ones are merged") {
  const auto peaks = [](const std::vector<double>& D) {
    const auto found = cross_points(wheel(D.size()), D);
    return found.empty() ? std::size_t{0} : found[0].peaks.size();
  };
  CHECK(peaks({9, 1, 9, 1, 9, 1}) == 3);
  CHECK(peaks({9, 1, 8, 7, 2, 2}) == 2);
  CHECK(peaks({9, 9, 1, 5, 1, 1}) == 2);
  CHECK(peaks({1, 2, 3, 4, 3, 2}) == 0);
  CHECK(peaks({2, 2, 2, 2, 2, 2}) == 0);
}

TEST_CASE("modes are between -1 and 1, 0 at given values, and 1 on a peak, near the cross point") {
  const GradedWheel wheel({100, 1, 100, 1, 2, 1, 100, 3}, 20);
  const Mesh& mesh = wheel.forest.mesh();
  const SparseMatrix modes = cross_point_modes(mesh, wheel.diffusion, wheel.free);
  const auto found = cross_points(mesh, wheel.diffusion);
  REQUIRE(found.size() == 1);
  REQUIRE(found[0].peaks.size() == 4);
  CHECK(modes.cols() % 3 == 0);
  CHECK(modes.cols() >= 3 * 10);
  for (Eigen::Index k = 0; k < modes.cols(); ++k) {
    double largest = 0;
    for (SparseMatrix::InnerIterator entry(modes, k); entry; ++entry) {
      CHECK(std::abs(entry.value()) <= 1);
      CHECK(wheel.free[static_cast<std::size_t>(entry.row())] != 0);
      largest = std::max(largest, std::abs(entry.value()));
    }
    CHECK(largest > 0.2);
  }
  // Hats add up to 1 inside the first halving: on each peak one value, which the other functions do
  // not share.
  const auto here = [&](VertexId v, Eigen::Index kind) {
    double sum = 0;
    for (Eigen::Index k = kind; k < modes.cols(); k += 3) sum += modes.coeff(v.value, k);
    return sum;
  };
  for (const TriangleId t : around(mesh, VertexId(0U))) {
    const double D = wheel.diffusion[mesh.region(t).index()];
    if (D < 2 || D == 3) continue;  // no peak
    for (const VertexId v : mesh.vertices(t)) {
      if (v == VertexId(0U)) continue;
      CAPTURE(D);
      const double largest = std::max({here(v, 0), here(v, 1), here(v, 2)});
      const double smallest = std::min({here(v, 0), here(v, 1), here(v, 2)});
      CHECK((std::abs(largest - 1) < 1e-9 || std::abs(smallest + 1) < 1e-9));
    }
  }
}

TEST_CASE("multigrid at a cross point of any contrast: modes more than halve the iterations") {
  for (const std::vector<double>& D : {std::vector<double>{200, 1, 200, 1},
                                       {1e6, 1, 1e5, 10},
                                       {1000, 1, 300, 2, 500, 3},
                                       {1e6, 1, 1e6, 1e3, 1e6, 1}}) {
    CAPTURE(D.size());
    const GradedWheel wheel(D, 100);
    const auto modes = cross_point_modes(wheel.forest.mesh(), wheel.diffusion, wheel.free);
    const std::size_t with = wheel.iterations(modes), without = wheel.iterations({});
    CAPTURE(without);
    CHECK(with <= 10);
    CHECK(2 * with < without);
  }
}

TEST_CASE("what the modes span is found exactly, also if they depend on each other") {
  const GradedWheel wheel({50, 1, 50, 1}, 10);
  SparseMatrix modes = cross_point_modes(wheel.forest.mesh(), wheel.diffusion, wheel.free);
  SparseMatrix twice(modes.rows(), modes.cols() + 2);  // the first again, and an empty one
  twice.leftCols(modes.cols()) = modes;
  twice.col(modes.cols()) = modes.col(0);
  const Multigrid multigrid(wheel.system.K, wheel.free, wheel.made, twice);
  for (Eigen::Index k = 0; k < modes.cols(); ++k) {
    Eigen::VectorXd r = wheel.system.K * modes.col(k), z;
    for (Eigen::Index v = 0; v < r.size(); ++v) {
      if (wheel.free[static_cast<std::size_t>(v)] == 0) r[v] = 0;
    }
    multigrid.apply(r, z);
    const Eigen::VectorXd mode = modes.col(k);
    CHECK((z - mode).cwiseAbs().maxCoeff() < 1e-9);
  }
}
