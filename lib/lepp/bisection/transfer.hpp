#pragma once

#include <cassert>
#include <type_traits>
#include <utility>
#include <vector>

#include "lepp/bisection/forest.hpp"

namespace lepp {

// Values at the vertices or triangles of a forest's mesh follow it through bisect() and coarsen().
// Each function takes them as they were before the call that returned the log, one per vertex or
// triangle, and leaves one for each that there is now. They cost as much as the log is long.
// The same maps as sparse matrices: transfer_matrix.hpp. docs/algorithms/adaptive.md

/// P1: a new vertex gets the mean of the two that it lies between, in the order of the log. A
/// function that is linear on each old triangle is the same function on the new ones, but for
/// vertices that were moved to curves.
/// \tparam Value  adds, and is multiplied by a double: a number, a Point, a fixed-size vector
template <class Value>
void transfer_vertices(const Refinement& refinement, std::vector<Value>& values) {
  for (const auto& [v, a, b] : refinement.vertices) {
    assert(v.index() == values.size());
    values.push_back(0.5 * (values[a.index()] + values[b.index()]));
  }
}

/// The transpose of it, for what is integrated against hat functions (loads, residuals): half of
/// what a new vertex has goes to each of the two it lies between.
void restrict_loads(const Refinement& refinement, std::vector<double>& loads);

/// P1: the vertices that are left keep their values. Functions that are linear on the joined
/// triangles stay as they are.
template <class Value>
void transfer_vertices(const Coarsening& coarsening, std::vector<Value>& values) {
  for (const NewVertex& removed : coarsening.vertices) {
    values[removed.vertex.index()] = values.back();
    values.pop_back();
  }
}

/// P0: both halves have the value of the whole, whatever it is: a density, a tag, a set of marks.
template <class Value>
void transfer_triangles(const Refinement& refinement, std::vector<Value>& values) {
  for (const auto& [whole, other] : refinement.triangles) {
    assert(other.index() == values.size());
    values.push_back(Value(values[whole.index()]));
  }
}

/// P0: a joined triangle gets what the caller makes of its halves: the larger mark, the union of
/// two sets, a sum where values are amounts.
/// \param join  (value of the first half, of the second one) -> value of the whole
template <class Value, class Join>
requires std::is_invocable_r_v<Value, Join&, const Value&, const Value&>
void transfer_triangles(const Coarsening& coarsening, std::vector<Value>& values, Join join) {
  for (const auto& [whole, other] : coarsening.triangles) {
    values[whole.index()] =
        join(std::as_const(values)[whole.index()], std::as_const(values)[other.index()]);
    values[other.index()] = values.back();
    values.pop_back();
  }
}

/// P0: a joined triangle gets the mean of its halves, weighted by their areas, so that the integral
/// stays what it was. Areas follow as well: that of the whole is the sum.
/// \param densities  one per triangle before coarsen(); not amounts, which would simply be added
/// \param areas      likewise, all > 0
void transfer_triangles(const Coarsening& coarsening, std::vector<double>& densities,
                        std::vector<double>& areas);

/// The same where both halves have the same area, as they have unless curves are followed: up to
/// the rounding of their common vertex.
void transfer_triangles(const Coarsening& coarsening, std::vector<double>& densities);

}  // namespace lepp
