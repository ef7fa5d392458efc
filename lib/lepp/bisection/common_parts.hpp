#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/bisection/common_part.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/locator.hpp"

namespace lepp {

/// Finds the pairs of an old and a new triangle that overlap. From the old triangle that contains
/// the middle of a new one, it goes on across the edges that the new one crosses. Where boundaries
/// have moved, a new triangle can meet the old mesh in separate parts; then some may be missed.
class CommonParts {
 public:
  /// \pre  M1 to M3. The meshes stay as they are while this is in use
  CommonParts(const Mesh& before, const Mesh& after);

  /// Calls visit(old, part, area) for each old triangle that has more than a trillionth of its
  /// area, or of the new one's, in common with `t`; `part` is the new triangle cut by the old one.
  /// Triangles so thin that their computed area is not above 0 have nothing in common with others.
  template <class Visit>
  void for_each(TriangleId t, Visit visit);

 private:
  void start_at(TriangleId t);
  void reach(TriangleId old);

  const Mesh& before_;
  const Mesh& after_;
  std::vector<std::optional<Location>> middles_;
  std::optional<Locator> locator_;         // where a middle is outside
  std::vector<std::uint32_t> reached_by_;  // by old triangle: the last new one, + 1
  std::vector<TriangleId> queue_;
  std::uint32_t current_ = 0;
};

template <class Visit>
void CommonParts::for_each(TriangleId t, Visit visit) {
  constexpr double least_part = 1e-12;
  const auto corners = after_.corners(t);
  const double whole = signed_area(corners[0], corners[1], corners[2]);
  start_at(t);
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const TriangleId old = queue_[i];
    const auto x = before_.corners(old);
    const CommonPart part(corners, x);
    const double area = part.area();
    for (std::uint32_t edge = 0; edge < 3; ++edge) {
      if (!part.goes_on_across(edge)) continue;
      if (const auto across = before_.twin({old, edge})) reach(across->triangle);
    }
    const double smaller = std::min(whole, signed_area(x[0], x[1], x[2]));
    if (smaller > 0 && area > least_part * smaller) visit(old, part, area);
  }
}

}  // namespace lepp
