#include <algorithm>
#include <cmath>

#include "adaptive_scheme.hpp"
#include "cross_points.hpp"
#include "first_guess.hpp"
#include "lepp/bisection/refine_where.hpp"
#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/unfinished.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "poisson_fv.hpp"
#include "remesh_multigrid.hpp"
#include "stopwatch.hpp"

namespace lepp::demo {
namespace {

double longest_edge_length(const Mesh& mesh) {
  double longest = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    longest = std::max(longest, diameter(mesh, TriangleId(t)));
  }
  return longest;
}

class BoxesByDelaunay : public AdaptiveScheme {
 public:
  BoxesByDelaunay(const AdaptiveProblem& problem, LinearSolver solver)
      : problem_(problem.problem), name_(problem.title), solver_(solver), mesh_(problem.start) {
    RefineOptions options;
    if (problem.first_rounds > 0) {  // two rounds halve all edges
      options.max_edge =
          longest_edge_length(mesh_) * std::pow(0.5, static_cast<double>(problem.first_rounds) / 2);
    }
    refine_to(options);
    guess_.assign(mesh_.vertex_count(), 0.0);
  }

  const Mesh& mesh() const override { return mesh_; }

  Eigen::VectorXd solve(AdaptiveStep& step) override {
    const VoronoiBoxes boxes = voronoi_boxes(mesh_);
    const Certificate certificate = certify(mesh_, boxes);
    if (!certificate.admissible) {
      throw InputError(name_, certificate.summary(), "refine with nonobtuse boundaries");
    }
    const LinearSystem system = assemble_fv(mesh_, boxes, problem_);
    FirstGuess start = first_guess(mesh_, problem_, guess_);
    step.unknowns = start.unknowns;
    const Stopwatch watch;
    Eigen::VectorXd u = solver_ == LinearSolver::direct
                            ? demo::solve(mesh_, problem_, system).u
                            : by_multigrid(system, std::move(start), step.iterations);
    step.solve_seconds = watch.seconds();
    return u;
  }

  // Edges of the size of marked triangles are too long there by a factor of 1.4, as if each were
  // cut in two. Vertices stay as they are: what earlier marks have made fine is not asked for
  // again.
  bool refine(std::span<const TriangleId> marked, const Eigen::VectorXd& u) override {
    const double shortest = 4 * default_size_floor(mesh_);  // what refine() is sure to reach
    std::vector<SizeSource> sources;
    for (const TriangleId t : marked) {
      const auto x = mesh_.corners(t);
      const double size = diameter(mesh_, t) / std::sqrt(2.0);
      if (size >= shortest) sources.push_back({(1.0 / 3) * (x[0] + x[1] + x[2]), size});
    }
    if (sources.empty()) return false;
    RefineOptions options;
    options.size = SizeField(std::move(sources), 1);
    options.effort = Effort::fast;
    const Mesh before = mesh_;
    refine_to(options);
    guess_.assign(u.begin(), u.end());
    transfer_vertices(vertex_transfer(before, mesh_), guess_);
    return mesh_.vertex_count() > before.vertex_count();
  }

 private:
  void refine_to(const RefineOptions& options) {
    if (lepp::refine(mesh_, options).goal_reached) return;
    throw InputError(name_, "cannot be refined to 30 degrees and nonobtuse boundaries",
                     "ask for fewer unknowns");
  }

  Eigen::VectorXd by_multigrid(const LinearSystem& system, FirstGuess start,
                               std::size_t& iterations) {
    const RemeshMultigrid multigrid(system.K, start.free,
                                    history_.interpolations(mesh_, start.free),
                                    cross_point_modes(mesh_, problem_.diffusion, start.free));
    IterativeSolution solution = solve_or_refuse(system, start.free, multigrid, std::move(start.u));
    history_.add(mesh_, start.free);
    iterations = solution.iterations;
    return std::move(solution.u);
  }

  const PoissonProblem& problem_;
  std::string name_;
  LinearSolver solver_;
  Mesh mesh_;
  MeshHistory history_;
  std::vector<double> guess_;
};

}  // namespace

std::unique_ptr<AdaptiveScheme> boxes_by_delaunay(const AdaptiveProblem& problem,
                                                  LinearSolver solver) {
  return std::make_unique<BoxesByDelaunay>(problem, solver);
}

}  // namespace lepp::demo
