// The adaptive loop of a simulation code, on an installed lepp: solve, estimate, mark, bisect,
// transfer. The solver is the code's own, here finite elements for -div(grad u) = 0 with Eigen;
// what it takes to make it adaptive is below "the loop", 40 lines.
// Exit status 0 if the error falls as it should: as 1 / sqrt(unknowns), at a corner where uniform
// meshes give no more than the cube root.

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "lepp/bisection/forest.hpp"
#include "lepp/bisection/transfer.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

using namespace lepp;

namespace {

// ---- the problem: u = r^(2/3) sin(2/3 theta) on an L, its values given on the boundary ----------
double exact(Point p) {
  const double angle = std::atan2(p.y, p.x);
  const double theta = angle < 0 ? angle + 2 * std::acos(-1.0) : angle;
  return std::pow(dot(p, p), 1.0 / 3) * std::sin(2 * theta / 3);
}

Mesh l_shape() {
  const std::vector<double> corners{-1, -1, 0, -1, 0, 0, 1, 0, 1, 1, -1, 1};
  const std::vector<std::uint32_t> sides{0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 0};
  return constrained_delaunay(pslg_from_arrays(corners, sides)).mesh;
}

// ---- the solver ---------------------------------------------------------------------------------
Point turned(Point p) { return {-p.y, p.x}; }

Point gradient(const Mesh& mesh, TriangleId t, const std::vector<double>& u) {
  const auto [a, b, c] = mesh.vertices(t);
  const Point ab = mesh.point(b) - mesh.point(a), ac = mesh.point(c) - mesh.point(a);
  const double to_b = u[b.index()] - u[a.index()], to_c = u[c.index()] - u[a.index()];
  return (1 / cross(ab, ac)) * (to_c * turned(ab) - to_b * turned(ac));
}

void solve(const Mesh& mesh, std::vector<double>& u) {  // from what u is already
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd free = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(u.size()));
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto x = mesh.corners(t);
    const double scale = 0.5 / cross(x[1] - x[0], x[2] - x[0]);
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (mesh.is_boundary({t, k})) free[mesh.origin({t, k}).value] = 0;
      for (std::uint32_t l = 0; l < 3; ++l) {
        const Point opposite_k = x[(k + 2) % 3] - x[(k + 1) % 3];
        const Point opposite_l = x[(l + 2) % 3] - x[(l + 1) % 3];
        entries.emplace_back(mesh.vertex(t, k).value, mesh.vertex(t, l).value,
                             scale * dot(opposite_k, opposite_l));
      }
    }
  }
  Eigen::Map<Eigen::VectorXd> values(u.data(), free.size());
  for (Eigen::Index v = 0; v < free.size(); ++v) {
    if (free[v] == 0) values[v] = exact(mesh.point(VertexId(static_cast<std::size_t>(v))));
  }
  Eigen::SparseMatrix<double> K(values.size(), values.size());
  K.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd right = -free.cwiseProduct(K * values);  // for the correction, which is 0
  K.prune([&](Eigen::Index k, Eigen::Index l, double) {          // where u is given
    return k == l || (free[k] != 0 && free[l] != 0);
  });
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(K);
  solver.setTolerance(1e-8);
  values += solver.solve(right);
}

// The energy of u_h less the interpolated solution: for the check at the end.
double distance_to_exact(const Mesh& mesh, std::vector<double> u) {
  for (std::size_t v = 0; v < u.size(); ++v) u[v] -= exact(mesh.points()[v]);
  double squared = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto [a, b, c] = mesh.corners(TriangleId(i));
    const Point g = gradient(mesh, TriangleId(i), u);
    squared += 0.5 * cross(b - a, c - a) * dot(g, g);
  }
  return std::sqrt(squared);
}

// ---- the loop -----------------------------------------------------------------------------------
std::vector<double> estimate(const Mesh& mesh, const std::vector<double>& u) {
  std::vector<double> eta(mesh.triangle_count(), 0.0);  // squared: |e|^2 [du/dn]^2 / 2 by edge
  for (std::size_t i = 0; i < eta.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      const auto across = mesh.twin(e);
      if (!across) continue;
      const Point along = mesh.point(mesh.destination(e)) - mesh.point(mesh.origin(e));
      const Point jump = gradient(mesh, e.triangle, u) - gradient(mesh, across->triangle, u);
      eta[i] += 0.5 * std::pow(cross(along, jump), 2);
    }
  }
  return eta;
}

// Those with half of the sum, the largest first.
std::vector<TriangleId> mark(const std::vector<double>& eta) {
  std::vector<TriangleId> order;
  for (std::size_t i = 0; i < eta.size(); ++i) order.emplace_back(i);
  std::ranges::stable_sort(order, std::greater<>(), [&](TriangleId t) { return eta[t.index()]; });
  double left = 0.5 * std::accumulate(eta.begin(), eta.end(), 0.0);
  const auto enough = [&](TriangleId t) { return (left -= eta[t.index()]) <= 0; };
  const auto last = std::ranges::find_if(order, enough);
  return {order.begin(), last == order.end() ? last : last + 1};
}

}  // namespace

int main() {
  Forest forest(l_shape());
  std::vector<double> u(forest.mesh().vertex_count(), 0.0);
  std::vector<std::size_t> roots(forest.mesh().triangle_count());  // any data on triangles
  std::iota(roots.begin(), roots.end(), 0);
  std::vector<double> unknowns, errors;
  while (true) {
    solve(forest.mesh(), u);
    const std::vector<double> eta = estimate(forest.mesh(), u);
    unknowns.push_back(static_cast<double>(u.size()));
    errors.push_back(std::sqrt(std::accumulate(eta.begin(), eta.end(), 0.0)));
    if (u.size() > 5000) break;
    const Refinement refined = forest.bisect(mark(eta));
    transfer_vertices(refined, u);
    transfer_triangles(refined, roots);
  }

  // ---- the check --------------------------------------------------------------------------------
  const std::size_t half = unknowns.size() / 2;
  const double rate = std::log(errors[half] / errors.back()) /  //
                      std::log(unknowns.back() / unknowns[half]);
  const double distance = distance_to_exact(forest.mesh(), u);
  bool roots_are_right = roots.size() == forest.mesh().triangle_count();
  for (std::size_t t = 0; t < roots.size(); ++t) {
    roots_are_right = roots_are_right && forest.root(TriangleId(t)).index() == roots[t];
  }
  std::printf("%zu meshes, %zu vertices: estimate %.2e falls as unknowns^-%.3f, u is %.2e off\n",
              errors.size(), u.size(), errors.back(), rate, distance);
  return rate > 0.47 && rate < 0.55 && distance < 2e-3 && roots_are_right ? 0 : 1;
}
