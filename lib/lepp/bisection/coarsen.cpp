#include <array>
#include <utility>

#include "lepp/bisection/forest.hpp"
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
  using Node = Forest::Node;

  bool can_be_whole(std::uint32_t parent) const;
  bool is_newest_corner(TriangleId t, std::uint32_t corner) const;
  TriangleId first_half(std::uint32_t n) const { return TriangleId(node(node(n).children).leaf); }
  TriangleId second_half(std::uint32_t n) const {
    return TriangleId(node(node(n).children + 1).leaf);
  }
  void remove_vertex(std::uint32_t parent);
  std::uint32_t join(std::uint32_t parent);
  void remove_triangle(TriangleId t);

  Node& node(std::uint32_t n) { return forest_.nodes_[n]; }
  const Node& node(std::uint32_t n) const { return forest_.nodes_[n]; }
  std::uint32_t node_of(TriangleId t) const { return forest_.node_[t.index()]; }
  State state(TriangleId t) const { return forest_.state_[t.index()]; }

  Forest& forest_;
  Mesh& mesh_;
  Coarsening result_;
};

// Nodes keep their numbers while triangles move.
Coarsening Coarsener::run(std::span<const TriangleId> marked) {
  std::vector<std::uint32_t> nodes, parents;
  for (const TriangleId t : marked) {
    if (state(t) == State::listed) continue;
    forest_.state_[t.index()] = State::listed;
    nodes.push_back(node_of(t));
    if (node(node_of(t)).parent != Forest::none) parents.push_back(node(node_of(t)).parent);
  }
  for (const std::uint32_t parent : parents) {
    if (can_be_whole(parent)) remove_vertex(parent);
  }
  for (const std::uint32_t n : nodes) {
    if (node(n).leaf != Forest::none) forest_.state_[node(n).leaf] = State::idle;
  }
  return std::move(result_);
}

bool Coarsener::can_be_whole(std::uint32_t parent) const {
  const std::uint32_t children = node(parent).children;
  if (children == Forest::none || node(children).leaf == Forest::none) return false;
  const VertexId v = mesh_.vertex(first_half(parent), previous_corner(node(parent).cut));
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
  const std::uint32_t parent = node(node_of(t)).parent;
  if (parent == Forest::none) return false;
  const bool is_first = node(parent).children == node_of(t);
  const std::uint32_t cut = node(parent).cut;
  return corner == (is_first ? previous_corner(cut) : next_corner(cut));
}

void Coarsener::remove_vertex(std::uint32_t parent) {
  const std::uint32_t cut = node(parent).cut;
  const HalfEdge a_to_v{first_half(parent), cut}, v_to_b{second_half(parent), cut};
  const VertexId a = mesh_.origin(a_to_v), v = mesh_.destination(a_to_v),
                 b = mesh_.destination(v_to_b);
  const bool constrained = mesh_.is_constrained(a_to_v);
  const auto across = mesh_.twin(a_to_v);
  std::array<std::uint32_t, 2> parents{parent, Forest::none};
  if (across) parents[1] = node(node_of(across->triangle)).parent;
  const std::span joined(parents.begin(), across ? 2 : 1);
  std::array<std::uint32_t, 2> halves{};  // nodes of what is left over
  for (std::size_t i = 0; i < joined.size(); ++i) halves[i] = join(joined[i]);
  const HalfEdge e{TriangleId(node(parent).leaf), cut};
  if (across) mesh_.link(e, {TriangleId(node(parents[1]).leaf), node(parents[1]).cut});
  else mesh_.unlink(e);
  if (constrained) mesh_.join_records(a, v, b);

  // The larger id first, so that neither moves into the place of the other.
  if (across && node(halves[0]).leaf < node(halves[1]).leaf) {
    std::swap(parents[0], parents[1]);
    std::swap(halves[0], halves[1]);
  }
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const TriangleId other(node(halves[i]).leaf);
    result_.triangles.push_back({TriangleId(node(joined[i]).leaf), other});
    node(halves[i]) = {};
    remove_triangle(other);
  }
  result_.vertices.push_back({v, a, b});
  mesh_.remove_vertex(v);
}

// Makes the first half the whole triangle. The second one stays behind, with nothing linked to it,
// and the second child with it.
std::uint32_t Coarsener::join(std::uint32_t parent) {
  const TriangleId t = first_half(parent), u = second_half(parent);
  const std::uint32_t cut = node(parent).cut, to_c = next_corner(cut),
                      from_c = previous_corner(cut);
  const VertexId b = mesh_.vertex(u, previous_corner(cut)), c = mesh_.vertex(t, cut);
  auto corners = mesh_.vertices(t);
  corners[previous_corner(cut)] = b;
  mesh_.replace_vertices(t, corners[0], corners[1], corners[2]);
  mesh_.take_place_of({t, to_c}, {u, to_c});
  mesh_.move_leaving(b, {u, to_c}, {t, to_c});
  mesh_.move_leaving(c, {u, from_c}, {t, from_c});

  const std::uint32_t children = node(parent).children;
  node(parent).children = Forest::none;
  node(parent).leaf = t.value;
  node(children) = {};
  forest_.free_nodes_.push_back(children);
  forest_.node_[t.index()] = parent;
  forest_.cut_[t.index()] = static_cast<std::uint8_t>(cut);
  forest_.state_[t.index()] = State::idle;  // once a call
  return children + 1;
}

void Coarsener::remove_triangle(TriangleId t) {
  mesh_.remove_triangle(t);
  const auto move_last = [&](auto& items) {
    items[t.index()] = items.back();
    items.pop_back();
  };
  move_last(forest_.node_);
  move_last(forest_.cut_);
  move_last(forest_.state_);
  move_last(forest_.half_);
  if (t.index() < forest_.node_.size()) node(node_of(t)).leaf = t.value;
}

Coarsening Forest::coarsen(std::span<const TriangleId> marked) {
  return Coarsener(*this).run(marked);
}

}  // namespace lepp
