#include "support/trial.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/split_crossings.hpp"
#include "support/invariants.hpp"
#include "support/mesh_edges.hpp"
#include "support/oracle.hpp"
#include "support/plain/constrained_delaunay.hpp"

namespace lepp::test {

namespace {

// Nominally on one line: the hull is at most a few ulp wide.
bool is_flat(const Arrangement& arrangement) {
  if (arrangement.collinear) return true;
  const std::vector<std::uint32_t> hull = arrangement.hull();
  const auto at = [&](std::size_t i) { return arrangement.points[hull[i % hull.size()]]; };
  double area = 0, diameter = 0, largest = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point p = at(i) - at(0), q = at(i + 1) - at(0);
    area += 0.5 * cross(p, q);
    diameter = std::max(diameter, std::sqrt(dot(p, p)));
    largest = std::max({largest, std::abs(at(i).x), std::abs(at(i).y)});
  }
  return area <= 0x1p-46 * largest * diameter;
}

bool lies_on_piece(const Arrangement& arrangement, Point p) {
  return std::any_of(arrangement.pieces.begin(), arrangement.pieces.end(), [&](const auto& piece) {
    const Point a = arrangement.points[piece.first], b = arrangement.points[piece.second];
    return oracle_orient2d(a, b, p) == 0 && oracle_dot_sign(a, p, b) <= 0;
  });
}

// The plain kernel only warns of it.
bool has_seeds_in_one_area(const Pslg& pslg) {
  if (pslg.seeds.size() < 2) return false;
  try {
    const auto warnings = plain::constrained_delaunay(pslg).report.warnings;
    return std::ranges::any_of(warnings, [](const std::string& warning) {
      return warning.find("in the same area") != std::string::npos;
    });
  } catch (const InputError&) {
    return false;
  }
}

// Whatever its crossings.
bool may_be_refused(const Pslg& pslg, const Arrangement& arrangement) {
  const auto on_piece = [&](Point p) { return lies_on_piece(arrangement, p); };
  return is_flat(arrangement) ||
         (!pslg.holes.empty() &&
          pslg.holes.size() >= std::max<std::size_t>(arrangement.closed_faces(), 1)) ||
         std::any_of(pslg.holes.begin(), pslg.holes.end(), on_piece) ||
         std::any_of(pslg.seeds.begin(), pslg.seeds.end(),
                     [&](const RegionSeed& s) { return on_piece(s.at); }) ||
         has_seeds_in_one_area(pslg);
}

// What an InputError means, once the oracle has looked for a reason. Rounded crossings can be on a
// hole, and pieces can close off what the segments do not: so the pieces are what counts.
void judge(const InputError& error, const Pslg& pslg, const Arrangement& arrangement,
           Crossings crossings, Trial& trial) {
  const bool crosses = !arrangement.crossings.empty();
  const auto without_reason = std::string("refused without a reason: ") + error.what();
  if (!crosses) {
    if (!may_be_refused(pslg, arrangement)) trial.failure = without_reason;
  } else if (crossings == Crossings::split) {
    trial.refused_split = true;
    try {
      const Pslg split = split_crossings(pslg).pslg;
      if (!may_be_refused(split, arrange(split))) trial.failure = without_reason;
    } catch (const InputError& too_close) {
      trial.failure = std::string("crossings could not be split: ") + too_close.what();
    }
  }
}

}  // namespace

Trial try_pslg(const Pslg& pslg, const Arrangement& arrangement, Crossings crossings) {
  Trial trial;
  const bool crosses = !arrangement.crossings.empty();
  try {
    trial.result = constrained_delaunay(pslg, {.crossings = crossings});
    trial.failure = crosses && crossings == Crossings::refuse
                        ? "segments cross, and it was not seen"
                        : broken_invariant(*trial.result, pslg, arrangement, crossings);
  } catch (const InputError& error) {
    judge(error, pslg, arrangement, crossings, trial);
  } catch (const std::exception& error) {
    trial.failure = std::string("an exception that is no InputError: ") + error.what();
  }
  return trial;
}

bool is_unique(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto across = mesh.twin({TriangleId(t), i});
      if (!across || mesh.is_constrained({TriangleId(t), i})) continue;
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      if (oracle_incircle(a, b, c, mesh.point(mesh.apex(*across))) == 0) return false;
    }
  }
  return true;
}

std::optional<std::string> difference_from_plain(const Triangulation& result, const Pslg& pslg) {
  const Mesh& mesh = result.mesh;
  const Mesh plain = plain::constrained_delaunay(pslg).mesh;
  if (!std::ranges::equal(mesh.points(), plain.points())) return "other vertices than plain";
  if (mesh.triangle_count() != plain.triangle_count()) return "other count than plain";
  if (!is_unique(mesh)) return std::nullopt;
  const SortedEdges ours(mesh), theirs(plain);
  const bool same = std::equal(
      ours.entries().begin(), ours.entries().end(), theirs.entries().begin(),
      theirs.entries().end(), [&](const SortedEdges::Entry& a, const SortedEdges::Entry& b) {
        return a.key == b.key && mesh.is_constrained(a.edge) == plain.is_constrained(b.edge) &&
               mesh.region(a.edge.triangle) == plain.region(b.edge.triangle);
      });
  if (!same) return "other edges or regions than plain";
  return std::nullopt;
}

bool are_same(const Mesh& a, const Mesh& b) {
  if (!std::ranges::equal(a.points(), b.points())) return false;
  if (a.triangle_count() != b.triangle_count()) return false;
  for (std::size_t t = 0; t < a.triangle_count(); ++t) {
    const TriangleId id(t);
    if (a.vertices(id) != b.vertices(id) || a.region(id) != b.region(id)) return false;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (a.is_constrained({id, i}) != b.is_constrained({id, i})) return false;
    }
  }
  return true;
}

}  // namespace lepp::test
