#include "lepp/triangulation/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lepp {

ConstrainedEdge Mesh::constrained_edge(HalfEdge e) const {
  const auto record = find_record(origin(e), destination(e));
  assert(record);
  return *record;
}

std::span<const SegmentId> Mesh::segments_of(SegmentSetId set) const {
  const std::size_t i = set.index();
  if (i < own_set_.size()) return {&own_set_[i], 1};
  return shared_sets_[i - own_set_.size()];
}

std::span<const SegmentId> Mesh::segments_of(HalfEdge e) const {
  return segments_of(constrained_edge(e).segments);
}

std::optional<CurveId> Mesh::curve_of(HalfEdge e) const {
  const auto owners = segments_of(e);
  if (owners.size() != 1) return std::nullopt;
  return segments_[owners[0].index()].curve;
}

std::optional<HalfEdge> Mesh::find_edge(VertexId a, VertexId b) const {
  std::optional<HalfEdge> found;
  for_each_in_fan(*this, a, [&](TriangleId t, std::uint32_t corner) {
    const HalfEdge out{t, previous_corner(corner)};
    const HalfEdge in{t, next_corner(corner)};
    if (destination(out) == b) found = out;
    else if (origin(in) == b) found = in;
    return !found;
  });
  return found;
}

void Mesh::set_source(std::string source, std::int64_t base) {
  source_ = std::move(source);
  base_ = base;
}

void Mesh::set_segments(std::vector<Segment> segments) {
  segments_ = std::move(segments);
  own_set_.resize(segments_.size());
  for (std::size_t i = 0; i < own_set_.size(); ++i) own_set_[i] = SegmentId(i);
  shared_sets_.clear();
  shared_set_index_.clear();
}

void Mesh::reserve(std::size_t vertices, std::size_t triangles) {
  points_.reserve(vertices);
  origins_.reserve(vertices);
  leaving_.reserve(vertices);
  triangles_.reserve(triangles);
}

void Mesh::adopt(TriangleArray triangles, std::span<const std::uint32_t> leaving,
                 std::span<const std::uint32_t> vertex) {
  triangles_ = std::move(triangles);
  for (std::size_t v = 0; v < leaving.size(); ++v) {
    if (leaving[v] != nothing) leaving_[vertex[v]] = leaving[v];
  }
}

void Mesh::own_edges(std::span<const SegmentId> again) {
  constexpr std::size_t ahead = 16;  // the table is larger than the cache
  constrained_edges_.reserve(segments_.size() - again.size());
  auto next_again = again.begin();
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    if (s + ahead < segments_.size()) {
      constrained_edges_.prefetch(segments_[s + ahead].a, segments_[s + ahead].b);
    }
    if (next_again != again.end() && next_again->index() == s) {
      ++next_again;
      continue;
    }
    constrained_edges_.set(segments_[s].a, segments_[s].b, {SegmentSetId(s), {}});
  }
  const auto edge_of = [&](SegmentId s) {
    return std::minmax({segments_[s.index()].a, segments_[s.index()].b});
  };
  std::vector<SegmentId> by_edge(again.begin(), again.end());
  std::ranges::stable_sort(by_edge, {}, edge_of);
  for (auto begin = by_edge.cbegin(); begin != by_edge.cend();) {
    const auto edge = edge_of(*begin);
    const auto end =
        std::find_if(begin, by_edge.cend(), [&](SegmentId s) { return edge_of(s) != edge; });
    const auto [a, b] = edge;
    std::vector<SegmentId> owners{SegmentId(find_record(a, b)->segments.value)};  // the first one
    owners.insert(owners.end(), begin, end);
    share_edge(a, b, std::move(owners));
    begin = end;
  }
}

namespace {

template <class T>
void permute(GrowingArray<T>& items, std::span<const std::uint32_t> number_of) {
  GrowingArray<T> moved(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) moved[number_of[i]] = items[i];
  items.swap(moved);
}

}  // namespace

