#include "lepp/terrain/nonobtuse_tin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lepp/refine/refine.hpp"
#include "lepp/terrain/greedy.hpp"
#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/levels.hpp"
#include "lepp/terrain/sample_space.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/terrain/world_tin.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/locator.hpp"

namespace lepp {

namespace {

constexpr std::size_t most_rounds = 50;

// Vertices by their place in a frame: they get other numbers while a mesh is refined, but none
// moves, and so their places in grid space come back exactly.
class KnownVertices {
 public:
  struct Vertex {
    Point in_frame, in_grid;
    double height;
  };

  KnownVertices(const Mesh& in_frame, const Mesh& in_grid, const std::vector<double>& heights) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
      list_.push_back({in_frame.point(VertexId(i)), in_grid.point(VertexId(i)), heights[i]});
    }
    std::ranges::sort(list_, {}, &Vertex::in_frame);
  }
  const Vertex* at(Point in_frame) const {
    const auto found = std::ranges::lower_bound(list_, in_frame, {}, &Vertex::in_frame);
    return found == list_.end() || found->in_frame != in_frame ? nullptr : &*found;
  }

 private:
  std::vector<Vertex> list_;
};

// The frame in which angles count: the world's, if its proportions are the true ones.
class Frame {
 public:
  explicit Frame(const HeightGrid& grid) : grid_(grid) {
    const double aspect = std::abs(grid.step_y) / grid.step_x;
    is_world_ = !grid.degrees && std::abs(aspect - grid.aspect()) <= 1e-6 * aspect;
  }
  bool is_world() const { return is_world_; }
  Point from_grid(Point p) const { return is_world_ ? grid_.to_world(p) : p; }
  // Places on a column or a line of samples come back to it exactly, however much of a cell the
  // rounding of world coordinates is.
  Point to_grid(Point p) const {
    if (!is_world_) return p;
    const Point q = grid_.to_grid(p);
    const Point nearest{std::round(q.x), std::round(q.y / grid_.aspect()) * grid_.aspect()};
    const Point sample = grid_.to_world(nearest);
    return {sample.x == p.x ? nearest.x : q.x, sample.y == p.y ? nearest.y : q.y};
  }

 private:
  const HeightGrid& grid_;
  bool is_world_;
};

void move_all(Mesh& mesh, auto place) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    mesh.move_vertex(VertexId(i), place(mesh.point(VertexId(i))));
  }
}

class Work {
 public:
  Work(const HeightGrid& grid, Tin tin, const NonobtuseTinOptions& options)
      : grid_(grid),
        options_(options),
        frame_(grid),
        rounding_(frame_.is_world() ? world_rounding(grid) : 0),
        tin_(std::move(tin)) {
    const auto [low, high] = std::ranges::minmax(tin_.heights);
    most_error_ = kept_error(options.max_error, interpolation_rounding(grid)) +
                  rounding_in_world * (high - low);
  }

  NonobtuseTin run() {
    NonobtuseTin result;
    result.judged_in_world = frame_.is_world();
    if (rounding_ > same_place) cut_outline_at_samples();
    bool error_kept = false;
    do {  // ends: a round that goes on has added a sample
      refine_in_frame(result);
      ++result.rounds;
      if (!options_.keep_error || !result.goal_reached) break;
      error_kept = is_error_kept();
    } while (!error_kept && result.rounds < most_rounds && insert_samples());
    result.goal_reached = result.goal_reached && (error_kept || !options_.keep_error);
    if (!frame_.is_world()) {
      in_frame_ = tin_.mesh;
      move_all(in_frame_, [&](Point p) { return grid_.to_world(p); });
      check_orientation(in_frame_);
    }
    result.in_world = std::move(in_frame_);
    result.tin = std::move(tin_);
    return result;
  }

 private:
  void check_orientation(const Mesh& moved) const {
    if (!is_counterclockwise(moved)) throw rounding_error(grid_);
  }

  // Cuts of slanting sides are rounded, and samples on the pieces would be outside by as much: each
  // becomes a vertex.
  void cut_outline_at_samples() {
    TerrainMesh terrain(grid_, std::move(tin_));
    std::vector<TriangleId> work(terrain.mesh().triangle_count());
    for (std::size_t i = 0; i < work.size(); ++i) work[i] = TriangleId(i);
    while (!work.empty()) {  // ends: a sample becomes a vertex once
      const TriangleId t = work.back();
      const auto s = sample_on_slanting_side(terrain, t);
      if (!s || !terrain.insert(t, *s, work)) work.pop_back();
    }
    tin_ = terrain.take();
  }

