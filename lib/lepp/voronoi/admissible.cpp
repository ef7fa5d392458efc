#include "lepp/voronoi/admissible.hpp"

#include <algorithm>

#include "lepp/geometry/text.hpp"
#include "lepp/voronoi/box_checks.hpp"
#include "lepp/voronoi/box_cutter.hpp"
#include "lepp/voronoi/corners_by_box.hpp"
#include "lepp/voronoi/names.hpp"

namespace lepp {

namespace {

// Their boxes and pieces stay in the cache between cutting and checking.
constexpr std::size_t vertices_at_a_time = 512;

void check_edge_factors(const Mesh& mesh, Certificate& result) {  // V1
  result.offending = negative_edge_factors(mesh);
  for (const EdgeFactor& f : result.offending) {
    result.violations.push_back(
        {"V1", "edge " + to_text(mesh.point(f.k)) + " - " + to_text(mesh.point(f.l)) + " in " +
                   name_of(mesh, f.region) + ": factor " + to_text(f.factor) +
                   ", opposite angles " + to_text(f.angle_deg) + " degrees"});
  }
}

void start_anew(VoronoiBoxes& boxes) {
  boxes.boxes.clear();
  boxes.corners.clear();
  boxes.piece_triangle.clear();
  boxes.piece_begin.assign(1, 0);
}

}  // namespace

std::string name_of(const Mesh& mesh, SurfaceId region) {
  const auto& surfaces = mesh.entities().surfaces;
  if (region.index() >= surfaces.size()) return "region " + std::to_string(region.value);
  return "surface " + std::to_string(surfaces[region.index()].tag);
}

std::string name_of(const Mesh& mesh, VertexId v) {
  if (v.index() >= mesh.vertex_count()) return "no vertex " + std::to_string(v.value);
  return "vertex " + to_text(mesh.point(v));
}

Certificate certify(const Mesh& mesh, const VoronoiBoxes& boxes) {
  Certificate result;
  check_edge_factors(mesh, result);
  BoxChecks checks(mesh);
  checks.add(boxes);
  checks.report(result);
  result.admissible = result.violations.empty();
  return result;
}

Certificate certify(const Mesh& mesh) {
  Certificate result;
  check_edge_factors(mesh, result);
  if (!result.violations.empty()) return result;
  const CornersByBox corners(mesh);
  BoxCutter cutter(mesh, corners, BoxCutter::Faces::leave_out);
  BoxChecks checks(mesh);
  VoronoiBoxes some;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (v % vertices_at_a_time == 0) {
      checks.add(some);
      start_anew(some);
    }
    cutter.cut(VertexId(v), some);
  }
  checks.add(some);
  checks.report(result);
  result.admissible = result.violations.empty();
  return result;
}

std::string Certificate::summary() const {
  if (admissible) return "admissible";
  constexpr std::size_t shown = 3;
  std::string text = "not admissible";
  for (std::size_t i = 0; i < std::min(shown, violations.size()); ++i) {
    text += (i == 0 ? ": " : "; ") + violations[i].rule + " " + violations[i].where;
  }
  if (violations.size() > shown) {
    text += "; and " + std::to_string(violations.size() - shown) + " more";
  }
  return text;
}

}  // namespace lepp