void Mesh::renumber_vertices(std::span<const std::uint32_t> number_of) {
  const auto renumber = [&](VertexId& v) { v = VertexId(number_of[v.index()]); };
  constrained_edges_.renumber(number_of);
  for (Segment& s : segments_) {
    renumber(s.a);
    renumber(s.b);
  }
  permute(points_, number_of);
  permute(origins_, number_of);
  permute(leaving_, number_of);
  for (Triangle& t : triangles_) std::ranges::for_each(t.vertices, renumber);
}

void Mesh::renumber_triangles(std::span<const std::uint32_t> number_of) {
  const auto renumber = [&](std::uint32_t& code) {
    if (code != nothing) code = 4 * number_of[code / 4] + code % 4;
  };
  TriangleArray moved(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    Triangle& t = moved[number_of[i]];
    t = triangles_[i];
    std::ranges::for_each(t.across_, renumber);
  }
  triangles_.swap(moved);
  std::ranges::for_each(leaving_, renumber);
}

VertexId Mesh::add_vertex(Point p, VertexOrigin origin) {
  const VertexId v(points_.size());
  points_.push_back(p);
  origins_.push_back(origin);
  leaving_.push_back(nothing);
  return v;
}

TriangleId Mesh::add_triangle(VertexId a, VertexId b, VertexId c, SurfaceId region) {
  if (triangles_.size() >= max_triangles) refuse_more_triangles();
  const TriangleId t(triangles_.size());
  Triangle triangle{};
  triangle.across_ = {nothing, nothing, nothing};
  triangle.region_ = region;
  triangles_.push_back(triangle);
  set_vertices(t, a, b, c);
  return t;
}

void Mesh::take_place_of(HalfEdge e, HalfEdge old) {
  const Triangle& from = triangles_[old.triangle.index()];
  const std::uint32_t across = from.across_[old.edge];
  const bool constrained = (from.constrained_ >> old.edge & 1U) != 0;
  if (across == nothing) {
    unlink(e);
  } else {
    link(e, half_edge(across));
  }
  set_constrained_flag(e, constrained);
}

std::optional<TriangleId> Mesh::remove_triangle(TriangleId t) {
  const TriangleId last(triangles_.size() - 1);
  if (t != last) {
    triangles_[t.index()] = triangles_[last.index()];
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (const auto across = twin({t, i})) link({t, i}, *across);
      std::uint32_t& leaving = leaving_[origin({t, i}).index()];
      if (leaving == code({last, i})) leaving = code({t, i});
    }
  }
  triangles_.pop_back();
  return t != last ? std::optional(last) : std::nullopt;
}

std::optional<VertexId> Mesh::remove_vertex(VertexId v) {
  const VertexId last(points_.size() - 1);
  if (v != last) {
    assert(!is_input(last));
    for_each_in_fan(*this, last, [&](TriangleId t, std::uint32_t corner) {
      const std::uint32_t next = next_corner(corner), previous = previous_corner(corner);
      if (is_constrained({t, previous})) move_record(vertex(t, next), last, v);
      if (is_constrained({t, next})) move_record(vertex(t, previous), last, v);
      triangles_[t.index()].vertices[corner] = v;
    });
    points_[v.index()] = points_[last.index()];
    origins_[v.index()] = origins_[last.index()];
    leaving_[v.index()] = leaving_[last.index()];
  }
  points_.pop_back();
  origins_.pop_back();
  leaving_.pop_back();
  return v != last ? std::optional(last) : std::nullopt;
}

// Edge (end, from) becomes (end, to). An edge is seen from two sides, so it may be done already.
void Mesh::move_record(VertexId end, VertexId from, VertexId to) {
  const auto record = find_record(end, from);
  if (!record) return;
  erase_record(end, from);
  ConstrainedEdge moved = *record;
  if ((end < from) != (end < to)) std::swap(moved.t_low, moved.t_high);
  set_record(end, to, moved);
}

void Mesh::constrain(HalfEdge e, const ConstrainedEdge& record) {
  set_constrained_flag(e, true);
  if (const auto across = twin(e)) set_constrained_flag(*across, true);
  set_record(origin(e), destination(e), record);
}

