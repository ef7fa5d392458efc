// What bisection promises, in random rounds of marks.
#include <doctest/doctest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "bisection/plain_bisection.hpp"
#include "bisection/random_forest.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

using Integer = boost::multiprecision::cpp_int;

// u . w and u x w, where u and w lead from a corner to the other two: an angle as a vector.
struct Angle {
  Integer dot, cross;
};

Angle angle_at(Point p, Point q, Point r) {
  const auto exact = [](double d) { return Integer(static_cast<long long>(d)); };
  const Integer ux = exact(q.x) - exact(p.x), uy = exact(q.y) - exact(p.y),
                wx = exact(r.x) - exact(p.x), wy = exact(r.y) - exact(p.y);
  return {ux * wx + uy * wy, ux * wy - uy * wx};
}

// Exact: twice the angle is at least `other`, both below 180 degrees.
bool is_at_least_half_of(const Angle& angle, const Angle& other) {
  if (angle.dot <= 0) return true;
  const Integer dot = angle.dot * angle.dot - angle.cross * angle.cross,
                cross = 2 * angle.dot * angle.cross;
  return other.dot * cross >= other.cross * dot;
}

Angle smallest_angle(const std::array<Point, 3>& corners) {
  Angle smallest = angle_at(corners[0], corners[1], corners[2]);
  for (const std::size_t i : {1U, 2U}) {
    const Angle angle = angle_at(corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
    if (angle.cross * smallest.dot < smallest.cross * angle.dot) smallest = angle;
  }
  return smallest;
}

std::vector<PlainBisection::Corners> triangles_of(const Mesh& mesh) {
  std::vector<PlainBisection::Corners> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    all.push_back(PlainBisection::canonical(mesh.corners(TriangleId(t))));
  }
  std::ranges::sort(all);
  return all;
}

void check_same(const Mesh& mesh, const Mesh& start) {
  REQUIRE(mesh.vertex_count() == start.vertex_count());
  REQUIRE(mesh.triangle_count() == start.triangle_count());
  for (std::size_t v = 0; v < start.vertex_count(); ++v) {
    REQUIRE(mesh.points()[v] == start.points()[v]);
  }
  for (std::size_t i = 0; i < start.triangle_count(); ++i) {
    const TriangleId t(i);
    REQUIRE(mesh.vertices(t) == start.vertices(t));
    REQUIRE(mesh.region(t) == start.region(t));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{t, k};
      REQUIRE(mesh.twin(e) == start.twin(e));
      REQUIRE(mesh.is_constrained(e) == start.is_constrained(e));
      if (!mesh.is_constrained(e)) continue;
      const ConstrainedEdge now = mesh.constrained_edge(e), before = start.constrained_edge(e);
      REQUIRE(now.segments == before.segments);
      REQUIRE(now.t_low == before.t_low);
      REQUIRE(now.t_high == before.t_high);
    }
  }
}

// All that two meshes know of a triangle.
bool are_equal(const Mesh& a, const Mesh& b, TriangleId t) {
  if (a.vertices(t) != b.vertices(t) || a.region(t) != b.region(t)) return false;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdge e{t, k};
    if (a.twin(e) != b.twin(e) || a.is_constrained(e) != b.is_constrained(e)) return false;
    if (!a.is_constrained(e)) continue;
    const ConstrainedEdge in_a = a.constrained_edge(e), in_b = b.constrained_edge(e);
    if (in_a.segments != in_b.segments || in_a.t_low != in_b.t_low || in_a.t_high != in_b.t_high) {
      return false;
    }
  }
  return true;
}

bool are_equal(const Mesh& a, const Mesh& b, VertexId v) {
  const VertexOrigin &in_a = a.origin_of(v), &in_b = b.origin_of(v);
  return a.point(v) == b.point(v) && a.leaving(v) == b.leaving(v) && in_a.kind == in_b.kind &&
         in_a.index == in_b.index;
}

