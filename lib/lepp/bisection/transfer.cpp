#include "lepp/bisection/transfer.hpp"

namespace lepp {

namespace {

void replace_by_last(std::vector<double>& values, TriangleId removed) {
  values[removed.index()] = values.back();
  values.pop_back();
}

}  // namespace

void restrict_loads(const Refinement& refinement, std::vector<double>& loads) {
  for (std::size_t i = refinement.vertices.size(); i-- > 0;) {
    const auto& [v, a, b] = refinement.vertices[i];
    assert(v.index() + 1 == loads.size());
    const double half = 0.5 * loads.back();
    loads.pop_back();
    loads[a.index()] += half;
    loads[b.index()] += half;
  }
}

void transfer_triangles(const Coarsening& coarsening, std::vector<double>& densities,
                        std::vector<double>& areas) {
  assert(densities.size() == areas.size());
  for (const auto& [whole, other] : coarsening.triangles) {
    const std::size_t t = whole.index(), u = other.index();
    const double amount = areas[t] * densities[t] + areas[u] * densities[u];
    areas[t] += areas[u];
    densities[t] = amount / areas[t];
    replace_by_last(densities, other);
    replace_by_last(areas, other);
  }
}

void transfer_triangles(const Coarsening& coarsening, std::vector<double>& densities) {
  for (const auto& [whole, other] : coarsening.triangles) {
    densities[whole.index()] = 0.5 * (densities[whole.index()] + densities[other.index()]);
    replace_by_last(densities, other);
  }
}

}  // namespace lepp
