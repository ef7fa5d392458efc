#include "lepp/triangulation/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lepp {

namespace {

// 3 * triangle + edge and "nothing" share 32 bits.
constexpr std::size_t max_triangles = 0xFFFFFFFFU / 3 - 1;

}  // namespace

std::array<Point, 3> Mesh::corners(TriangleId t) const {
  const auto& v = vertices(t);
  return {point(v[0]), point(v[1]), point(v[2])};
}

std::optional<HalfEdge> Mesh::twin(HalfEdge e) const {
  const std::uint32_t across = triangles_[e.triangle.index()].across_[e.edge];
  if (across == nothing) return std::nullopt;
  return HalfEdge{TriangleId(across / 3), across % 3};
}

bool Mesh::separates_regions(HalfEdge e) const {
  const auto across = twin(e);
  return !across || region(across->triangle) != region(e.triangle);
}

const ConstrainedEdge& Mesh::constrained_edge(HalfEdge e) const {
  const ConstrainedEdge* record = find_record(origin(e), destination(e));
  assert(record != nullptr);
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

HalfEdge Mesh::leaving(VertexId v) const {
  const std::uint32_t e = leaving_[v.index()];
  return {TriangleId(e / 3), e % 3};
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

VertexId Mesh::add_vertex(Point p, VertexOrigin origin) {
  const VertexId v(points_.size());
  points_.push_back(p);
  origins_.push_back(origin);
  leaving_.push_back(nothing);
  return v;
}

TriangleId Mesh::add_triangle(VertexId a, VertexId b, VertexId c, SurfaceId region) {
  if (triangles_.size() >= max_triangles) {
    throw RefusedError(source_, "more than 1.4e9 triangles", "split the domain or ask for less");
  }
  const TriangleId t(triangles_.size());
  Triangle triangle;
  triangle.across_ = {nothing, nothing, nothing};
  triangle.region_ = region;
  triangles_.push_back(triangle);
  set_vertices(t, a, b, c);
  return t;
}

void Mesh::set_vertices(TriangleId t, VertexId a, VertexId b, VertexId c) {
  triangles_[t.index()].vertices = {a, b, c};
  refresh_leaving(t);
}

void Mesh::refresh_leaving(TriangleId t) {
  for (std::uint32_t corner = 0; corner < 3; ++corner) {
    const VertexId v = vertex(t, corner);
    const std::uint32_t e = leaving_[v.index()];
    if (e == nothing || origin({TriangleId(e / 3), e % 3}) != v) {
      leaving_[v.index()] = code({t, previous_corner(corner)});
    }
  }
}

void Mesh::unlink(HalfEdge e) {
  triangles_[e.triangle.index()].across_[e.edge] = nothing;
  leaving_[origin(e).index()] = code(e);
}

void Mesh::link(HalfEdge e, HalfEdge f) {
  triangles_[e.triangle.index()].across_[e.edge] = code(f);
  triangles_[f.triangle.index()].across_[f.edge] = code(e);
}

void Mesh::take_place_of(HalfEdge e, HalfEdge old) {
  const Triangle& from = triangles_[old.triangle.index()];
  const std::uint32_t across = from.across_[old.edge];
  const bool constrained = (from.constrained_ >> old.edge & 1U) != 0;
  if (across == nothing) {
    unlink(e);
  } else {
    link(e, {TriangleId(across / 3), across % 3});
  }
  set_constrained_flag(e, constrained);
}

void Mesh::set_constrained_flag(HalfEdge e, bool constrained) {
  std::uint32_t& flags = triangles_[e.triangle.index()].constrained_;
  const std::uint32_t bit = 1U << e.edge;
  flags = constrained ? flags | bit : flags & ~bit;
}

void Mesh::constrain(HalfEdge e, const ConstrainedEdge& record) {
  set_constrained_flag(e, true);
  if (const auto across = twin(e)) set_constrained_flag(*across, true);
  set_record(origin(e), destination(e), record);
}

void Mesh::add_owner(HalfEdge e, SegmentId s, double t_origin, double t_destination) {
  const VertexId a = origin(e), b = destination(e);
  const ConstrainedEdge* old = find_record(a, b);
  if (old == nullptr) {
    const bool in_order = a < b;
    constrain(e, {SegmentSetId(s.value), in_order ? t_origin : t_destination,
                  in_order ? t_destination : t_origin});
    return;
  }
  const auto owners = segments_of(old->segments);
  if (std::ranges::find(owners, s) != owners.end()) return;
  std::vector<SegmentId> shared(owners.begin(), owners.end());
  shared.push_back(s);
  std::ranges::sort(shared);
  const auto next = static_cast<std::uint32_t>(own_set_.size() + shared_sets_.size());
  const auto [known, is_new] = shared_set_index_.try_emplace(shared, next);
  if (is_new) shared_sets_.push_back(std::move(shared));
  set_record(a, b, {known->second, 0, 1});
}

std::uint64_t Mesh::key(VertexId a, VertexId b) {
  const auto [low, high] = std::minmax(a.value, b.value);
  return std::uint64_t{low} << 32 | high;
}

const ConstrainedEdge* Mesh::find_record(VertexId a, VertexId b) const {
  const auto found = constrained_edges_.find(key(a, b));
  return found == constrained_edges_.end() ? nullptr : &found->second;
}

void Mesh::set_record(VertexId a, VertexId b, const ConstrainedEdge& record) {
  constrained_edges_[key(a, b)] = record;
}

void Mesh::erase_record(VertexId a, VertexId b) { constrained_edges_.erase(key(a, b)); }

}  // namespace lepp
