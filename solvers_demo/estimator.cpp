#include "estimator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "lepp/geometry/linear_function.hpp"
#include "lepp/geometry/triangle_measures.hpp"

namespace lepp::demo {
namespace {

double area_of(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return signed_area(a, b, c);
}

/// h_T^2 / D times the integral of f^2, by three points inside.
double interior_part(const Mesh& mesh, TriangleId t, const Field& f, double D) {
  if (!f) return 0;
  constexpr double near = 2.0 / 3, far = 1.0 / 6;
  const auto x = mesh.corners(t);
  double mean = 0, squared_h = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Point b = x[next_corner(i)], c = x[previous_corner(i)];
    mean += std::pow(f(near * x[i] + far * b + far * c), 2) / 3;
    squared_h = std::max(squared_h, squared_distance(b, c));
  }
  return squared_h / D * signed_area(x[0], x[1], x[2]) * mean;
}

/// What flows out of the triangle across its edge: the integral of -D du/dn.
double outflow(const Mesh& mesh, HalfEdge e, Point gradient, double D) {
  const Point along = mesh.point(mesh.destination(e)) - mesh.point(mesh.origin(e));
  return D * cross(along, gradient);
}

/// Gradients averaged at the vertices, in each region for itself.
class Recovered {
 public:
  Recovered(const Mesh& mesh, const std::vector<Point>& gradient)
      : first_(mesh.vertex_count(), none) {
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
      const TriangleId t(i);
      const double area = area_of(mesh, t);
      for (const VertexId v : mesh.vertices(t)) {
        Patch& patch = patch_of(v, mesh.region(t));
        patch.area += area;
        patch.sum = patch.sum + area * gradient[i];
      }
    }
  }

  Point at(VertexId v, SurfaceId region) {
    const Patch& patch = patch_of(v, region);
    return (1 / patch.area) * patch.sum;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  struct Patch {
    SurfaceId region;
    std::uint32_t next = none;  // of the same vertex
    double area = 0;
    Point sum = {};
  };

  Patch& patch_of(VertexId v, SurfaceId region) {
    std::uint32_t i = first_[v.index()];
    while (i != none && patches_[i].region != region) i = patches_[i].next;
    if (i == none) {
      i = static_cast<std::uint32_t>(patches_.size());
      patches_.push_back({region, first_[v.index()]});
      first_[v.index()] = i;
    }
    return patches_[i];
  }

  std::vector<std::uint32_t> first_;
  std::vector<Patch> patches_;
};

}  // namespace

std::vector<Point> gradients(const Mesh& mesh, const Eigen::VectorXd& u) {
  std::vector<Point> found;
  found.reserve(mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto value = [&](std::uint32_t corner) { return u[mesh.vertex(t, corner).value]; };
    found.push_back(LinearFunction(mesh.corners(t), {value(0), value(1), value(2)}).gradient());
  }
  return found;
}

std::vector<double> residual_indicators(const Mesh& mesh, const PoissonProblem& problem,
                                        const Eigen::VectorXd& u) {
  const std::vector<Point> gradient = gradients(mesh, u);
  const auto D = [&](TriangleId t) { return problem.diffusion[mesh.region(t).index()]; };
  std::vector<double> indicators(mesh.triangle_count());
  for (std::size_t i = 0; i < indicators.size(); ++i) {
    const TriangleId t(i);
    double sum = interior_part(mesh, t, problem.source[mesh.region(t).index()], D(t));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{t, k};
      const auto across = mesh.twin(e);
      if (!across) continue;
      const TriangleId other = across->triangle;
      // |e| |[D du/dn]|^2_e = (|e| [D du/dn])^2, constant along e
      const double jump = outflow(mesh, e, gradient[i], D(t)) +
                          outflow(mesh, *across, gradient[other.index()], D(other));
      sum += jump * jump / (2 * std::max(D(t), D(other)));
    }
    indicators[i] = sum;
  }
  return indicators;
}

std::vector<double> zz_indicators(const Mesh& mesh, const PoissonProblem& problem,
                                  const Eigen::VectorXd& u) {
  const std::vector<Point> gradient = gradients(mesh, u);
  Recovered recovered(mesh, gradient);
  std::vector<double> indicators(mesh.triangle_count());
  for (std::size_t i = 0; i < indicators.size(); ++i) {
    const TriangleId t(i);
    Point sum;
    double squares = 0;  // the integral of |d|^2, d linear: |T|/12 (|d1 + d2 + d3|^2 + sum |di|^2)
    for (const VertexId v : mesh.vertices(t)) {
      const Point d = recovered.at(v, mesh.region(t)) - gradient[i];
      sum = sum + d;
      squares += dot(d, d);
    }
    indicators[i] = problem.diffusion[mesh.region(t).index()] * area_of(mesh, t) / 12 *
                    (dot(sum, sum) + squares);
  }
  return indicators;
}

std::vector<TriangleId> largest_indicators(std::span<const double> indicators, double theta) {
  std::vector<TriangleId> order;
  order.reserve(indicators.size());
  for (std::size_t t = 0; t < indicators.size(); ++t) order.emplace_back(t);
  if (theta >= 1) return order;
  std::ranges::sort(order, [&](TriangleId s, TriangleId t) {
    const double of_s = indicators[s.index()], of_t = indicators[t.index()];
    return of_s != of_t ? of_s > of_t : s < t;
  });
  const double goal = theta * std::accumulate(indicators.begin(), indicators.end(), 0.0);
  double sum = 0;
  std::size_t marked = 0;
  while (marked < order.size() && sum < goal) sum += indicators[order[marked++].index()];
  order.resize(marked);
  return order;
}

}  // namespace lepp::demo
