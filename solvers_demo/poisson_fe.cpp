#include "poisson_fe.hpp"

#include <array>
#include <cmath>

#include "lepp/geometry/triangle_measures.hpp"

namespace lepp::demo {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Gradients of the three hat functions on a triangle: phi_i falls from 1 at corner i to 0 along
/// the opposite edge, so its gradient is that edge turned by 90 degrees, over twice the area.
std::array<Point, 3> hat_gradients(const std::array<Point, 3>& x, double area) {
  std::array<Point, 3> gradients;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Point edge = x[previous_corner(i)] - x[next_corner(i)];
    gradients[i] = {-edge.y / (2 * area), edge.x / (2 * area)};
  }
  return gradients;
}

int row(VertexId v) { return static_cast<int>(v.value); }

void add_stiffness(const Mesh& mesh, const std::vector<double>& diffusion, Triplets& entries) {
  entries.reserve(entries.size() + 9 * mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto x = mesh.corners(t);
    const double area = signed_area(x[0], x[1], x[2]);
    const auto gradients = hat_gradients(x, area);
    const double D = diffusion[mesh.region(t).index()];
    for (std::uint32_t k = 0; k < 3; ++k) {
      for (std::uint32_t l = 0; l < 3; ++l) {
        entries.emplace_back(row(mesh.vertex(t, k)), row(mesh.vertex(t, l)),
                             D * area * dot(gradients[k], gradients[l]));
      }
    }
  }
}

/// Integrals of f phi_k by three points inside, one near each corner: never on an interface, where
/// f may jump.
void add_source(const Mesh& mesh, const std::vector<Field>& source, Eigen::VectorXd& b) {
  constexpr double near = 2.0 / 3, far = 1.0 / 6;  // barycentric coordinates
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const Field& f = source[mesh.region(t).index()];
    if (!f) continue;
    const auto x = mesh.corners(t);
    const double third = signed_area(x[0], x[1], x[2]) / 3;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t l = next_corner(k), m = previous_corner(k);
      const double load = third * f(near * x[k] + far * x[l] + far * x[m]);
      b[row(mesh.vertex(t, k))] += near * load;
      b[row(mesh.vertex(t, l))] += far * load;
      b[row(mesh.vertex(t, m))] += far * load;
    }
  }
}

/// Integrals of g phi_k over an edge, by the two Gauss points.
void add_edge_load(const Mesh& mesh, HalfEdge e, const Field& g, Eigen::VectorXd& b) {
  const VertexId k = mesh.origin(e), l = mesh.destination(e);
  const Point a = mesh.point(k), direction = mesh.point(l) - a;
  const double length = std::sqrt(dot(direction, direction));
  for (const double s : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
    const double load = length / 2 * g(a + s * direction);
    b[row(k)] += (1 - s) * load;
    b[row(l)] += s * load;
  }
}

/// alpha times the integrals of phi_k phi_l over the edge.
void add_robin(const Mesh& mesh, HalfEdge e, double alpha, Triplets& entries) {
  const VertexId k = mesh.origin(e), l = mesh.destination(e);
  const double length = std::sqrt(squared_distance(mesh.point(k), mesh.point(l)));
  entries.emplace_back(row(k), row(k), alpha * length / 3);
  entries.emplace_back(row(l), row(l), alpha * length / 3);
  entries.emplace_back(row(k), row(l), alpha * length / 6);
  entries.emplace_back(row(l), row(k), alpha * length / 6);
}

SparseMatrix matrix_of(const Mesh& mesh, const Triplets& entries) {
  const auto n = static_cast<Eigen::Index>(mesh.vertex_count());
  SparseMatrix K(n, n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

}  // namespace

SparseMatrix fe_stiffness(const Mesh& mesh, const std::vector<double>& diffusion) {
  Triplets entries;
  add_stiffness(mesh, diffusion, entries);
  return matrix_of(mesh, entries);
}

LinearSystem assemble_fe(const Mesh& mesh, const PoissonProblem& problem) {
  Triplets entries;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertex_count()));
  add_stiffness(mesh, problem.diffusion, entries);
  add_source(mesh, problem.source, b);
  for (const Neumann& condition : problem.neumann) {
    for (const HalfEdge e : edges_of(mesh, condition.part)) {
      add_edge_load(mesh, e, condition.flux, b);
    }
  }
  for (const Robin& condition : problem.robin) {
    const Field exchange = [&](Point p) { return condition.alpha * condition.outside(p); };
    for (const HalfEdge e : edges_of(mesh, condition.part)) {
      add_robin(mesh, e, condition.alpha, entries);
      add_edge_load(mesh, e, exchange, b);
    }
  }
  return {matrix_of(mesh, entries), std::move(b)};
}

Solution solve_fe(const Mesh& mesh, const PoissonProblem& problem) {
  return solve(mesh, problem, assemble_fe(mesh, problem));
}

}  // namespace lepp::demo
