#include "lepp/voronoi/voronoi_boxes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "support/hand_made.hpp"

using namespace lepp;
using namespace lepp::test;
using doctest::Approx;

namespace {

const VoronoiBox& box_of(const VoronoiBoxes& boxes, std::uint32_t v, std::uint32_t region = 0) {
  const auto found = std::ranges::find_if(boxes.boxes, [&](const VoronoiBox& box) {
    return box.vertex == VertexId(v) && box.region == SurfaceId(region);
  });
  REQUIRE(found != boxes.boxes.end());
  return *found;
}

const VoronoiFace& face_of(const VoronoiBoxes& boxes, std::uint32_t k, std::uint32_t l,
                           std::uint32_t region = 0) {
  const auto found = std::ranges::find_if(boxes.faces, [&](const VoronoiFace& face) {
    return face.k == VertexId(k) && face.l == VertexId(l) && face.region == SurfaceId(region);
  });
  REQUIRE(found != boxes.faces.end());
  return *found;
}

Point centroid(std::span<const Point> corners) {
  Point sum;
  for (const Point p : corners) sum = sum + p;
  return 1.0 / static_cast<double>(corners.size()) * sum;
}

VertexId nearest_vertex(const Mesh& mesh, Point p) {
  const auto points = mesh.points();
  const auto nearest =
      std::ranges::min_element(points, {}, [&](Point q) { return squared_distance(p, q); });
  return VertexId(static_cast<std::size_t>(nearest - points.begin()));
}

// Sum over the faces of each vertex of sigma / h (x_k - x_l): zero where the box is closed.
std::vector<Point> fluxes_of_coordinates(const Mesh& mesh, const VoronoiBoxes& boxes) {
  std::vector<Point> flux(mesh.vertex_count());
  for (const VoronoiFace& f : boxes.faces) {
    const Point through = f.length / f.distance * (mesh.point(f.k) - mesh.point(f.l));
    flux[f.k.index()] = flux[f.k.index()] + through;
    flux[f.l.index()] = flux[f.l.index()] - through;
  }
  return flux;
}

std::vector<bool> is_on_boundary(const Mesh& mesh) {
  std::vector<bool> result(mesh.vertex_count(), false);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_boundary(e)) continue;
      result[mesh.origin(e).index()] = result[mesh.destination(e).index()] = true;
    }
  }
  return result;
}

// Largest |sigma / h - factor| over edges and regions: 0 but for rounding on an admissible mesh.
double largest_difference_from_edge_factors(const Mesh& mesh, const VoronoiBoxes& boxes) {
  const std::vector<EdgeFactor> factors = edge_factors(mesh);
  REQUIRE(boxes.faces.size() == factors.size());
  double largest = 0;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const VoronoiFace& face = boxes.faces[i];
    REQUIRE(face.k == factors[i].k);
    REQUIRE(face.l == factors[i].l);
    REQUIRE(face.region == factors[i].region);
    largest = std::max(largest, std::abs(face.length / face.distance - factors[i].factor));
  }
  return largest;
}

}  // namespace

TEST_CASE("the boxes of a square are its quarters, and its diagonal has a face of length 0") {
  const VoronoiBoxes boxes = voronoi_boxes(square());
  REQUIRE(boxes.boxes.size() == 4);
  for (const VoronoiBox& box : boxes.boxes) CHECK(box.area == 0.25);
  REQUIRE(boxes.faces.size() == 5);
  CHECK(face_of(boxes, 0, 1).length == 0.5);
  CHECK(face_of(boxes, 0, 3).length == 0.5);
  CHECK(face_of(boxes, 0, 2).length == 0);
  CHECK(face_of(boxes, 0, 2).distance == std::sqrt(2.0));
}

