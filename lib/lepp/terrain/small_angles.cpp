#include "lepp/terrain/small_angles.hpp"

#include <algorithm>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"

namespace lepp {

bool is_improvable(const Mesh& mesh, TriangleId t, double floor) {
  return !smallest_angle_between_constrained(mesh, t) && !shortest_edge_is_seditious(mesh, t) &&
         !at_input_feature(mesh, t, 2 * floor);
}

std::vector<Unfinished> small_angles(const Mesh& mesh, double min_angle_deg, const LoopEnd& end,
                                     const AtKeptBorder& at_kept_border) {
  const Reason otherwise = end.cancelled ? Reason::cancelled
                           : end.used_up ? Reason::budget
                                         : Reason::size_floor;
  RefineOptions asked;
  asked.min_angle_deg = min_angle_deg;
  asked.obtuse = ObtuseRule::ignore;
  std::vector<Unfinished> unfinished = judge(mesh, asked, otherwise).unfinished;
  for (auto& [triangle, reason] : unfinished) {
    if (!is_forced_by_input(reason) && at_kept_border.contains(mesh, triangle)) {
      reason = Reason::kept_border;
    }
  }
  return unfinished;
}

bool is_excused(Reason reason) {
  return is_forced_by_input(reason) || reason == Reason::kept_border;
}

bool are_excused(std::span<const Unfinished> unfinished) {
  return std::ranges::all_of(unfinished, is_excused, &Unfinished::reason);
}

}  // namespace lepp
