#include <algorithm>
#include <limits>

#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/place_on_segment.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/boundary_walk.hpp"
#include "lepp/triangulation/locate.hpp"

namespace lepp {
namespace {

using Source = VertexTransfer::Source;

/// The place of an edge that is nearest to a point.
struct NearPlace {
  HalfEdge edge;
  double along = 0;  // from the origin of the edge (0) to its destination (1)
  double squared_distance = std::numeric_limits<double>::infinity();
};

NearPlace near_place(const Mesh& mesh, HalfEdge e, Point p) {
  const auto [along, squared] =
      nearest_place(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p);
  return {e, along, squared};
}

Source source_on(const Mesh& mesh, const NearPlace& place) {
  return {{mesh.origin(place.edge), mesh.destination(place.edge), mesh.apex(place.edge)},
          {1 - place.along, place.along, 0}};
}

/// A triangle as thin as rounding is taken for its edges.
Source source_in_sliver(const Mesh& mesh, TriangleId t, Point p) {
  NearPlace nearest;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const NearPlace here = near_place(mesh, {t, i}, p);
    if (here.squared_distance < nearest.squared_distance) nearest = here;
  }
  return source_on(mesh, nearest);
}

/// That `p` is inside is exact, and the areas are not.
Source source_at(const Mesh& mesh, const Location& place, Point p) {
  const auto& corners = mesh.vertices(place.triangle);
  Source source{corners, {0, 0, 0}};
  double sum = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (place.at_vertex) {
      source.weights[i] = corners[i] == *place.at_vertex ? 1 : 0;
    } else {
      const double part = signed_area(p, mesh.point(corners[next_corner(i)]),
                                      mesh.point(corners[previous_corner(i)]));
      source.weights[i] = std::max(0.0, part);
    }
    sum += source.weights[i];
  }
  if (!(sum > 0)) return source_in_sliver(mesh, place.triangle, p);
  for (double& weight : source.weights) weight /= sum;
  return source;
}

/// From one edge of the boundary along it, as long as one of the next eight is nearer.
NearPlace nearest_from(const Mesh& mesh, HalfEdge start, Point p) {
  constexpr int reach = 8;
  NearPlace nearest = near_place(mesh, start, p);
  for (bool nearer = true; nearer;) {  // ends: the distance falls
    nearer = false;
    HalfEdge after = nearest.edge, before = nearest.edge;
    for (int i = 0; i < reach; ++i) {
      after = next_side(mesh, after);
      before = previous_side(mesh, before);
      for (const HalfEdge e : {after, before}) {
        const NearPlace here = near_place(mesh, e, p);
        if (!(here.squared_distance < nearest.squared_distance)) continue;
        nearest = here;
        nearer = true;
      }
    }
  }
  return nearest;
}

NearPlace nearest_of_all(const Mesh& mesh, Point p) {
  NearPlace nearest;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_boundary(e)) continue;
      const NearPlace here = near_place(mesh, e, p);
      if (here.squared_distance < nearest.squared_distance) nearest = here;
    }
  }
  return nearest;
}

/// Places for new vertices that are outside: each walk starts from the place of a neighbour.
class OutsidePlaces {
 public:
  OutsidePlaces(const Mesh& before, const Mesh& after, VertexTransfer& transfer)
      : before_(before), after_(after), transfer_(transfer) {}

  /// \param near  by new vertex: an old triangle that contains it, or none
  void find(std::vector<std::optional<TriangleId>>& near) {
    std::vector<VertexId> queue;
    for (std::size_t v = 0; v < near.size(); ++v) {
      if (!near[v]) continue;
      for_each_neighbour(VertexId(v), [&](VertexId w) {
        if (!near[w.index()]) set(w, *near[v], near, queue);
      });
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const TriangleId hint = *near[queue[i].index()];
      for_each_neighbour(queue[i], [&](VertexId w) {
        if (!near[w.index()]) set(w, hint, near, queue);
      });
    }
    for (std::size_t v = 0; v < near.size(); ++v) {  // a part that does not touch the old mesh
      if (!near[v]) use(VertexId(v), nearest_of_all(before_, after_.point(VertexId(v))));
    }
  }

 private:
  template <class Visit>
  void for_each_neighbour(VertexId v, Visit visit) const {
    for_each_in_fan(after_, v, [&](TriangleId t, std::uint32_t corner) {
      visit(after_.vertex(t, next_corner(corner)));
      visit(after_.vertex(t, previous_corner(corner)));
    });
  }

  void set(VertexId v, TriangleId hint, std::vector<std::optional<TriangleId>>& near,
           std::vector<VertexId>& queue) {
    LocateSteps steps;
    const Point p = after_.point(v);
    const WalkEnd end = walk(before_, p, hint, before_.triangle_count(), steps);
    const NearPlace place =
        end.side ? nearest_from(before_, *end.side, p) : nearest_of_all(before_, p);
    use(v, place);
    near[v.index()] = place.edge.triangle;
    queue.push_back(v);
  }

  void use(VertexId v, const NearPlace& place) {
    transfer_.sources[v.index()] = source_on(before_, place);
    ++transfer_.outside;
  }

  const Mesh& before_;
  const Mesh& after_;
  VertexTransfer& transfer_;
};

}  // namespace

VertexTransfer vertex_transfer(const Mesh& before, const Mesh& after) {
  VertexTransfer transfer;
  transfer.vertices_before = before.vertex_count();
  transfer.sources.resize(after.vertex_count());
  std::vector<std::optional<TriangleId>> near(after.vertex_count());
  const auto places = locate(before, after.points());
  bool any_outside = false;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (places[v]) {
      transfer.sources[v] = source_at(before, *places[v], after.points()[v]);
      near[v] = places[v]->triangle;
    } else {
      any_outside = true;
    }
  }
  if (any_outside) OutsidePlaces(before, after, transfer).find(near);
  return transfer;
}

}  // namespace lepp
