#include "cross_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "lepp/geometry/place_on_segment.hpp"

namespace lepp::demo {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Diffusion by triangle.
struct Materials {
  const Mesh& mesh;
  std::span<const double> diffusion;

  double at(TriangleId t) const { return diffusion[mesh.region(t).index()]; }
  bool differ_across(HalfEdge e) const {
    const auto across = mesh.twin(e);
    return across && at(across->triangle) != at(e.triangle);
  }
};

/// How many edges between two materials leave each vertex.
std::vector<std::uint32_t> interface_degrees(const Materials& materials) {
  const Mesh& mesh = materials.mesh;
  std::vector<std::uint32_t> degree(mesh.vertex_count(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (materials.differ_across(e)) ++degree[mesh.origin(e).index()];
    }
  }
  return degree;
}

/// The sectors around a vertex inside the mesh; none if it is on the boundary.
std::vector<CrossPoint::Sector> sectors_around(const Materials& materials, VertexId v) {
  const Mesh& mesh = materials.mesh;
  std::vector<CrossPoint::Sector> sectors;
  const HalfEdge first = mesh.leaving(v);
  HalfEdge e = first;
  do {
    if (materials.differ_across(e)) {
      const Point along = mesh.point(mesh.destination(e)) - mesh.point(v);
      sectors.push_back({std::atan2(along.y, along.x), materials.at(e.triangle)});
    }
    const auto next = turn_counter_clockwise(mesh, e);
    if (!next) return {};
    e = *next;
  } while (e != first);
  const auto first_sector = std::ranges::min_element(sectors, {}, &CrossPoint::Sector::begin);
  std::rotate(sectors.begin(), first_sector, sectors.end());
  return sectors;
}

std::vector<std::size_t> peaks_of(const std::vector<CrossPoint::Sector>& sectors) {
  std::vector<std::size_t> peaks;
  const std::size_t n = sectors.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double here = sectors[i].diffusion;
    if (here > sectors[(i + 1) % n].diffusion && here > sectors[(i + n - 1) % n].diffusion) {
      peaks.push_back(i);
    }
  }
  return peaks;
}

double width(const CrossPoint& cross, std::size_t sector) {
  const auto& all = cross.sectors;
  if (sector + 1 < all.size()) return all[sector + 1].begin - all[sector].begin;
  return all.front().begin + full_turn - all[sector].begin;
}

/// Where a direction lies among the peaks: on the way from peak `from` to the next one, `part` of
/// the drop is behind it. In sectors of high diffusion the drop is slow, as in resistors in a row.
struct Between {
  std::size_t from = 0;
  double part = 0;
};

Between between_peaks(const CrossPoint& cross, double angle) {
  const auto& all = cross.sectors;
  if (angle < all.front().begin) angle += full_turn;
  std::size_t sector = all.size() - 1;
  while (all[sector].begin > angle) --sector;
  const auto turned = [&](std::size_t p) {  // how many sectors from peak p on
    return (sector + all.size() - cross.peaks[p]) % all.size();
  };
  std::size_t from = 0;
  for (std::size_t p = 1; p < cross.peaks.size(); ++p) {
    if (turned(p) < turned(from)) from = p;
  }
  if (cross.peaks[from] == sector) return {from, 0};
  double drop = 0, behind = 0;
  const std::size_t to = cross.peaks[(from + 1) % cross.peaks.size()];
  for (std::size_t s = (cross.peaks[from] + 1) % all.size(); s != to; s = (s + 1) % all.size()) {
    if (s == sector) behind = drop + (angle - all[s].begin) / all[s].diffusion;
    drop += width(cross, s) / all[s].diffusion;
  }
  return {from, behind / drop};
}

/// Function i < peaks - 1 is 1 on peak i + 1; less than 0 on the highest, so that the mean weighted
/// by D, which is about the value of the cross point, is 0; and 0 on the others.
double in_angle(const CrossPoint& cross, std::size_t i, const Between& place) {
  const auto on_peak = [&](std::size_t p) {
    if (p == i + 1) return 1.0;
    const auto& D = cross.sectors;
    return p == 0 ? -D[cross.peaks[i + 1]].diffusion / D[cross.peaks[0]].diffusion : 0.0;
  };
  const std::size_t to = (place.from + 1) % cross.peaks.size();
  return (1 - place.part) * on_peak(place.from) + place.part * on_peak(to);
}

