#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "lepp/bisection/common_parts.hpp"
#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/error.hpp"

namespace lepp {
namespace {

using Share = TriangleTransfer::Share;
using Keep = TriangleTransferOptions::Keep;

/// Above 0, as all are if computed exactly.
std::vector<double> areas_of(const Mesh& mesh) {
  constexpr double of_a_sliver = 1e-300;
  std::vector<double> areas;
  areas.reserve(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    areas.push_back(std::max(of_a_sliver, signed_area(a, b, c)));
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

/// Multiplies the weights of row t by factor(t).
template <class Factor>
void scale_rows(TriangleTransfer& table, Factor factor) {
  for (std::size_t t = 0; t + 1 < table.begins.size(); ++t) {
    const double scale = factor(t);
    for (std::size_t i = table.begins[t]; i < table.begins[t + 1]; ++i) {
      table.shares[i].weight *= scale;
    }
  }
}

/// Gives empty rows those of the nearest triangle that has one. Most often there are none.
void fill_rows(Overlaps& overlaps, const Mesh& after, bool by_region) {
  if (std::ranges::all_of(overlaps.covered, [](double area) { return area > 0; })) return;
  const std::vector<TriangleId> like = nearest_with(after, overlaps.covered, by_region);
  Overlaps full;
  full.table.triangles_before = overlaps.table.triangles_before;
  for (const TriangleId t : like) {
    full.table.begins.push_back(full.table.shares.size());
    const auto row = overlaps.table.of(t);
    full.table.shares.insert(full.table.shares.end(), row.begin(), row.end());
    full.covered.push_back(overlaps.covered[t.index()]);
  }
  full.table.begins.push_back(full.table.shares.size());
  overlaps = std::move(full);
}

/// Makes the weights, areas that add up to those of new triangles, add up to those of old ones too:
/// what an old triangle has is divided in proportion.
void divide_columns(TriangleTransfer& table, const std::vector<double>& taken,
                    const std::vector<double>& areas) {
  for (Share& share : table.shares) {
    share.weight *= areas[share.from.index()] / taken[share.from.index()];
  }
}

/// Adds, beside each share of an old triangle that others hand theirs to, those of the others.
void add_handed_on(TriangleTransfer& table, const std::vector<TriangleId>& to,
                   const std::vector<double>& areas) {
  std::vector<std::optional<TriangleId>> next(to.size());  // a chain from each that receives
  for (std::size_t t = to.size(); t-- > 0;) {
    if (to[t].index() == t) continue;
    next[t] = std::exchange(next[to[t].index()], TriangleId(t));
  }
  TriangleTransfer more;
  more.triangles_before = table.triangles_before;
  for (std::size_t t = 0; t + 1 < table.begins.size(); ++t) {
    more.begins.push_back(more.shares.size());
    for (const Share& share : table.of(TriangleId(t))) {
      more.shares.push_back(share);
      const double part = share.weight / areas[share.from.index()];
      for (auto other = next[share.from.index()]; other; other = next[other->index()]) {
        more.shares.push_back({*other, part * areas[other->index()]});
      }
    }
  }
  more.begins.push_back(more.shares.size());
  table = std::move(more);
}

void keep_integrals(TriangleTransfer& table, const Mesh& before, bool by_region) {
  const std::vector<double> areas = areas_of(before);
  std::vector<double> taken(areas.size(), 0.0);
  for (const auto& [from, area] : table.shares) taken[from.index()] += area;
  divide_columns(table, taken, areas);
  if (std::ranges::all_of(taken, [](double area) { return area > 0; })) return;
  add_handed_on(table, nearest_with(before, taken, by_region), areas);
}

}  // namespace

TriangleTransfer triangle_transfer(const Mesh& before, const Mesh& after,
                                   const TriangleTransferOptions& options) {
  const std::vector<double> areas = areas_of(after);
  Overlaps overlaps = overlaps_of(before, after, options.by_region);
  fill_rows(overlaps, after, options.by_region);
  TriangleTransfer& table = overlaps.table;
  scale_rows(table, [&](std::size_t t) { return areas[t] / overlaps.covered[t]; });
  if (options.keep == Keep::integrals) keep_integrals(table, before, options.by_region);
  scale_rows(table, [&](std::size_t t) { return 1 / areas[t]; });
  return std::move(table);
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