TEST_CASE("the box in the middle of a hexagon is a hexagon") {
  const VoronoiBoxes boxes = voronoi_boxes(hexagon());
  CHECK(box_of(boxes, 6).area == Approx(std::sqrt(0.75)).epsilon(1e-14));
  CHECK(box_of(boxes, 6).pieces == 6);
  CHECK(box_of(boxes, 0).area == Approx(std::sqrt(0.75) / 3).epsilon(1e-14));
  CHECK(face_of(boxes, 0, 6).length == Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
  CHECK(face_of(boxes, 0, 1).length == Approx(0.5 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("the box of an interface vertex is split per region") {
  const VoronoiBoxes boxes = voronoi_boxes(two_triangles({0, 0}, {1, 0}, {1, 1}, {0, 1}, 1));
  REQUIRE(boxes.boxes.size() == 6);
  CHECK(box_of(boxes, 0, 0).area == 0.125);
  CHECK(box_of(boxes, 0, 1).area == 0.125);
  CHECK(box_of(boxes, 1, 0).area == 0.25);
  CHECK(face_of(boxes, 0, 2, 0).length == 0);
  CHECK(face_of(boxes, 0, 2, 1).length == 0);
  CHECK(box_areas(square(), boxes) == std::vector<double>(4, 0.25));
}

//        d           b is obtuse and its box reaches across ac, up to the circumcentre (0, 1.5) of
//       / \          abc; the face between a and c runs from there to (0, 2.1), the other
//      /   \         circumcentre, and so lies in one triangle only.
//     a --- c
//       `b'
TEST_CASE("the box of an obtuse corner reaches into the next triangle") {
  const Mesh mesh = two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5});
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  const VoronoiBox& b = box_of(boxes, 1);
  CHECK(b.area == Approx(2.5).epsilon(1e-14));
  REQUIRE(b.pieces == 2);
  CHECK(boxes.piece_triangle[b.first_piece] == TriangleId(0U));
  CHECK(boxes.piece_triangle[b.first_piece + 1] == TriangleId(1U));
  const auto piece = boxes.piece(b.first_piece + 1);
  REQUIRE(piece.size() == 3);
  CHECK(signed_area(piece[0], piece[1], piece[2]) == Approx(1.125).epsilon(1e-14));
  CHECK(face_of(boxes, 0, 2).length == Approx(0.6).epsilon(1e-14));
  CHECK(certify(mesh, boxes).summary() == "admissible");
}

TEST_CASE("a region ends the box of an obtuse corner") {
  const VoronoiBoxes boxes = voronoi_boxes(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5}, 1));
  CHECK(box_of(boxes, 1).area == Approx(2.5 - 1.125).epsilon(1e-14));
  CHECK(box_of(boxes, 1).pieces == 1);
  CHECK(face_of(boxes, 0, 2, 0).length == 0);
  CHECK(face_of(boxes, 0, 2, 1).length == Approx(2.1).epsilon(1e-14));  // from the side ac up
}

TEST_CASE("a vertex of two fans has one box with a piece in each") {
  const Mesh mesh =
      from_triangles({{0, 0}, {2, -1}, {2, 1}, {-2, 1}, {-2, -1}}, {{0, 1, 2}, {0, 3, 4}});
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  const VoronoiBox& box = box_of(boxes, 0);
  CHECK(box.pieces == 2);
  CHECK(certify(mesh, boxes).summary() == "admissible");
  CHECK(box.area == Approx(2 * box_of(boxes, 1).area + 2 * (box.area / 2 - box_of(boxes, 1).area)));
  CHECK(box.area + 4 * box_of(boxes, 1).area == Approx(4).epsilon(1e-14));
  CHECK(face_of(boxes, 1, 2).length == Approx(0.75).epsilon(1e-14));  // circumcentre (1.25, 0)
}