/// The distance to the boundary and to other cross points.
double radius_of(const Mesh& mesh, const CrossPoint& cross, std::span<const CrossPoint> others) {
  const Point at = mesh.point(cross.vertex);
  double squared = std::numeric_limits<double>::infinity();
  for (const CrossPoint& other : others) {
    if (other.vertex != cross.vertex) {
      squared = std::min(squared, squared_distance(at, mesh.point(other.vertex)));
    }
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_boundary(e)) continue;
      const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
      squared = std::min(squared, nearest_place(a, b, at).squared_distance);
    }
  }
  return std::sqrt(squared);
}

double shortest_edge_at(const Mesh& mesh, VertexId v) {
  double squared = std::numeric_limits<double>::infinity();
  for_each_in_fan(mesh, v, [&](TriangleId t, std::uint32_t corner) {
    const Point end = mesh.point(mesh.vertex(t, next_corner(corner)));
    squared = std::min(squared, squared_distance(mesh.point(v), end));
  });
  return std::sqrt(squared);
}

using Entries = std::vector<Eigen::Triplet<double>>;

/// \return  how many columns were added, `column` being the first
int add_modes(const Mesh& mesh, const CrossPoint& cross, double radius, std::span<const char> free,
              int column, Entries& entries) {
  const Point at = mesh.point(cross.vertex);
  const double halvings = std::log2(radius / shortest_edge_at(mesh, cross.vertex));
  const auto rings = static_cast<int>(std::max(0.0, std::ceil(halvings)));
  const auto functions = static_cast<int>(cross.peaks.size()) - 1;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const Point off = mesh.points()[v] - at;
    const double squared = dot(off, off);
    if (free[v] == 0 || squared == 0 || squared >= radius * radius) continue;
    // Hats 1 to `rings`; that of the innermost ring stays 1 down to the cross point.
    const double ring =
        std::min(std::log2(radius) - 0.5 * std::log2(squared), static_cast<double>(rings));
    const double inner = std::floor(ring);
    const Between place = between_peaks(cross, std::atan2(off.y, off.x));
    for (int i = 0; i < functions; ++i) {
      const double value = in_angle(cross, static_cast<std::size_t>(i), place);
      const auto add = [&](double hat, double height) {
        if (hat < 1 || height * value == 0) return;
        const int k = column + (static_cast<int>(hat) - 1) * functions + i;
        entries.emplace_back(static_cast<int>(v), k, height * value);
      };
      add(inner, 1 - (ring - inner));
      add(inner + 1, ring - inner);
    }
  }
  return rings * functions;
}

}  // namespace

std::vector<CrossPoint> cross_points(const Mesh& mesh, std::span<const double> diffusion) {
  const Materials materials{mesh, diffusion};
  const std::vector<std::uint32_t> degree = interface_degrees(materials);
  std::vector<CrossPoint> found;
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] < 4) continue;
    CrossPoint cross{VertexId(v), sectors_around(materials, VertexId(v)), {}};
    cross.peaks = peaks_of(cross.sectors);
    const auto height = [&](std::size_t p) { return cross.sectors[p].diffusion; };
    std::rotate(cross.peaks.begin(), std::ranges::max_element(cross.peaks, {}, height),
                cross.peaks.end());
    if (cross.peaks.size() >= 2) found.push_back(std::move(cross));
  }
  return found;
}

SparseMatrix cross_point_modes(const Mesh& mesh, std::span<const double> diffusion,
                               std::span<const char> free) {
  const std::vector<CrossPoint> crosses = cross_points(mesh, diffusion);
  Entries entries;
  int columns = 0;
  for (const CrossPoint& cross : crosses) {
    columns += add_modes(mesh, cross, radius_of(mesh, cross, crosses), free, columns, entries);
  }
  SparseMatrix modes(static_cast<Eigen::Index>(mesh.vertex_count()), columns);
  modes.setFromTriplets(entries.begin(), entries.end());
  return modes;
}

}  // namespace lepp::demo
