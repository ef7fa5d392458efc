#pragma once

#include <array>
#include <compare>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// How bad a triangle is: sizes come before shapes, and a larger amount is worse.
struct Badness {
  bool too_large = false;
  double amount = 0;
  friend auto operator<=>(const Badness&, const Badness&) = default;
};

/// Judges a triangle; nothing if it needs no work.
using Judge = std::function<std::optional<Badness>(const Mesh&, TriangleId)>;

/// The triangles still to be worked on, worst first, equals in order of their ids. Entries are
/// dropped when their triangle has changed by the time they come up.
class BadTriangles {
 public:
  explicit BadTriangles(Judge judge) : judge_(std::move(judge)) {}

  /// Queues `t` if it is bad.
  void add(const Mesh& mesh, TriangleId t);
  /// Takes out the worst triangle that is still there.
  std::optional<TriangleId> worst(const Mesh& mesh);

 private:
  struct Entry {
    Badness badness;
    TriangleId triangle;
    std::array<VertexId, 3> vertices;
    bool operator<(const Entry& other) const {
      return badness != other.badness ? badness < other.badness : other.triangle < triangle;
    }
  };
  Judge judge_;
  std::priority_queue<Entry> queue_;
};

}  // namespace lepp