//  A notch between the long edge ka and the short edge kl. Across the notch l is nearer to parts of
//  the box of k than k, but it does not see them: the scheme has no flux there.
TEST_CASE("a box does not reach across a notch") {
  const std::vector<Point> points{{0, 0},   {4, 0.4},     {2, 4},    {-2, 3},
                                  {-3, -1}, {-0.5, -1.5}, {0.5, -1}, {1, -0.1}};
  const Mesh one_fan =
      from_triangles(points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}});
  const Mesh two_fans = from_triangles({points[0], points[1], points[2], points[6], points[7]},
                                       {{0, 1, 2}, {0, 3, 4}});
  for (const Mesh& mesh : {one_fan, two_fans}) {
    const VoronoiBoxes boxes = voronoi_boxes(mesh);
    CHECK(certify(mesh, boxes).summary() == "admissible");
    CHECK(largest_difference_from_edge_factors(mesh, boxes) < 1e-14);
    const VoronoiFace& across =
        face_of(boxes, 0, static_cast<std::uint32_t>(mesh.vertex_count() - 1));
    CHECK(across.length < 1);
    const TriangleId at_long(0U), at_short(mesh.triangle_count() - 1);
    for (const VoronoiBox& box : boxes.boxes) {
      for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
        const TriangleId t = boxes.piece_triangle[i];
        if (t == at_long || t == at_short)
          CHECK(std::ranges::count(mesh.vertices(t), box.vertex) == 1);
      }
    }
  }
}

TEST_CASE("a constrained edge inside a region ends a box like a wall") {
  Mesh mesh = two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5});
  add_segments(mesh, {{0, 2, {}}});
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  CHECK(box_of(boxes, 1).area == Approx(2.5 - 1.125).epsilon(1e-14));
  CHECK(face_of(boxes, 0, 2).length == Approx(2.1).epsilon(1e-14));
}

// Twelve spokes of a wheel, some of them walls: the hub has as many fans as walls, in one box.
TEST_CASE("walls that meet in a vertex part its box into fans, whatever corner comes first") {
  std::vector<Point> points{{0, 0}};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < 12; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.2 * (i % 2)) / 12;
    points.push_back({std::cos(turn), std::sin(turn)});
    triangles.push_back({0, 1 + (5 * i) % 12, 1 + (5 * i + 1) % 12});  // not in order around it
  }
  for (const unsigned walls : {0x000U, 0x001U, 0x081U, 0x155U, 0xAAAU, 0xFFFU}) {
    CAPTURE(walls);
    Mesh mesh = from_triangles(points, triangles);
    std::vector<ExtraSegment> spokes;
    for (std::uint32_t i = 0; i < 12; ++i) {
      if ((walls >> i & 1U) != 0) spokes.push_back({0, i + 1, {}});
    }
    add_segments(mesh, spokes);
    const VoronoiBoxes boxes = voronoi_boxes(mesh);
    CHECK(box_of(boxes, 0).pieces == 12);
    CHECK(certify(mesh, boxes).summary() == "admissible");
    CHECK(certify(mesh).summary() == "admissible");
    double sum = 0;
    for (const double area : box_areas(mesh, boxes)) sum += area;
    CHECK(sum == Approx(total_area(mesh)).epsilon(1e-14));
  }
}

TEST_CASE("boxes and faces are sorted, and each edge has one face per region") {
  const Mesh mesh = grid({.columns = 6, .rows = 5, .jitter = 0.15, .regions = 3});
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  CHECK(std::ranges::is_sorted(boxes.boxes, {},
                               [](const VoronoiBox& b) { return std::tuple(b.vertex, b.region); }));
  CHECK(std::ranges::is_sorted(
      boxes.faces, {}, [](const VoronoiFace& f) { return std::tuple(f.k, f.l, f.region); }));
  CHECK(boxes.faces.size() == edge_factors(mesh).size());  // no inner edge is constrained twice
  CHECK(boxes.boxes.size() == 7 * 6 + 2 * 6);              // two lines of interface vertices
}

TEST_CASE("each piece is convex, counter-clockwise and nearest to its own vertex") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = grid({.columns = 6, .rows = 6, .jitter = 0.15, .seed = seed});
    const VoronoiBoxes boxes = voronoi_boxes(mesh);
    for (const VoronoiBox& box : boxes.boxes) {
      for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
        const auto piece = boxes.piece(i);
        for (std::size_t j = 0; j < piece.size(); ++j) {
          const Point a = piece[j], b = piece[(j + 1) % piece.size()],
                      c = piece[(j + 2) % piece.size()];
          CHECK(cross(b - a, c - b) > -1e-14);
        }
        CHECK(nearest_vertex(mesh, centroid(piece)) == box.vertex);
      }
    }
  }
}

