#include "poisson_fv.hpp"

#include <cmath>

#include "lepp/geometry/triangle_measures.hpp"

namespace lepp::demo {
namespace {

/// A matrix that is summed up from exchanges between two vertices.
class Exchanges {
 public:
  explicit Exchanges(const Mesh& mesh) : size_(static_cast<Eigen::Index>(mesh.vertex_count())) {}

  void add(VertexId k_id, VertexId l_id, double t) {  // t (u_k - u_l) leaves k and enters l
    const int k = static_cast<int>(k_id.value), l = static_cast<int>(l_id.value);
    A_.insert(A_.end(), {{k, k, t}, {k, l, -t}, {l, l, t}, {l, k, -t}});
  }

  SparseMatrix matrix() const {
    SparseMatrix K(size_, size_);
    K.setFromTriplets(A_.begin(), A_.end());
    return K;
  }

 private:
  Eigen::Index size_;
  std::vector<Eigen::Triplet<double>> A_;
};

/// Integral over a convex polygon: a fan of triangles, each by three points inside, because f may
/// jump where pieces of different regions touch.
double integral(std::span<const Point> polygon, const Field& f) {
  constexpr double near = 2.0 / 3, far = 1.0 / 6;
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point a = polygon[0], b = polygon[i - 1], c = polygon[i];
    const double mean = (f(near * a + far * b + far * c) + f(far * a + near * b + far * c) +
                         f(far * a + far * b + near * c)) /
                        3;
    sum += signed_area(a, b, c) * mean;
  }
  return sum;
}

void add_source(const VoronoiBoxes& boxes, const std::vector<Field>& source, Eigen::VectorXd& b) {
  for (const VoronoiBox& box : boxes.boxes) {
    const Field& f = source[box.region.index()];
    if (!f) continue;
    for (std::uint32_t i = 0; i < box.pieces; ++i) {
      b[static_cast<Eigen::Index>(box.vertex.index())] +=
          integral(boxes.piece(box.first_piece + i), f);
    }
  }
}

double length_of(const Mesh& mesh, HalfEdge e) {
  return std::sqrt(squared_distance(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))));
}

/// The flux over the half of the edge next to each end, by two Gauss points on each half.
void add_flux(const Mesh& mesh, HalfEdge e, const Field& g, Eigen::VectorXd& b) {
  const VertexId k = mesh.origin(e), l = mesh.destination(e);
  const Point middle = midpoint(mesh.point(k), mesh.point(l));
  const double s = 0.5 - 0.5 / std::sqrt(3.0);
  for (const VertexId v : {k, l}) {
    const Point x = mesh.point(v);
    const double mean = (g((1 - s) * x + s * middle) + g(s * x + (1 - s) * middle)) / 2;
    b[static_cast<Eigen::Index>(v.index())] += length_of(mesh, e) / 2 * mean;
  }
}

void add_robin(const Mesh& mesh, HalfEdge e, const Robin& condition, LinearSystem& system) {
  const double exchange = condition.alpha * length_of(mesh, e) / 2;
  for (const VertexId v : {mesh.origin(e), mesh.destination(e)}) {
    const auto k = static_cast<Eigen::Index>(v.index());
    system.K.coeffRef(k, k) += exchange;
    system.b[k] += exchange * condition.outside(mesh.point(v));
  }
}

LinearSystem with_loads(const Mesh& mesh, const VoronoiBoxes& boxes, const PoissonProblem& problem,
                        SparseMatrix K) {
  LinearSystem system{std::move(K),
                      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertex_count()))};
  add_source(boxes, problem.source, system.b);
  for (const Neumann& condition : problem.neumann) {
    for (const HalfEdge e : edges_of(mesh, condition.part)) {
      add_flux(mesh, e, condition.flux, system.b);
    }
  }
  for (const Robin& condition : problem.robin) {
    for (const HalfEdge e : edges_of(mesh, condition.part)) {
      add_robin(mesh, e, condition, system);
    }
  }
  return system;
}

}  // namespace

SparseMatrix fv_stiffness(const Mesh& mesh, const VoronoiBoxes& boxes,
                          const std::vector<double>& diffusion) {
  Exchanges exchanges(mesh);
  for (const VoronoiFace& f : boxes.faces) {  // sum over l of D sigma_kl / h_kl (u_k - u_l)
    exchanges.add(f.k, f.l, diffusion[f.region.index()] * f.length / f.distance);
  }
  return exchanges.matrix();
}

SparseMatrix fv_stiffness_from_factors(const Mesh& mesh, const std::vector<EdgeFactor>& factors,
                                       const std::vector<double>& diffusion) {
  Exchanges exchanges(mesh);
  for (const EdgeFactor& f : factors) {
    exchanges.add(f.k, f.l, diffusion[f.region.index()] * f.factor);
  }
  return exchanges.matrix();
}

LinearSystem assemble_fv(const Mesh& mesh, const VoronoiBoxes& boxes,
                         const PoissonProblem& problem) {
  return with_loads(mesh, boxes, problem, fv_stiffness(mesh, boxes, problem.diffusion));
}

Solution solve_fv(const Mesh& mesh, const VoronoiBoxes& boxes, const PoissonProblem& problem) {
  return solve(mesh, problem, assemble_fv(mesh, boxes, problem));
}

Solution solve_fv_unclipped(const Mesh& mesh, const VoronoiBoxes& boxes,
                            const PoissonProblem& problem) {
  SparseMatrix K = fv_stiffness_from_factors(mesh, edge_factors(mesh), problem.diffusion);
  return solve(mesh, problem, with_loads(mesh, boxes, problem, std::move(K)));
}

}  // namespace lepp::demo
