#include <algorithm>
#include <cmath>

#include "adaptive_scheme.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "poisson_fv.hpp"
#include "stopwatch.hpp"

namespace lepp::demo {
namespace {

double longest_edge_length(const std::array<Point, 3>& x) {
  return std::sqrt(std::max(
      {squared_distance(x[0], x[1]), squared_distance(x[1], x[2]), squared_distance(x[2], x[0])}));
}

class BoxesByDelaunay : public AdaptiveScheme {
 public:
  explicit BoxesByDelaunay(const AdaptiveProblem& problem)
      : problem_(problem.problem), name_(problem.title), mesh_(problem.start) {
    RefineOptions options;
    if (problem.first_rounds > 0) {  // two rounds halve all edges
      options.max_edge = 2 * std::pow(0.5, static_cast<double>(problem.first_rounds) / 2);
    }
    refine_to(options);
  }

  const Mesh& mesh() const override { return mesh_; }

  Eigen::VectorXd solve(AdaptiveStep& step) override {
    const VoronoiBoxes boxes = voronoi_boxes(mesh_);
    const Certificate certificate = certify(mesh_, boxes);
    if (!certificate.admissible) {
      throw InputError(name_, certificate.summary(), "refine with nonobtuse boundaries");
    }
    const LinearSystem system = assemble_fv(mesh_, boxes, problem_);
    const Stopwatch watch;
    Solution solution = demo::solve(mesh_, problem_, system);
    step.solve_seconds = watch.seconds();
    step.unknowns = solution.unknowns;
    return std::move(solution.u);
  }

  // Edges of the size of marked triangles are too long there by a factor of 1.4, as if each were
  // cut in two. Vertices stay as they are: what earlier marks have made fine is not asked for
  // again.
  bool refine(std::span<const TriangleId> marked, const Eigen::VectorXd&) override {
    std::vector<SizeSource> sources;
    for (const TriangleId t : marked) {
      const auto x = mesh_.corners(t);
      sources.push_back(
          {(1.0 / 3) * (x[0] + x[1] + x[2]), longest_edge_length(x) / std::sqrt(2.0)});
    }
    RefineOptions options;
    options.size = SizeField(std::move(sources), 1);
    options.effort = Effort::fast;
    const std::size_t before = mesh_.vertex_count();
    refine_to(options);
    return mesh_.vertex_count() > before;
  }

 private:
  void refine_to(const RefineOptions& options) {
    if (lepp::refine(mesh_, options).goal_reached) return;
    throw InputError(name_, "cannot be refined to 30 degrees and nonobtuse boundaries",
                     "ask for fewer unknowns");
  }

  const PoissonProblem& problem_;
  std::string name_;
  Mesh mesh_;
};

}  // namespace

std::unique_ptr<AdaptiveScheme> boxes_by_delaunay(const AdaptiveProblem& problem) {
  return std::make_unique<BoxesByDelaunay>(problem);
}

}  // namespace lepp::demo