// Two forests with all that can be asked the same, every id included.
bool are_equal(const Forest& a, const Forest& b) {
  const Mesh &in_a = a.mesh(), &in_b = b.mesh();
  if (in_a.triangle_count() != in_b.triangle_count()) return false;
  if (in_a.vertex_count() != in_b.vertex_count()) return false;
  for (std::size_t i = 0; i < in_a.triangle_count(); ++i) {
    const TriangleId t(i);
    if (!are_equal(in_a, in_b, t) || a.edge_to_cut(t) != b.edge_to_cut(t)) return false;
    if (a.generation(t) != b.generation(t) || a.root(t) != b.root(t)) return false;
    if (a.sibling(t) != b.sibling(t)) return false;
  }
  for (std::size_t i = 0; i < in_a.vertex_count(); ++i) {
    if (!are_equal(in_a, in_b, VertexId(i))) return false;
  }
  return true;
}

bool are_equal(const Refinement& a, const Refinement& b) {
  const auto same_vertex = [](const NewVertex& v, const NewVertex& w) {
    return v.vertex == w.vertex && v.a == w.a && v.b == w.b;
  };
  const auto same_halves = [](const Halves& h, const Halves& i) {
    return h.whole == i.whole && h.other == i.other;
  };
  return std::ranges::equal(a.vertices, b.vertices, same_vertex) &&
         std::ranges::equal(a.triangles, b.triangles, same_halves) && a.refused == b.refused;
}

// A disc in a ring, between arcs of circles.
Mesh round_mesh() {
  Pslg pslg;
  const double pi = std::acos(-1.0);
  for (const double r : {1.0, 2.0}) {
    const CurveId curve(pslg.entities.curves.size());
    pslg.entities.curves.push_back({});
    pslg.entities.curves.back().geometry = EllipseArc{{0, 0}, {r, 0}, {0, r}, 0, 2 * pi};
    constexpr std::uint32_t pieces = 6;
    const auto first = static_cast<std::uint32_t>(pslg.points.size());
    for (std::uint32_t i = 0; i < pieces; ++i) {
      const double t = static_cast<double>(i) / pieces;
      pslg.points.push_back({r * std::cos(2 * pi * t), r * std::sin(2 * pi * t)});
      pslg.segments.push_back({VertexId(first + i), VertexId(first + (i + 1) % pieces), curve, t,
                               static_cast<double>(i + 1) / pieces});
    }
  }
  return constrained_delaunay(pslg).mesh;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    area += 0.5 * cross(b - a, c - a);
  }
  return area;
}

}  // namespace

TEST_CASE("20 rounds on 100 meshes: conforming, and no angle below half of its root's smallest") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Mesh start = integer_mesh(random, 2 + i % 10);
    Forest forest(start);
    for (int round = 0; round < 20; ++round) {
      const Refinement done = forest.bisect(some_triangles(random, forest.mesh(), 2));
      REQUIRE(done.refused.empty());
      REQUIRE(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
    }
    CHECK(area_of(forest.mesh()) == area_of(start));  // all of it is exact here
    std::size_t below = 0;
    for (std::size_t t = 0; t < forest.mesh().triangle_count(); ++t) {
      const Angle smallest = smallest_angle(forest.mesh().corners(TriangleId(t)));
      const Angle of_root = smallest_angle(start.corners(forest.root(TriangleId(t))));
      below += is_at_least_half_of(smallest, of_root) ? 0 : 1;
    }
    CHECK(below == 0);
  }
}

TEST_CASE("the same triangles as the recursive longest-edge algorithm, on 200 meshes") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const Mesh start = integer_mesh(random, i % 12);
    Forest forest(start);
    PlainBisection plain(start);
    for (int round = 0; round < 5; ++round) {
      const auto marked = some_triangles(random, forest.mesh(), 1 + random() % 6);
      for (const TriangleId t : marked) plain.refine(forest.mesh().corners(t));
      forest.bisect(marked);
    }
    REQUIRE(triangles_of(forest.mesh()) == plain.triangles());
  }
}

