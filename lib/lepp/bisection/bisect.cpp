#include <algorithm>
#include <array>

#include "lepp/bisection/forest.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/two_threads.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

constexpr std::size_t at_once = 32768, too_few_for_threads = 4096;

// Calls work(begin, end) for both halves of [0, count).
template <class Work>
void in_halves(unsigned threads, std::size_t count, const Work& work) {
  if (count < too_few_for_threads) threads = 1;
  const std::size_t half = threads < 2 ? count : count / 2;
  in_parallel(
      threads, [&] { work(std::size_t{0}, half); }, [&] { work(half, count); });
}

}  // namespace

// Lists have triangles that must be cut, and are worked on some thousand at a time. A triangle
// whose edge is the edge of its neighbour as well, or on the boundary, is cut with that neighbour:
// such edges belong to different triangles, so all of them can be cut at the same time. Any other
// one waits for its neighbour, which joins the next list; when that has been cut, it wakes those
// that waited for it. So each path is followed once, and each of its triangles comes up as often as
// the triangle across its edge changes.
class Bisector {
 public:
  Bisector(Forest& forest, const BisectOptions& options)
      : forest_(forest), mesh_(forest.mesh_), options_(options) {}

  Refinement run(std::span<const TriangleId> marked);

 private:
  using State = Forest::State;
  enum class Action : std::uint8_t { leave, cut, wait, refuse };  // leave: to the neighbour's item
  // A triangle that must be cut and, if it is its turn, where and what comes of it.
  struct Item {
    HalfEdge e, across;
    Point middle;
    double parameter = 0;
    VertexId vertex;
    std::uint32_t half_of_t = 0, half_of_u = 0;          // ids of the second halves
    std::uint32_t children_of_t = 0, children_of_u = 0;  // nodes
    bool has_across = false, constrained = false;
    Action action = Action::leave;
  };

  void judge(Item& item) const;
  bool is_wanted(TriangleId t) const;
  bool place_middle(Item& item) const;
  bool fits(const Item& item) const;
  void give_ids();
  void cut(const Item& item);
  void cut_side(HalfEdge e, VertexId v, std::uint32_t second, std::optional<HalfEdge> beside_a,
                std::optional<HalfEdge> beside_b);
  std::optional<HalfEdge> now_across(HalfEdge e) const;
  void grow_tree(HalfEdge e, std::uint32_t second, std::uint32_t children);
  std::uint32_t new_children();
  void split_record(const Item& item);
  void work_on(std::span<const TriangleId> list);
  void list_more();
  void wake(HalfEdge e, std::uint32_t second);
  void refuse(TriangleId t);
  void finish();
  void list(TriangleId t);

  State& state(TriangleId t) { return forest_.state_[t.index()]; }
  State state(TriangleId t) const { return forest_.state_[t.index()]; }
  std::uint8_t cut_edge(TriangleId t) const { return forest_.cut_[t.index()]; }
  std::uint32_t& half(TriangleId t) { return forest_.half_[t.index()]; }
  std::uint32_t half(TriangleId t) const { return forest_.half_[t.index()]; }

  Forest& forest_;
  Mesh& mesh_;
  const BisectOptions& options_;
  Refinement result_;
  std::vector<TriangleId> list_, next_, waited_;
  std::vector<Item> items_;
  std::vector<std::uint32_t> cuts_;  // the items to be cut
};

Refinement Bisector::run(std::span<const TriangleId> marked) {
  for (const TriangleId t : marked) list(t);
  while (!next_.empty()) {  // ends: keys grow along a path, and each cut fulfils a wish
    list_.swap(next_);
    next_.clear();
    for (std::size_t i = 0; i < list_.size(); i += at_once) {
      work_on(std::span(list_).subspan(i, std::min(at_once, list_.size() - i)));
    }
  }
  finish();
  return std::move(result_);
}

void Bisector::work_on(std::span<const TriangleId> list) {
  items_.clear();
  for (const TriangleId t : list) {
    if (state(t) != State::listed) continue;  // cut with a neighbour since, or refused with it
    state(t) = State::taken;                  // a half with this id may be listed once more
    items_.push_back({});
    items_.back().e = {t, cut_edge(t)};
  }
  in_halves(options_.threads, items_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) judge(items_[i]);
  });
  give_ids();
  in_halves(options_.threads, cuts_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) cut(items_[cuts_[i]]);
  });
  in_halves(options_.threads, cuts_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Item& item = items_[cuts_[i]];
      grow_tree(item.e, item.half_of_t, item.children_of_t);
      if (item.has_across) grow_tree(item.across, item.half_of_u, item.children_of_u);
    }
  });
  list_more();
}

void Bisector::list(TriangleId t) {
  if (is_wanted(t) || state(t) == State::refused) return;
  state(t) = State::listed;
  next_.push_back(t);
}

bool Bisector::is_wanted(TriangleId t) const {
  return state(t) == State::listed || state(t) == State::taken;
}

