#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// True if `v` may be moved or removed: it is on no line, and its id is not below `frozen`.
inline bool is_free(const Mesh& mesh, VertexId v, std::size_t frozen) {
  return v.index() >= frozen && mesh.origin_of(v).kind == VertexOrigin::Kind::interior;
}

/// The stars whose center may still move. One move may undo another, so that only a limit on those
/// of each vertex makes an end certain; few get near it.
class FreeStars {
 public:
  /// A fuller star hardly ever has a place with all angles good, or does without its center.
  static constexpr std::size_t most_triangles = 12;

  /// All vertices that `mesh` has now are frozen.
  explicit FreeStars(const Mesh& mesh) : mesh_(mesh), frozen_(mesh.vertex_count()) {}

  /// Vertices that exist now stay where they are from now on.
  void freeze() { frozen_ = mesh_.vertex_count(); }
  std::size_t frozen() const { return frozen_; }

  /// Makes `star` the star of corner `corner` of `t`.
  /// \return false if that vertex may not move, or not again, or its star is too full
  bool find(TriangleId t, std::uint32_t corner, Star& star);
  void note_move(VertexId v) { ++moves_[v.index()]; }  ///< \pre find() found its star
  void forget_moves() { moves_.clear(); }

 private:
  const Mesh& mesh_;
  std::size_t frozen_;
  std::vector<std::uint8_t> moves_;  // by vertex
};

}  // namespace lepp