TEST_CASE("coarsening all brings the mesh of the start back, id by id, by either rule") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Mesh start = integer_mesh(random, i % 15);
    Forest forest(start, i % 2 == 0 ? BisectionRule::longest_edge : BisectionRule::newest_vertex);
    for (int round = 0; round < 8; ++round) {
      forest.bisect(some_triangles(random, forest.mesh(), 1 + random() % 10));
      if (random() % 3 == 0) {
        forest.coarsen(some_triangles(random, forest.mesh(), forest.mesh().triangle_count()));
        REQUIRE(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
      }
    }
    int calls = 0;
    while (!forest.coarsen(all_triangles(forest.mesh())).vertices.empty()) {
      REQUIRE(++calls < 1000);
      REQUIRE(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
    }
    check_same(forest.mesh(), start);
  }
}

TEST_CASE("the order of the marks does not change the triangles") {
  std::mt19937_64 random(4);
  const Mesh start = integer_mesh(random, 40);
  for (int round = 0; round < 3; ++round) {
    Forest forward(start), backward(start);
    auto marked = some_triangles(random, start, 30);
    forward.bisect(marked);
    std::ranges::shuffle(marked, random);
    backward.bisect(marked);
    CHECK(triangles_of(forward.mesh()) == triangles_of(backward.mesh()));
  }
}

TEST_CASE("the number of threads does not change a single id, link, record or tree") {
  std::mt19937_64 random(5);
  const double ulp = 0x1p-52;  // of coordinates from 1 to 2
  const struct {
    const char* name;
    Mesh start;
    BisectionRule rule;
    bool follow_curves, expects_refused;
  } cases[] = {
      {"longest edges", integer_mesh(random, 40), BisectionRule::longest_edge, false, false},
      {"newest vertices", integer_mesh(random, 40), BisectionRule::newest_vertex, false, false},
      {"curves", round_mesh(), BisectionRule::longest_edge, true, false},
      {"refused", integer_mesh(random, 40, ulp, {1, 1}), BisectionRule::longest_edge, false, true}};
  for (const auto& c : cases) {
    CAPTURE(c.name);
    Forest one(c.start, c.rule), two(c.start, c.rule);
    BisectOptions options;
    options.follow_curves = c.follow_curves;
    std::size_t most_marked = 0, after_coarsening = 0, refused = 0;
    const auto bisect = [&](const std::vector<TriangleId>& marked) {
      most_marked = std::max(most_marked, marked.size());
      options.threads = 1;
      const Refinement done = one.bisect(marked, options);
      options.threads = 2;
      REQUIRE(are_equal(done, two.bisect(marked, options)));
      if (marked.size() >= 1024) REQUIRE(are_equal(one, two));
      refused += done.refused.size();
      return done;
    };
    while (one.mesh().triangle_count() < 2500) {
      if (bisect(all_triangles(one.mesh())).triangles.empty())
        break;  // all that is left is refused
    }
    for (int round = 0; round < 2; ++round) {  // free ids and nodes are used again
      auto marked = all_triangles(one.mesh());
      std::erase_if(marked, [&](TriangleId) { return random() % 3 == 0; });
      one.coarsen(marked);
      two.coarsen(marked);
      REQUIRE(are_equal(one, two));
      marked = all_triangles(one.mesh());
      std::erase_if(marked, [&](TriangleId) { return random() % 4 == 0; });
      after_coarsening = std::max(after_coarsening, marked.size());
      bisect(marked);
    }
    CHECK(most_marked >= 1024);  // lists long enough for two threads
    CHECK(after_coarsening >= 1024);
    CHECK((refused > 0) == c.expects_refused);
    CHECK(validate(one.mesh(), {.delaunay = false}).summary() == "valid");
  }
}
