#pragma once

#include <cstdint>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/feasible_place.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_test.hpp"
#include "lepp/triangulation/cavity.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Puts vertices where every triangle around them is good: no angle below the bound, not too large,
/// no constrained edge encroached. The flips that follow only raise the smallest angle.
class GoodStar {
 public:
  GoodStar(Mesh& mesh, const RefineOptions& options, double floor);

  /// Moves corner `corner` of `t`, an interior Steiner point, if there is a good place for it in
  /// its star and it has not been moved too often. \return whether it was moved
  /// \param changed  triangles that may be bad afterwards are appended: flips made them
  bool move_corner(TriangleId t, std::uint32_t corner, std::vector<TriangleId>& changed);

  /// Moves it to `p` if that is a good place in its star, however often it has been moved.
  bool move_corner_to(TriangleId t, std::uint32_t corner, Point p,
                      std::vector<TriangleId>& changed);

  /// Inserts a vertex where the star that replaces `cavity` is good, if there is such a place.
  /// \param changed  triangles that may be bad afterwards are appended: flips made them
  /// \pre cavity.find() returned true for `p`, nothing changed since
  bool insert(Cavity& cavity, Point p, std::vector<TriangleId>& changed);

  /// Starts to look for a neighbour that corner `corner` of `t` can be merged with.
  /// \return false if it is no interior Steiner point with a small star
  bool start_to_merge(TriangleId t, std::uint32_t corner) {
    return is_interior_star(t, corner, whole_);
  }
  std::size_t degree() const { return whole_.size(); }
  VertexId neighbour(std::size_t i) const { return mesh_.origin(whole_.link[i].edge); }
  /// The place of one vertex that can stand for both it and neighbour(i), with all triangles around
  /// it good. \return nothing if there is none, or the neighbour is no interior Steiner point
  /// \pre start_to_merge() returned true, nothing changed since
  std::optional<Point> place_for_both(std::size_t i);

 private:
  bool is_interior_star(TriangleId t, std::uint32_t corner, Star& star) const;
  bool is_good(Point p) const;
  bool has_good_triangles(Point p) const;  // they are counter-clockwise
  bool encroaches_link(Point p) const;
  bool encroaches_beyond_link(Point p);

  Mesh& mesh_;
  double floor_;
  bool encroaching_allowed_;
  AngleTest angle_;
  SizeTest size_;
  std::size_t most_triangles_;
  FeasiblePlace place_;
  Star star_;
  Star whole_, part_;  // of a vertex that is to be merged, and of its neighbour
  std::vector<HalfEdge> stack_;
  std::vector<std::uint8_t> moves_;  // by vertex
};

}  // namespace lepp
