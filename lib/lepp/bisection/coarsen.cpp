#include <array>
#include <utility>

#include "lepp/bisection/forest.hpp"
#include "lepp/bisection/make_room_for.hpp"
#include "lepp/triangulation/mesh_fan.hpp"

namespace lepp {

// A vertex goes when all triangles around it are marked and were made when it was: two on the
// boundary, else four. It is found from each marked triangle, where it is the newest corner.
class Coarsener {
 public:
  explicit Coarsener(Forest& forest) : forest_(forest), mesh_(forest.mesh_) {}

  Coarsening run(std::span<const TriangleId> marked);

 private:
  using State = Forest::State;

  bool can_be_whole(std::uint32_t parent) const;
  bool is_newest_corner(TriangleId t, std::uint32_t corner) const;
  // \pre  `parent` is cut and its halves are not
  TriangleId half(std::uint32_t parent, std::uint32_t h) const {
    return TriangleId(forest_.link(2 * forest_.link(parent) + h));
  }
  void remove_vertex(std::uint32_t parent);
  std::uint32_t join(std::uint32_t parent);
  void remove_triangle(TriangleId t);

  std::uint32_t node_of(TriangleId t) const { return forest_.leaves_[t.index()].node; }
  std::uint32_t parent_of(TriangleId t) const { return forest_.parent(node_of(t)); }
  State& state(TriangleId t) { return forest_.leaves_[t.index()].state; }
  State state(TriangleId t) const { return forest_.leaves_[t.index()].state; }

  Forest& forest_;
  Mesh& mesh_;
  Coarsening result_;
};

// Nodes keep their numbers while triangles move. All that may fail comes before the first change.
Coarsening Coarsener::run(std::span<const TriangleId> marked) {
  std::vector<std::uint32_t> nodes, parents;
  nodes.reserve(marked.size());
  parents.reserve(marked.size());
  result_.vertices.reserve(marked.size() / 2);  // each has two marked triangles
  result_.triangles.reserve(marked.size());
  make_room_for(forest_.free_pairs_, marked.size());
  mesh_.make_room_for_records(0);
  for (const TriangleId t : marked) {
    if (state(t) == State::listed) continue;
    state(t) = State::listed;
    nodes.push_back(node_of(t));
    if (parent_of(t) != Forest::none) parents.push_back(parent_of(t));
  }
  for (const std::uint32_t parent : parents) {
    if (can_be_whole(parent)) remove_vertex(parent);
  }
  for (const std::uint32_t n : nodes) {
    if (forest_.link(n) != Forest::none) state(TriangleId(forest_.link(n))) = State::idle;
  }
  return std::move(result_);
}

bool Coarsener::can_be_whole(std::uint32_t parent) const {
  if (forest_.is_leaf(parent) || !forest_.is_leaf(2 * forest_.link(parent))) return false;
  const VertexId v = mesh_.vertex(half(parent, 0), previous_corner(forest_.cut(parent)));
  std::size_t around = 0;
  bool all = true;
  for_each_in_fan(mesh_, v, [&](TriangleId t, std::uint32_t corner) {
    ++around;
    all = around <= 4 && state(t) == State::listed && is_newest_corner(t, corner);
    return all;
  });
  return all;
}

bool Coarsener::is_newest_corner(TriangleId t, std::uint32_t corner) const {
  const std::uint32_t parent = parent_of(t);
  if (parent == Forest::none) return false;
  const std::uint32_t cut = forest_.cut(parent);
  return corner == (Forest::is_first(node_of(t)) ? previous_corner(cut) : next_corner(cut));
}

void Coarsener::remove_vertex(std::uint32_t parent) {
  const std::uint32_t cut = forest_.cut(parent);
  const HalfEdge a_to_v{half(parent, 0), cut}, v_to_b{half(parent, 1), cut};
  const VertexId a = mesh_.origin(a_to_v), v = mesh_.destination(a_to_v),
                 b = mesh_.destination(v_to_b);
  const bool constrained = mesh_.is_constrained(a_to_v);
  const auto across = mesh_.twin(a_to_v);
  std::array<std::uint32_t, 2> parents{parent, Forest::none}, cuts{cut, 0};
  if (across) {
    parents[1] = parent_of(across->triangle);
    cuts[1] = forest_.cut(parents[1]);
  }
  const std::span joined(parents.begin(), across ? 2 : 1);
  std::array<std::uint32_t, 2> halves{};  // nodes of what is left over
  for (std::size_t i = 0; i < joined.size(); ++i) halves[i] = join(joined[i]);
  const HalfEdge e{TriangleId(forest_.link(parent)), cut};
  if (across) mesh_.link(e, {TriangleId(forest_.link(parents[1])), cuts[1]});
  else mesh_.unlink(e);
  if (constrained) mesh_.join_records(a, v, b);

  // The larger id first, so that neither moves into the place of the other.
  if (across && forest_.link(halves[0]) < forest_.link(halves[1])) {
    std::swap(parents[0], parents[1]);
    std::swap(halves[0], halves[1]);
  }
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const TriangleId other(forest_.link(halves[i]));
    result_.triangles.push_back({TriangleId(forest_.link(joined[i])), other});
    forest_.link(halves[i]) = Forest::none;
    remove_triangle(other);
  }
  result_.vertices.push_back({v, a, b});
  mesh_.remove_vertex(v);
}

// Makes the first half the whole triangle. The second one stays behind, with nothing linked to it,
// and the second node of the pair with it.
std::uint32_t Coarsener::join(std::uint32_t parent) {
  const TriangleId t = half(parent, 0), u = half(parent, 1);
  const std::uint32_t cut = forest_.cut(parent), to_c = next_corner(cut),
                      from_c = previous_corner(cut);
  const VertexId b = mesh_.vertex(u, previous_corner(cut)), c = mesh_.vertex(t, cut);
  auto corners = mesh_.vertices(t);
  corners[previous_corner(cut)] = b;
  mesh_.replace_vertices(t, corners[0], corners[1], corners[2]);
  mesh_.take_place_of({t, to_c}, {u, to_c});
  mesh_.move_leaving(b, {u, to_c}, {t, to_c});
  mesh_.move_leaving(c, {u, from_c}, {t, from_c});

  const std::uint32_t pair = forest_.link(parent);
  forest_.link(parent) = t.value;
  forest_.cut(parent) = Forest::uncut;
  forest_.link(2 * pair) = Forest::none;
  forest_.free_pairs_.push_back(pair);
  forest_.leaves_[t.index()] = {parent, Forest::none, static_cast<std::uint8_t>(cut),
                                State::idle};  // once a call
  return 2 * pair + 1;
}

void Coarsener::remove_triangle(TriangleId t) {
  mesh_.remove_triangle(t);
  auto& leaves = forest_.leaves_;
  leaves[t.index()] = leaves.back();
  leaves.pop_back();
  if (t.index() < leaves.size()) forest_.link(node_of(t)) = t.value;
}

Coarsening Forest::coarsen(std::span<const TriangleId> marked) {
  return Coarsener(*this).run(marked);
}

}  // namespace lepp
