#include "lepp/io/msh_entities.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "lepp/io/ungrouped.hpp"
#include "lepp/triangulation/for_each_edge.hpp"

namespace lepp {

namespace {

// Gives every entity of one dimension its own positive tag; the first to ask for a tag gets it.
class Tags {
 public:
  explicit Tags(const auto& entities) {
    for (const auto& entity : entities) wanted_.insert(entity.tag);
  }
  int take(int wanted) {
    if (wanted > 0 && taken_.insert(wanted).second) return wanted;
    while (wanted_.contains(next_)) ++next_;
    return next_++;
  }

 private:
  std::set<int> wanted_, taken_;
  int next_ = 1;
};

std::vector<GroupId> unique(std::vector<GroupId> groups) {
  std::ranges::sort(groups);
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

// True if half-edge e runs the way of segment s, from its a to its b.
bool runs_along(const Mesh& mesh, HalfEdge e, const Segment& s) {
  const VertexId from = mesh.origin(e), to = mesh.destination(e);
  const ConstrainedEdge& record = mesh.constrained_edge(e);
  const double dt = (record.t_high - record.t_low) * (s.t_b - s.t_a);
  if (mesh.segments_of(e).size() == 1 && dt != 0) return (from < to) == (dt > 0);
  return dot(mesh.point(to) - mesh.point(from), mesh.point(s.b) - mesh.point(s.a)) >= 0;
}

// The curve entities, and two more for constrained edges of no curve.
class Curves {
 public:
  explicit Curves(const Mesh& mesh) : mesh_(mesh), bounding_(count_surfaces(mesh)) {
    const auto& entities = mesh.entities().curves;
    Tags tags(entities);
    for (const CurveEntity& c : entities) {
      add_curve(tags.take(c.tag), unique(c.groups));
    }
    boundary_ = curves.size();
    add_curve(tags.take(0), {});
    inside_ = curves.size();
    add_curve(tags.take(0), {});
  }

  void add(HalfEdge e) {
    std::vector<std::pair<std::size_t, bool>> owners;  // curve, and whether e runs along it
    for (const SegmentId id : mesh_.segments_of(e)) {
      const Segment& s = mesh_.segments()[id.index()];
      if (s.curve) owners.emplace_back(s.curve->index(), runs_along(mesh_, e, s));
    }
    if (owners.empty()) owners.emplace_back(mesh_.is_boundary(e) ? boundary_ : inside_, true);
    std::ranges::sort(owners);
    for (std::size_t i = 0; i < owners.size(); ++i) {
      if (i > 0 && owners[i].first == owners[i - 1].first) continue;
      add_line(e, owners[i].first, owners[i].second);
    }
  }

  // Signed tags of the curves around a surface.
  std::vector<int> boundary_of(std::size_t surface) const {
    std::vector<int> tags;
    for (const auto& [curve, along] : bounding_[surface]) {
      tags.push_back(along ? curves[curve].tag : -curves[curve].tag);
    }
    return tags;
  }

  static std::size_t count_surfaces(const Mesh& mesh) {
    std::size_t count = mesh.entities().surfaces.size();
    for (const Triangle& t : mesh.triangles()) count = std::max(count, t.region().index() + 1);
    return count;
  }

  std::vector<MshCurve> curves;

 private:
  void add_curve(int tag, std::vector<GroupId> groups) {
    MshCurve curve;
    curve.tag = tag;
    curve.groups = std::move(groups);
    curves.push_back(std::move(curve));
  }

  void add_line(HalfEdge e, std::size_t curve, bool along) {
    const VertexId a = mesh_.origin(e), b = mesh_.destination(e);
    curves[curve].lines.push_back(along ? MshLine{a, b} : MshLine{b, a});
    if (!mesh_.separates_regions(e)) {
      curves[curve].is_implied = false;
      return;
    }
    bounding_[mesh_.region(e.triangle).index()].try_emplace(curve, along);
    if (const auto across = mesh_.twin(e)) {
      bounding_[mesh_.region(across->triangle).index()].try_emplace(curve, !along);
    }
  }

  const Mesh& mesh_;
  std::size_t boundary_ = 0, inside_ = 0;
  std::vector<std::map<std::size_t, bool>> bounding_;  // per surface: curve -> surface on its left
};

// Start and end of an open chain; nothing for anything else.
std::vector<VertexId> ends_of_chain(const MshCurve& curve) {
  std::map<VertexId, int> degree;
  for (const auto& [a, b] : curve.lines) {
    ++degree[a];
    ++degree[b];
  }
  std::vector<VertexId> ends;
  for (const auto& [v, n] : degree) {
    if (n > 2) return {};
    if (n == 1) ends.push_back(v);
  }
  if (ends.size() != 2) return {};
  const bool starts_at_second =
      std::ranges::any_of(curve.lines, [&](const MshLine& line) { return line.a == ends[1]; });
  const bool starts_at_first =
      std::ranges::any_of(curve.lines, [&](const MshLine& line) { return line.a == ends[0]; });
  if (starts_at_second && !starts_at_first) std::swap(ends[0], ends[1]);
  return ends;
}

void collect_points(const Mesh& mesh, MshEntities& result) {
  const auto& entities = mesh.entities().points;
  Tags tags(entities);
  std::set<VertexId> known;
  for (const PointEntity& p : entities) {
    if (p.vertex.index() >= mesh.vertex_count()) continue;
    result.points.push_back({tags.take(p.tag), p.vertex, unique(p.groups), true});
    known.insert(p.vertex);
  }
  for (MshCurve& curve : result.curves) {
    curve.ends = ends_of_chain(curve);
    for (const VertexId v : curve.ends) {
      if (known.insert(v).second) result.points.push_back({tags.take(0), v, {}, false});
    }
  }
}

// From surfaces down to points, so that the lowest dimension stays.
void find_owners(const Mesh& mesh, MshEntities& result) {
  using Owner = MshEntities::Owner;
  auto& owner = result.owner_of_vertex;
  owner.assign(mesh.vertex_count(), {});
  for (std::uint32_t i = static_cast<std::uint32_t>(result.surfaces.size()); i-- > 0;) {
    for (const TriangleId t : result.surfaces[i].triangles) {
      for (const VertexId v : mesh.vertices(t)) owner[v.index()] = Owner{2, i};
    }
  }
  for (std::uint32_t i = static_cast<std::uint32_t>(result.curves.size()); i-- > 0;) {
    for (const auto& [a, b] : result.curves[i].lines) {
      owner[a.index()] = owner[b.index()] = Owner{1, i};
    }
  }
  for (std::uint32_t i = static_cast<std::uint32_t>(result.points.size()); i-- > 0;) {
    owner[result.points[i].vertex.index()] = Owner{0, i};
  }
}

std::vector<MshSurface> collect_surfaces(const Mesh& mesh, const Curves& curves) {
  const auto& entities = mesh.entities().surfaces;
  Tags tags(entities);
  std::vector<MshSurface> surfaces(Curves::count_surfaces(mesh));
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const bool known = i < entities.size();
    surfaces[i].tag = tags.take(known ? entities[i].tag : 0);
    if (known) surfaces[i].groups = unique(entities[i].groups);
    surfaces[i].boundary = curves.boundary_of(i);
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    surfaces[mesh.region(TriangleId(i)).index()].triangles.emplace_back(i);
  }
  std::erase_if(surfaces, [](const MshSurface& s) { return s.triangles.empty(); });
  return surfaces;
}

// The group "ungrouped" of a dimension, made when first asked for.
class UngroupedGroup {
 public:
  UngroupedGroup(std::vector<PhysicalGroup>& groups, int dimension)
      : groups_(groups), dimension_(dimension) {}

