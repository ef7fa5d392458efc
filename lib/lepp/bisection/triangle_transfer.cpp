#include <algorithm>
#include <optional>
#include <string>

#include "lepp/bisection/common_parts.hpp"
#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/error.hpp"

namespace lepp {
namespace {

using Share = TriangleTransfer::Share;
using Keep = TriangleTransferOptions::Keep;

std::vector<double> areas_of(const Mesh& mesh) {
  std::vector<double> areas;
  areas.reserve(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    areas.push_back(signed_area(a, b, c));
  }
  return areas;
}

/// Shares whose weights are areas, and what they add up to in each row.
struct Overlaps {
  TriangleTransfer table;
  std::vector<double> covered;
};

Overlaps overlaps_of(const Mesh& before, const Mesh& after, bool by_region) {
  Overlaps found;
  found.table.triangles_before = before.triangle_count();
  found.table.begins.reserve(after.triangle_count() + 1);
  found.table.shares.reserve(4 * after.triangle_count() + 2 * before.triangle_count());
  found.covered.reserve(after.triangle_count());
  CommonParts parts(before, after);
  for (std::size_t i = 0; i < after.triangle_count(); ++i) {
    const TriangleId t(i);
    found.table.begins.push_back(found.table.shares.size());
    double sum = 0;
    parts.for_each(t, [&](TriangleId old, const CommonPart&, double area) {
      if (by_region && before.region(old) != after.region(t)) return;
      found.table.shares.push_back({old, area});
      sum += area;
    });
    found.covered.push_back(sum);
  }
  found.table.begins.push_back(found.table.shares.size());
  return found;
}

[[noreturn]] void throw_without_counterpart(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  const Point p = (1.0 / 3) * (a + b + c);
  throw InputError("the triangle around (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")",
                   "has no counterpart of its region in the other mesh",
                   "transfer between meshes of one domain with the same regions, or set by_region "
                   "to false");
}

/// For each triangle one that has something: itself, or the nearest one of its region, counted in
/// triangles.
std::vector<TriangleId> nearest_with(const Mesh& mesh, const std::vector<double>& amounts,
                                     bool by_region) {
  std::vector<TriangleId> nearest, queue;
  std::vector<char> known(amounts.size());
  nearest.reserve(amounts.size());
  for (std::size_t t = 0; t < amounts.size(); ++t) {
    nearest.emplace_back(t);
    known[t] = amounts[t] > 0 ? 1 : 0;
  }
  const auto tell_neighbours = [&](TriangleId t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto across = mesh.twin({t, i});
      if (!across || known[across->triangle.index()] != 0) continue;
      if (by_region && mesh.region(across->triangle) != mesh.region(t)) continue;
      known[across->triangle.index()] = 1;
      nearest[across->triangle.index()] = nearest[t.index()];
      queue.push_back(across->triangle);
    }
  };
  for (std::size_t t = 0; t < amounts.size(); ++t) {
    if (amounts[t] > 0) tell_neighbours(TriangleId(t));
  }
  for (std::size_t i = 0; i < queue.size(); ++i) tell_neighbours(TriangleId(queue[i]));
  const auto lost = std::ranges::find(known, 0);
  if (lost != known.end()) {
    throw_without_counterpart(mesh, TriangleId(static_cast<std::size_t>(lost - known.begin())));
  }
  return nearest;
}

/// Rows that add up to the area of the new triangle: means over what is covered.
void complete_rows(Overlaps& overlaps, const Mesh& after, const std::vector<double>& areas,
                   bool by_region) {
  const std::vector<TriangleId> like = nearest_with(after, overlaps.covered, by_region);
  TriangleTransfer full;
  full.triangles_before = overlaps.table.triangles_before;
  full.begins.reserve(areas.size() + 1);
  full.shares.reserve(overlaps.table.shares.size());
  for (std::size_t t = 0; t < areas.size(); ++t) {
    full.begins.push_back(full.shares.size());
    const double scale = areas[t] / overlaps.covered[like[t].index()];
    for (const auto& [from, area] : overlaps.table.of(like[t])) {
      full.shares.push_back({from, scale * area});
    }
  }
  full.begins.push_back(full.shares.size());
  overlaps.table = std::move(full);
}

/// What each old triangle hands on, in all, is its area, and that of those that hand theirs to it.
class HandedOn {
 public:
  HandedOn(const Mesh& before, const TriangleTransfer& table, bool by_region)
      : areas_(areas_of(before)), taken_(areas_.size(), 0.0), next_giver_(areas_.size()) {
    for (const auto& [from, area] : table.shares) taken_[from.index()] += area;
    const std::vector<TriangleId> to = nearest_with(before, taken_, by_region);
    for (std::size_t t = areas_.size(); t-- > 0;) {
      if (to[t].index() == t) continue;
      auto& chain = next_giver_[to[t].index()];
      next_giver_[t] = chain;
      chain = TriangleId(t);
    }
  }

  /// Calls visit(triangle, amount per unit of density) for a part of what `from` hands on.
  template <class Visit>
  void for_each(TriangleId from, double area, Visit visit) const {
    const double part = area / taken_[from.index()];
    visit(from, part * areas_[from.index()]);
    for (auto t = next_giver_[from.index()]; t; t = next_giver_[t->index()]) {
      visit(*t, part * areas_[t->index()]);
    }
  }

 private:
  std::vector<double> areas_, taken_;
  std::vector<std::optional<TriangleId>> next_giver_;  // a chain from each that receives
};

}  // namespace

TriangleTransfer triangle_transfer(const Mesh& before, const Mesh& after,
                                   const TriangleTransferOptions& options) {
  const std::vector<double> areas = areas_of(after);
  Overlaps overlaps = overlaps_of(before, after, options.by_region);
  complete_rows(overlaps, after, areas, options.by_region);
  TriangleTransfer& table = overlaps.table;
  if (options.keep == Keep::values) {
    for (std::size_t t = 0; t < areas.size(); ++t) {
      for (std::size_t i = table.begins[t]; i < table.begins[t + 1]; ++i) {
        table.shares[i].weight /= areas[t];
      }
    }
    return std::move(table);
  }
  const HandedOn handed_on(before, table, options.by_region);
  TriangleTransfer transfer;
  transfer.triangles_before = table.triangles_before;
  transfer.begins.reserve(table.begins.size());
  transfer.shares.reserve(table.shares.size());
  for (std::size_t t = 0; t < areas.size(); ++t) {
    transfer.begins.push_back(transfer.shares.size());
    for (const auto& [from, area] : table.of(TriangleId(t))) {
      handed_on.for_each(from, area, [&](TriangleId old, double amount) {
        transfer.shares.push_back({old, amount / areas[t]});
      });
    }
  }
  transfer.begins.push_back(transfer.shares.size());
  return transfer;
}

void transfer_triangles(const TriangleTransfer& transfer, std::vector<double>& densities) {
  std::vector<double> found;
  found.reserve(transfer.begins.size() - 1);
  for (std::size_t t = 0; t + 1 < transfer.begins.size(); ++t) {
    double sum = 0;
    for (const auto& [from, weight] : transfer.of(TriangleId(t))) {
      sum += weight * densities[from.index()];
    }
    found.push_back(sum);
  }
  densities.swap(found);
}

}  // namespace lepp