void Mesh::add_owner(HalfEdge e, SegmentId s, double t_origin, double t_destination) {
  const VertexId a = origin(e), b = destination(e);
  const auto old = find_record(a, b);
  if (!old) {
    const bool in_order = a < b;
    constrain(e, {SegmentSetId(s.value), in_order ? t_origin : t_destination,
                  in_order ? t_destination : t_origin});
    return;
  }
  const auto known = segments_of(old->segments);
  if (std::ranges::find(known, s) != known.end()) return;
  std::vector<SegmentId> owners(known.begin(), known.end());
  owners.insert(std::ranges::upper_bound(owners, s), s);
  share_edge(a, b, std::move(owners));
}

// \pre `owners` are ascending
void Mesh::share_edge(VertexId a, VertexId b, std::vector<SegmentId> owners) {
  const auto next = static_cast<std::uint32_t>(own_set_.size() + shared_sets_.size());
  const auto [known, is_new] = shared_set_index_.try_emplace(owners, next);
  if (is_new) shared_sets_.push_back(std::move(owners));
  set_record(a, b, {known->second, 0, 1});
}

namespace {

// What an edge between the very ends of segment `s` inherits.
ConstrainedEdge whole(SegmentSetId set, const Segment& s) {
  return s.a < s.b ? ConstrainedEdge{set, s.t_a, s.t_b} : ConstrainedEdge{set, s.t_b, s.t_a};
}

}  // namespace

std::optional<ConstrainedEdge> Mesh::find_record(VertexId a, VertexId b) const {
  const auto found = constrained_edges_.find(a, b);
  if (!found) return std::nullopt;
  const std::size_t s = found->segments.index();
  if (!found->parameters && s < segments_.size()) return whole(found->segments, segments_[s]);
  const auto [low, high] = found->parameters.value_or(EdgeRecords::Parameters{0, 1});
  return ConstrainedEdge{found->segments, low, high};
}

void Mesh::set_record(VertexId a, VertexId b, const ConstrainedEdge& record) {
  EdgeRecords::Record stored{record.segments, {{record.t_low, record.t_high}}};
  const std::size_t s = record.segments.index();
  if (s < segments_.size()) {
    const ConstrainedEdge inherited = whole(record.segments, segments_[s]);
    if (inherited.t_low == record.t_low && inherited.t_high == record.t_high) {
      stored.parameters.reset();
    }
  }
  constrained_edges_.set(a, b, stored);
}

void Mesh::split_record(VertexId a, VertexId b, VertexId v, double t) {
  const ConstrainedEdge record = *find_record(a, b);
  const double t_a = a < b ? record.t_low : record.t_high;
  const double t_b = a < b ? record.t_high : record.t_low;
  erase_record(a, b);
  const auto half = [&](VertexId end, double t_end) {
    return end < v ? ConstrainedEdge{record.segments, t_end, t}
                   : ConstrainedEdge{record.segments, t, t_end};
  };
  set_record(a, v, half(a, t_a));
  set_record(v, b, half(b, t_b));
}

void Mesh::join_records(VertexId a, VertexId v, VertexId b) {
  const ConstrainedEdge to_a = *find_record(a, v), to_b = *find_record(v, b);
  const double t_a = a < v ? to_a.t_low : to_a.t_high;
  const double t_b = b < v ? to_b.t_low : to_b.t_high;
  erase_record(a, v);
  erase_record(v, b);
  set_record(a, b, {to_a.segments, a < b ? t_a : t_b, a < b ? t_b : t_a});
}

void Mesh::grow(std::size_t vertices, std::size_t triangles) {
  if (triangles_.size() + triangles > max_triangles) refuse_more_triangles();
  points_.make_room_for(vertices);
  origins_.make_room_for(vertices);
  leaving_.make_room_for(vertices);
  triangles_.make_room_for(triangles);
  points_.resize(points_.size() + vertices);
  origins_.resize(origins_.size() + vertices);
  leaving_.resize(leaving_.size() + vertices);
  triangles_.resize(triangles_.size() + triangles);
}

void Mesh::refuse_more_triangles() const {
  throw RefusedError(source_, "more than 1.07e9 triangles", "split the domain or ask for less");
}

void Mesh::erase_record(VertexId a, VertexId b) { constrained_edges_.erase(a, b); }

}  // namespace lepp