  std::vector<GroupId> only() {
    if (!id_) {
      id_ = GroupId(groups_.size());
      groups_.push_back(ungrouped(groups_, dimension_));
    }
    return {*id_};
  }

 private:
  std::vector<PhysicalGroup>& groups_;
  int dimension_;
  std::optional<GroupId> id_;
};

}  // namespace

void leave_nothing_ungrouped(MshEntities& entities) {
  const auto has_group = [](const auto& entity) { return !entity.groups.empty(); };
  if (std::ranges::none_of(entities.points, has_group) &&
      std::ranges::none_of(entities.curves, has_group) &&
      std::ranges::none_of(entities.surfaces, has_group)) {
    return;
  }
  for (MshPoint& p : entities.points) p.is_written = p.is_written && has_group(p);
  UngroupedGroup curves(entities.groups, 1), surfaces(entities.groups, 2);
  for (MshCurve& c : entities.curves) {
    if (has_group(c)) continue;
    if (c.is_implied) c.is_written = false;
    else c.groups = curves.only();
  }
  for (MshSurface& s : entities.surfaces) {
    if (!has_group(s)) s.groups = surfaces.only();
  }
}

MshEntities msh_entities(const Mesh& mesh) {
  Curves curves(mesh);
  for_each_edge(mesh, [&](HalfEdge e) {
    if (mesh.is_constrained(e)) curves.add(e);
  });
  MshEntities result;
  result.groups = mesh.entities().groups;
  result.surfaces = collect_surfaces(mesh, curves);
  result.curves = std::move(curves.curves);
  std::erase_if(result.curves, [](const MshCurve& c) { return c.lines.empty(); });
  collect_points(mesh, result);
  find_owners(mesh, result);
  return result;
}

}  // namespace lepp