  std::optional<Sample> sample_on_slanting_side(const TerrainMesh& terrain, TriangleId t) const {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!terrain.mesh().is_boundary({t, i})) continue;
      const TerrainCorner a = terrain.corner(terrain.mesh().origin({t, i}));
      const TerrainCorner b = terrain.corner(terrain.mesh().destination({t, i}));
      if (a.column == b.column || a.line == b.line) continue;
      if (const auto s = sample_between(a, b)) return s;
    }
    return std::nullopt;
  }

  static std::optional<Sample> sample_between(const TerrainCorner& a, const TerrainCorner& b) {
    const auto [low, high] = std::minmax(a.line, b.line);
    for (double line = std::floor(low) + 1; line < high; ++line) {
      const double column = a.column + (line - a.line) / (b.line - a.line) * (b.column - a.column);
      const double nearest = std::round(column);
      if (std::abs(column - nearest) > same_place) continue;
      return Sample{static_cast<std::uint32_t>(nearest), static_cast<std::uint32_t>(line)};
    }
    return std::nullopt;
  }

  // Leaves the mesh in both frames.
  void refine_in_frame(NonobtuseTin& result) {
    const Mesh in_grid = tin_.mesh;
    move_all(tin_.mesh, [&](Point p) { return frame_.from_grid(p); });
    check_orientation(tin_.mesh);
    make_delaunay(tin_.mesh);
    RefineOptions asked;
    asked.min_angle_deg = options_.min_angle_deg;
    asked.effort = Effort::fast;  // only adds vertices
    asked.max_vertices = options_.max_vertices;
    asked.progress = options_.progress;
    const KnownVertices known(tin_.mesh, in_grid, tin_.heights);
    const RefineReport refined = refine(tin_.mesh, asked);
    result.goal_reached = refined.goal_reached;
    result.unfinished = refined.unfinished;
    in_frame_ = tin_.mesh;
    move_all(tin_.mesh, [&](Point p) {
      const auto* vertex = known.at(p);
      return vertex != nullptr ? vertex->in_grid : frame_.to_grid(p);
    });
    check_orientation(tin_.mesh);
    tin_.heights.resize(tin_.mesh.vertex_count());
    for (std::size_t i = 0; i < tin_.heights.size(); ++i) {
      const auto* vertex = known.at(in_frame_.point(VertexId(i)));
      tin_.heights[i] = vertex != nullptr ? vertex->height : height_of(VertexId(i));
    }
  }

  double height_of(VertexId v) const {
    const auto on_line = height_on_hard_line(tin_, v);
    return on_line ? *on_line : height_at(grid_, tin_.mesh.point(v));
  }

  // Of the very triangles that the result has: where four corners are on a circle but for rounding,
  // those in grid space could be others.
  bool is_error_kept() const { return measure_error(grid_, tin_).elsewhere.max <= most_error_; }

  // True if there was a sample to insert.
  bool insert_samples() {
    const LargestError error = measure_error(grid_, tin_).elsewhere;
    SimplifyOptions asked;
    asked.by = SimplifyBy::greedy;
    asked.max_error = options_.max_error;
    asked.progress = options_.progress;
    if (options_.max_vertices > 0) asked.max_vertices = options_.max_vertices;
    SimplifyReport ignored;
    std::vector<double> errors;
    const std::size_t before = tin_.mesh.vertex_count();
    make_delaunay(tin_.mesh);  // but for rounding it is
    TerrainMesh terrain(grid_, std::move(tin_), rounding_);
    Levels levels(grid_, asked, ignored);
    greedy(terrain, levels, errors);
    if (terrain.mesh().vertex_count() == before) insert_worst(terrain, error);
    tin_ = terrain.take();
    return tin_.mesh.vertex_count() > before;
  }

  // Another diagonal of four corners on a circle hides what is off: the sample itself mends both.
  void insert_worst(TerrainMesh& terrain, const LargestError& error) {
    if (options_.max_vertices > 0 && terrain.mesh().vertex_count() >= options_.max_vertices) return;
    const std::uint32_t line = grid_.row_of_line(error.row);  // rows of lines: its own inverse
    const Locator locator(terrain.mesh());
    const auto place = locator.locate(grid_.sample(error.column, line));
    if (!place) return;
    std::vector<TriangleId> changed;
    terrain.insert(place->triangle, {error.column, line}, changed);
  }

  const HeightGrid& grid_;
  const NonobtuseTinOptions& options_;
  Frame frame_;
  double rounding_;  // of places in the frame, in cells
  double most_error_ = 0;
  Tin tin_;        // in grid space, but while it is refined
  Mesh in_frame_;  // the same, as refine() left it
};

}  // namespace

NonobtuseTin make_nonobtuse(const HeightGrid& grid, Tin tin, const NonobtuseTinOptions& options) {
  return Work(grid, std::move(tin), options).run();
}

}  // namespace lepp