void Bisector::judge(Item& item) const {
  const TriangleId t = item.e.triangle;
  const auto across = mesh_.twin(item.e);
  item.has_across = across.has_value();
  if (across) item.across = *across;
  item.constrained = mesh_.is_constrained(item.e);
  if (across && cut_edge(across->triangle) != across->edge) {
    item.action = Action::wait;
  } else if (across && is_wanted(across->triangle) && across->triangle < t) {
    item.action = Action::leave;
  } else {
    item.action = place_middle(item) ? Action::cut : Action::refuse;
  }
}

bool Bisector::place_middle(Item& item) const {
  const Point a = mesh_.point(mesh_.origin(item.e)), b = mesh_.point(mesh_.destination(item.e));
  const Point chord = in_supported_range(midpoint(a, b));
  if (item.constrained) {
    const ConstrainedPiece piece = piece_from(mesh_, item.e, mesh_.origin(item.e));
    if (options_.follow_curves && piece.curve != nullptr) {
      const CurvePoint on_curve = halfway(*piece.curve, piece.piece);
      item.middle = in_supported_range(on_curve.point);
      item.parameter = on_curve.t;
      if (fits(item)) return true;
    }
    item.parameter = 0.5 * (piece.piece.t_a + piece.piece.t_b);
  }
  item.middle = chord;
  return fits(item);
}

bool Bisector::fits(const Item& item) const { return can_split_edge(mesh_, item.e, item.middle); }

// Ids follow the order of the list, however many threads look at it.
void Bisector::give_ids() {
  cuts_.clear();
  const std::size_t vertices = mesh_.vertex_count(), triangles = mesh_.triangle_count();
  auto next_triangle = static_cast<std::uint32_t>(triangles);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    if (item.action != Action::cut) continue;
    item.vertex = VertexId(vertices + cuts_.size());
    cuts_.push_back(static_cast<std::uint32_t>(i));
    half(item.e.triangle) = item.half_of_t = next_triangle++;
    item.children_of_t = new_children();
    const VertexId a = mesh_.origin(item.e), b = mesh_.destination(item.e);
    result_.vertices.push_back({item.vertex, a, b});
    result_.triangles.push_back({item.e.triangle, TriangleId(item.half_of_t)});
    if (!item.has_across) continue;
    half(item.across.triangle) = item.half_of_u = next_triangle++;
    item.children_of_u = new_children();
    result_.triangles.push_back({item.across.triangle, TriangleId(item.half_of_u)});
  }
  mesh_.grow(cuts_.size(), next_triangle - triangles);
  forest_.node_.resize(next_triangle);
  forest_.cut_.resize(next_triangle);
  forest_.state_.resize(next_triangle, State::idle);
  forest_.half_.resize(next_triangle, Forest::none);
}

std::uint32_t Bisector::new_children() {
  auto& free = forest_.free_nodes_;
  if (free.empty()) {
    const std::size_t children = forest_.nodes_.size();
    forest_.nodes_.resize(children + 2);
    return static_cast<std::uint32_t>(children);
  }
  const std::uint32_t children = free.back();
  free.pop_back();
  return children;
}

// What lies across `e` once all of the round is cut.
std::optional<HalfEdge> Bisector::now_across(HalfEdge e) const {
  const auto across = mesh_.twin(e);
  if (!across || half(across->triangle) == Forest::none) return across;
  const bool moves = across->edge == next_corner(cut_edge(across->triangle));
  return moves ? HalfEdge{TriangleId(half(across->triangle)), across->edge} : across;
}

// Writes the triangles of the item, what is across their edges if that is not cut, and the points
// that these triangles alone know: others of the round do not.
void Bisector::cut(const Item& item) {
  const VertexId v = item.vertex;
  const TriangleId t_half(item.half_of_t), u_half(item.half_of_u);
  const HalfEdge e = item.e, f = item.across;
  VertexOrigin origin{VertexOrigin::Kind::interior, 0};
  if (item.constrained) origin = origin_on(mesh_, e);
  mesh_.set_vertex(v, item.middle, origin);
  if (item.has_across) {
    cut_side(e, v, item.half_of_t, HalfEdge{u_half, f.edge}, f);
    cut_side(f, v, item.half_of_u, HalfEdge{t_half, e.edge}, e);
  } else {
    cut_side(e, v, item.half_of_t, std::nullopt, std::nullopt);
  }
  mesh_.set_leaving(v, {t_half, e.edge});
}

