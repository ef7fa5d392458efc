#pragma once

#include <array>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// How bad a triangle is; nothing if it needs no work. Larger is worse.
using Badness = std::function<std::optional<double>(const Mesh&, TriangleId)>;

/// The triangles still to be worked on, worst first, equals in order of their ids. Entries are
/// dropped when their triangle has changed by the time they come up.
class BadTriangles {
 public:
  explicit BadTriangles(Badness badness) : badness_(std::move(badness)) {}

  /// Queues `t` if it is bad.
  void add(const Mesh& mesh, TriangleId t);
  /// Takes out the worst triangle that is still there.
  std::optional<TriangleId> worst(const Mesh& mesh);

 private:
  struct Entry {
    double badness;
    TriangleId triangle;
    std::array<VertexId, 3> vertices;
    bool operator<(const Entry& other) const {
      return badness != other.badness ? badness < other.badness : other.triangle < triangle;
    }
  };
  Badness badness_;
  std::priority_queue<Entry> queue_;
};

}  // namespace lepp
