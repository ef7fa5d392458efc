#include <algorithm>
#include <cmath>

#include "lepp/bisection/common_parts.hpp"
#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/linear_function.hpp"

namespace lepp {
namespace {

std::array<double, 3> at_corners(const Mesh& mesh, TriangleId t,
                                 const std::vector<double>& values) {
  const auto& [a, b, c] = mesh.vertices(t);
  return {values[a.index()], values[b.index()], values[c.index()]};
}

/// Calls visit(place, weight): together a rule for integrals over the part that is exact for degree
/// 2. Places are relative to the first corner of the new triangle.
template <class Visit>
void for_each_place(const CommonPart& part, Visit visit) {
  const Point a = part.corner(0);
  for (std::uint32_t i = 2; i < part.size(); ++i) {
    const Point b = part.corner(i - 1), c = part.corner(i);
    const double third = cross(b - a, c - a) / 6;
    visit(0.5 * (a + b), third);
    visit(0.5 * (b + c), third);
    visit(0.5 * (c + a), third);
  }
}

/// Integrals over what the meshes have in common of (u - w) times each hat function of the new one.
std::vector<double> loads_of(const Mesh& before, const Mesh& after, const std::vector<double>& u,
                             const std::vector<double>& w) {
  std::vector<double> loads(after.vertex_count(), 0.0);
  CommonParts parts(before, after);
  for (std::size_t i = 0; i < after.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto x = after.corners(t);
    const std::array<Point, 3> here{Point{0, 0}, x[1] - x[0], x[2] - x[0]};
    // of a sliver not finite, and then not asked: it has no part in common with others
    const LinearFunction now(here, at_corners(after, t, w));
    const LinearFunction second(here, {0, 1, 0}), third(here, {0, 0, 1});
    std::array<double, 3> sums{};
    parts.for_each(t, [&](TriangleId old, const CommonPart& part, double) {
      const auto y = before.corners(old);
      const LinearFunction was({y[0] - x[0], y[1] - x[0], y[2] - x[0]}, at_corners(before, old, u));
      for_each_place(part, [&](Point p, double weight) {
        const double off = weight * (was(p) - now(p)), b = second(p), c = third(p);
        sums[0] += off * (1 - b - c);
        sums[1] += off * b;
        sums[2] += off * c;
      });
    });
    for (std::uint32_t k = 0; k < 3; ++k) loads[after.vertex(t, k).index()] += sums[k];
  }
  return loads;
}

/// Integrals of products of hat functions, triangle by triangle.
class MassMatrix {
 public:
  explicit MassMatrix(const Mesh& mesh) : mesh_(mesh), diagonal_(mesh.vertex_count(), 0.0) {
    twelfths_.reserve(mesh.triangle_count());
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      twelfths_.push_back(std::max(0.0, signed_area(a, b, c)) / 12);  // of slivers
      for (const VertexId v : mesh.vertices(TriangleId(t))) {
        diagonal_[v.index()] += 2 * twelfths_.back();
      }
    }
  }

  const std::vector<double>& diagonal() const { return diagonal_; }

  void multiply(const std::vector<double>& x, std::vector<double>& y) const {
    y.assign(x.size(), 0.0);
    for (std::size_t t = 0; t < twelfths_.size(); ++t) {
      const auto& [a, b, c] = mesh_.vertices(TriangleId(t));
      const double u = x[a.index()], v = x[b.index()], w = x[c.index()], sum = u + v + w;
      y[a.index()] += twelfths_[t] * (u + sum);
      y[b.index()] += twelfths_[t] * (v + sum);
      y[c.index()] += twelfths_[t] * (w + sum);
    }
  }

 private:
  const Mesh& mesh_;
  std::vector<double> twelfths_;  // of the areas
  std::vector<double> diagonal_;
};

double product(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

/// Adds M^-1 r to x by conjugate gradients. Divided by its diagonal, M has its eigenvalues between
/// 1/2 and 2 on any mesh, so that each iteration takes at least two thirds of the error away.
void add_solution(const MassMatrix& M, std::vector<double> r, std::vector<double>& x) {
  constexpr int most_iterations = 60;
  constexpr double reduction = 1e-15;
  const auto divided = [&](const std::vector<double>& y) {
    std::vector<double> z(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {  // nothing is added where there is no area
      z[i] = M.diagonal()[i] > 0 ? y[i] / M.diagonal()[i] : 0;
    }
    return z;
  };
  std::vector<double> p = divided(r), q;
  double squared = product(r, p);
  const double goal = reduction * reduction * squared;
  for (int i = 0; i < most_iterations && squared > goal; ++i) {
    M.multiply(p, q);
    const double step = squared / product(p, q);
    for (std::size_t k = 0; k < x.size(); ++k) {
      x[k] += step * p[k];
      r[k] -= step * q[k];
    }
    const std::vector<double> z = divided(r);
    const double next = product(r, z);
    for (std::size_t k = 0; k < x.size(); ++k) p[k] = z[k] + next / squared * p[k];
    squared = next;
  }
}

}  // namespace

void project_vertices(const Mesh& before, const Mesh& after, const VertexTransfer& transfer,
                      std::vector<double>& values) {
  std::vector<double> found = values;
  transfer_vertices(transfer, found);
  add_solution(MassMatrix(after), loads_of(before, after, values, found), found);
  values.swap(found);
}

}  // namespace lepp