// `e` runs from a to b; beyond its halves lie `beside_a` and `beside_b`.
void Bisector::cut_side(HalfEdge e, VertexId v, std::uint32_t second,
                        std::optional<HalfEdge> beside_a, std::optional<HalfEdge> beside_b) {
  const TriangleId t = e.triangle, u(second);
  const HalfEdge to_c = next_edge(e), from_c = previous_edge(e);
  const auto before = mesh_.twin(to_c), across_to_c = now_across(to_c);
  auto corners = mesh_.vertices(t), of_second = corners;
  const VertexId b = corners[previous_corner(e.edge)];
  of_second[next_corner(e.edge)] = v;
  corners[previous_corner(e.edge)] = v;

  mesh_.set_triangle(u, of_second, mesh_.region(t));
  mesh_.set_across({u, e.edge}, beside_b);
  mesh_.set_across({u, to_c.edge}, across_to_c);
  mesh_.set_across({u, from_c.edge}, to_c);
  mesh_.set_constrained_flag({u, e.edge}, mesh_.is_constrained(e));
  mesh_.set_constrained_flag({u, to_c.edge}, mesh_.is_constrained(to_c));
  if (before && half(before->triangle) == Forest::none) {  // else it sees to that itself
    mesh_.set_across(*before, HalfEdge{u, to_c.edge});
  }

  mesh_.set_across(from_c, now_across(from_c));
  mesh_.replace_vertices(t, corners[0], corners[1], corners[2]);
  mesh_.set_across(e, beside_a);
  mesh_.set_across(to_c, HalfEdge{u, from_c.edge});
  mesh_.set_constrained_flag(to_c, false);
  mesh_.move_leaving(b, to_c, {u, to_c.edge});
}

void Bisector::grow_tree(HalfEdge e, std::uint32_t second, std::uint32_t children) {
  const TriangleId t = e.triangle, u(second);
  std::uint32_t edge = previous_corner(e.edge), edge_of_second = next_corner(e.edge);
  if (forest_.rule_ == BisectionRule::longest_edge) {
    edge = longest_edge(mesh_, t).edge;
    edge_of_second = longest_edge(mesh_, u).edge;
  }
  forest_.cut_[t.index()] = static_cast<std::uint8_t>(edge);
  forest_.cut_[u.index()] = static_cast<std::uint8_t>(edge_of_second);

  const std::uint32_t parent = forest_.node_[t.index()];
  Forest::Node& node = forest_.nodes_[parent];
  const auto generation = static_cast<std::uint16_t>(node.generation + 1);
  node.children = children;
  node.leaf = Forest::none;
  node.cut = static_cast<std::uint8_t>(e.edge);
  forest_.nodes_[children] = {parent, Forest::none, t.value, generation, 0};
  forest_.nodes_[children + 1] = {parent, Forest::none, second, generation, 0};
  forest_.node_[t.index()] = children;
  forest_.node_[u.index()] = children + 1;
  state(t) = State::idle;
}

void Bisector::split_record(const Item& item) {
  const VertexId a = mesh_.origin(item.e), v = item.vertex;
  const VertexId b = mesh_.destination({TriangleId(item.half_of_t), item.e.edge});
  mesh_.split_record(a, b, v, item.parameter);
}

// Those that others wait for, and those whose wait is over.
void Bisector::list_more() {
  for (const Item& item : items_) {
    const TriangleId t = item.e.triangle;
    if (item.action == Action::refuse) {
      refuse(t);
      if (item.has_across && is_wanted(item.across.triangle)) refuse(item.across.triangle);
    } else if (item.action == Action::wait) {
      state(t) = State::waiting;
      waited_.push_back(t);
    } else if (state(t) == State::taken) {
      state(t) = State::listed;
    }
  }
  for (const Item& item : items_) {
    if (item.action == Action::wait) {  // where the neighbour has just been cut, wake() sees to it
      const TriangleId neighbour = item.across.triangle;
      if (half(neighbour) == Forest::none && state(neighbour) == State::idle) list(neighbour);
    } else if (item.action == Action::cut) {
      wake(item.e, item.half_of_t);
      if (item.has_across) wake(item.across, item.half_of_u);
      if (item.constrained) split_record(item);
    }
  }
  for (const std::uint32_t i : cuts_) {
    half(items_[i].e.triangle) = Forest::none;
    if (items_[i].has_across) half(items_[i].across.triangle) = Forest::none;
  }
}

// Whatever waits for one of the two halves of what was cut at `e`.
void Bisector::wake(HalfEdge e, std::uint32_t second) {
  for (const HalfEdge side :
       {previous_edge(e), HalfEdge{TriangleId(second), next_corner(e.edge)}}) {
    const auto across = mesh_.twin(side);
    if (!across || state(across->triangle) != State::waiting) continue;
    if (cut_edge(across->triangle) == across->edge) list(across->triangle);
  }
}

void Bisector::refuse(TriangleId t) {
  state(t) = State::refused;
  result_.refused.push_back(t);
}

// What still waits does so for a triangle that was refused.
void Bisector::finish() {
  for (const TriangleId t : waited_) {
    if (state(t) == State::waiting) refuse(t);
  }
  for (const TriangleId t : result_.refused) state(t) = State::idle;
  std::ranges::sort(result_.refused);
}

Refinement Forest::bisect(std::span<const TriangleId> marked, const BisectOptions& options) {
  return Bisector(*this, options).run(marked);
}

}  // namespace lepp