TEST_CASE("a square grid makes three pieces per triangle and no slivers, wherever it lies") {
  for (const Point corner : {Point{0, 0}, {0.1, 0.7}, {-1.0 / 3, 1e3}, {5e5, 5e6}}) {
    for (const double spacing : {1.0, 0.1, 1.0 / 3, 1e-3}) {
      CAPTURE(corner.x);
      CAPTURE(spacing);
      const bool rounds = corner.x > 1e5 && spacing != 1;  // the squares are none up to 1e-7
      const Mesh mesh = grid({.columns = 20, .rows = 20, .corner = corner, .spacing = spacing});
      const VoronoiBoxes boxes = voronoi_boxes(mesh);
      if (!rounds) CHECK(boxes.piece_triangle.size() == 3 * mesh.triangle_count());
      CHECK(certify(mesh, boxes).largest_area_defect < 1e-12);
      for (const VoronoiBox& box : boxes.boxes) {
        CHECK(box.area > 0.24 * spacing * spacing);
        CHECK(box.area < 1.01 * spacing * spacing);
      }
    }
  }
}

TEST_CASE("two-point fluxes of a linear function leave each inner box in balance") {
  for (const Point corner : {Point{0, 0}, {5e5, 4e6}}) {
    for (const double spacing : {1.0, 1e-3}) {
      CAPTURE(corner.x);
      CAPTURE(spacing);
      const Mesh mesh = grid({.columns = 12,
                              .rows = 12,
                              .corner = corner,
                              .spacing = spacing,
                              .jitter = 0.15,
                              .regions = 2});
      const VoronoiBoxes boxes = voronoi_boxes(mesh);
      REQUIRE(certify(mesh, boxes).summary() == "admissible");
      const std::vector<Point> flux = fluxes_of_coordinates(mesh, boxes);
      const std::vector<bool> on_boundary = is_on_boundary(mesh);
      for (std::size_t v = 0; v < flux.size(); ++v) {
        if (on_boundary[v]) continue;
        CHECK(std::abs(flux[v].x) < 1e-13 * spacing);
        CHECK(std::abs(flux[v].y) < 1e-13 * spacing);
      }
    }
  }
}

TEST_CASE("on an admissible mesh faces and edge factors agree") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = grid({.columns = 8, .rows = 6, .jitter = 0.15, .regions = 2, .seed = seed});
    CHECK(largest_difference_from_edge_factors(mesh, voronoi_boxes(mesh)) < 1e-13);
  }
}

TEST_CASE("the boxes fill the mesh to 1e-12, near and far, coarse and fine") {
  for (const Point corner : {Point{0, 0}, {5e5, 4e6}, {-1e7, 3}}) {
    for (const double spacing : {1e3, 1.0, 1e-3}) {
      for (unsigned seed = 1; seed <= 5; ++seed) {
        CAPTURE(corner.x);
        CAPTURE(spacing);
        CAPTURE(seed);
        const Mesh mesh = grid({.columns = 20,
                                .rows = 20,
                                .corner = corner,
                                .spacing = spacing,
                                .jitter = 0.15,
                                .regions = 4,
                                .seed = seed});
        const Certificate certificate = certify(mesh, voronoi_boxes(mesh));
        CHECK(certificate.summary() == "admissible");
        CHECK(certificate.largest_area_defect < 1e-13);
      }
    }
  }
}

TEST_CASE("the boxes of 100,000 triangles fill them to 1e-12") {
  const Mesh mesh = grid({.columns = 250,
                          .rows = 200,
                          .corner = {5e5, 4e6},
                          .spacing = 1e-3,
                          .jitter = 0.15,
                          .regions = 2});
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  CHECK(certify(mesh, boxes).summary() == "admissible");
  double sum = 0;
  for (const double area : box_areas(mesh, boxes)) sum += area;
  CHECK(sum == Approx(total_area(mesh)).epsilon(1e-12));
}
