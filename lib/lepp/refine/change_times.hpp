#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// When the star of each vertex changed last, and when something was last tried there in vain: it
/// need not be tried again before a change.
class ChangeTimes {
 public:
  explicit ChangeTimes(const Mesh& mesh) : mesh_(mesh), times_(mesh.vertex_count()) {}

  bool is_due(VertexId v) const { return times_[v.index()].changed > times_[v.index()].tried; }
  /// True if something was tried at `w` after the last change at both of them.
  bool was_tried_beside(VertexId v, VertexId w) const {
    const std::uint32_t tried = times_[w.index()].tried;
    return tried > times_[w.index()].changed && tried > times_[v.index()].changed;
  }
  void tried(VertexId v) { times_[v.index()].tried = ++now_; }

  /// The corners or coordinates of these triangles are new.
  void changed(std::span<const TriangleId> triangles) {
    ++now_;
    for (const TriangleId t : triangles) {
      for (const VertexId v : mesh_.vertices(t)) times_[v.index()].changed = now_;
    }
  }
  /// A vertex was added at the end; the last one took the place of one that was removed.
  void added() { times_.emplace_back(); }
  void removed(VertexId v) {
    times_[v.index()] = times_.back();
    times_.pop_back();
  }

 private:
  struct Times {
    std::uint32_t changed = 1, tried = 0;
  };
  const Mesh& mesh_;
  std::vector<Times> times_;
  std::uint32_t now_ = 1;
};

}  // namespace lepp
