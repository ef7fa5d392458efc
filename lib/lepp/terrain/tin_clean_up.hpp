#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/feasible_place.hpp"
#include "lepp/terrain/free_stars.hpp"
#include "lepp/terrain/star_filling.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Takes vertices out of a TIN where both bounds still hold without them. The mesh stays
/// constrained Delaunay; no angle comes below the bound, and no error above it, but for corners on
/// a circle, where the diagonal that remove_vertex() takes can be another than was asked about.
class TinCleanUp {
 public:
  /// \param frozen  vertices with a lower id stay
  /// \param go_on   asked at each vertex; false ends the round
  TinCleanUp(TerrainMesh& terrain, double min_angle_deg, double error, std::size_t frozen,
             std::function<bool()> go_on);

  /// Removes each vertex that can be done without, the last one first.
  /// \return how many are gone
  std::size_t remove_needless();

  /// Puts one vertex in the place of two neighbours, where it can stand for both.
  /// \return how many are gone
  std::size_t merge();

 private:
  bool can_do_without(VertexId v);
  bool collect_link(VertexId v);
  bool is_side_encroached() const;
  bool is_filling_within_bounds(VertexId v) const;
  Removal remove(VertexId v);
  void note_changes(const std::vector<TriangleId>& changed);

  bool merge_with_neighbour(VertexId v);
  bool join_stars(std::size_t i);
  std::optional<Point> place_for_both(Point near);
  bool has_good_angles(Point p) const;
  bool is_star_within_bounds(Point p);
  bool is_center_within_bounds(Point p) const;
  void replace_both(VertexId v, VertexId w, Point p);

  TerrainMesh& terrain_;
  const Mesh& mesh_;
  AngleTest angle_;
  double error_;
  std::size_t frozen_;
  std::function<bool()> go_on_;
  bool any_sharp_;  // then encroached sides are cut again
  StarFilling filling_;
  std::array<TerrainCorner, 2> suspects_;  // the vertices that are to go
  FeasiblePlace place_;
  Star whole_, part_, star_;  // of a vertex, of its neighbour, and of one for both
  // By vertex: tried in vain, to remove it and to merge it; nothing has changed around it since.
  std::vector<std::uint8_t> needed_, single_;
  std::vector<TriangleId> changed_;
};

}  // namespace lepp
