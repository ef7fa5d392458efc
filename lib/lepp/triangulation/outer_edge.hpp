#pragma once

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// What lies behind an edge, remembered while the triangle in front of it gets other corners.
class OuterEdge {
 public:
  OuterEdge(const Mesh& mesh, HalfEdge e)
      : across_(mesh.twin(e)), constrained_(mesh.is_constrained(e)) {}

  /// Puts `e` where the remembered edge was.
  void attach(Mesh& mesh, HalfEdge e) const {
    if (across_) mesh.link(e, *across_);
    else mesh.unlink(e);
    mesh.set_constrained_flag(e, constrained_);
  }

 private:
  std::optional<HalfEdge> across_;
  bool constrained_;
};

}  // namespace lepp
