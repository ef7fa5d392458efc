#include "terrain_tiles.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "commands.hpp"
#include "interrupt.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/hillshade.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"

namespace lepp::cli {

namespace {

namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Where a part of n samples begins, of so many parts that share their ends.
std::uint32_t begin_of(std::uint32_t part, std::uint32_t parts, std::uint32_t n) {
  return static_cast<std::uint32_t>(std::uint64_t{part} * (n - 1) / parts);
}

GridWindow window_of(const HeightGrid& whole, const TileCounts& tiles, std::uint32_t row,
                     std::uint32_t column) {
  GridWindow window;
  window.row = begin_of(row, tiles.rows, whole.rows);
  window.column = begin_of(column, tiles.columns, whole.columns);
  window.rows = begin_of(row + 1, tiles.rows, whole.rows) - window.row + 1;
  window.columns = begin_of(column + 1, tiles.columns, whole.columns) - window.column + 1;
  return window;
}

std::vector<bool> on_boundary(const Mesh& mesh) {
  std::vector<bool> result(mesh.vertex_count(), false);
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      if (!mesh.is_boundary(e)) continue;
      result[mesh.origin(e).index()] = result[mesh.destination(e).index()] = true;
    }
  }
  return result;
}

// Tiles put together; vertices on the lines that they share become one.
class JoinedTin {
 public:
  void add(const WorldTin& tile) {
    const std::vector<bool> may_be_shared = on_boundary(tile.mesh);
    std::vector<VertexId> ids;
    for (std::size_t i = 0; i < tile.mesh.vertex_count(); ++i) {
      const VertexId next(soup_.points.size());
      const Point p = tile.mesh.point(VertexId(i));
      const VertexId id = may_be_shared[i] ? at_.emplace(p, next).first->second : next;
      ids.push_back(id);
      if (id != next) continue;
      soup_.points.push_back(p);
      heights_.push_back(tile.heights[i]);
    }
    for (const Triangle& t : tile.mesh.triangles()) {
      const auto& [a, b, c] = t.vertices;
      soup_.triangles.push_back({ids[a.index()], ids[b.index()], ids[c.index()]});
    }
  }

  WorldTin join(const HeightGrid& grid) {
    soup_.source = grid.source;
    WorldTin world = to_world({}, grid);  // its names
    world.mesh = mesh_from_triangles(soup_).mesh;
    world.heights = std::move(heights_);
    return world;
  }

 private:
  TriangleSoup soup_;
  std::vector<double> heights_;
  std::map<Point, VertexId> at_;
};

class Tiles {
 public:
  Tiles(const TerrainCommand& command, TerrainReport& report)
      : command_(command),
        report_(report),
        counts_(command.tile_counts()),
        file_(command.input, command.grid_options()),
        whole_(file_.whole()) {
    if (counts_.rows >= whole_.rows || counts_.columns >= whole_.columns) {
      throw InputError(command.input.string() + ", --tiles " + command.tiles,
                       "asks for more tiles than the " + std::to_string(whole_.rows) + " x " +
                           std::to_string(whole_.columns) + " samples have cells",
                       "give fewer rows and columns of tiles");
    }
    const double range = command.is_relative() ? range_of_heights() : 0;
    job_.simplify = simplify_options(command, range);
    job_.border_error = border_error(command, range);
  }

  int run() {
    for (std::uint32_t row = 0; row < counts_.rows; ++row) {
      for (std::uint32_t column = 0; column < counts_.columns; ++column) {
        const int status = run_tile(row, column);
        if (status != done) return status;
      }
    }
    if (report_.tiles.empty()) {
      throw InputError(command_.input.string(), "has no sample with data",
                       "check the value that means no data");
    }
    const int status = command_.tile_output == TileOutput::files ? done : write_joined();
    return status == done && !report_.goal_reached ? unfinished : status;
  }

 private:
  // A pass over the file.
  double range_of_heights() {
    double low = INFINITY, high = -INFINITY;
    for (const GridWindow& band : bands_of({0, 0, whole_.columns, whole_.rows})) {
      TerrainReport part;
      describe(file_.read(band), part);
      if (part.samples == 0) continue;
      low = std::min(low, part.lowest);
      high = std::max(high, part.highest);
    }
    return low <= high ? high - low : 0;
  }

  int run_tile(std::uint32_t row, std::uint32_t column) {
    const GridWindow window = window_of(whole_, counts_, row, column);
    const auto start = std::chrono::steady_clock::now();
    GridPart part = file_.read_part(window);
    report_.seconds.read += seconds_since(start);
    if (!part.grid.has_any_data()) return done;
    job_.border_corners = border_corners(part);
    leave_to_neighbours(part);
    const HeightGrid& grid = part.grid;
    if (!grid.has_any_data()) return done;
    MadeTerrain made = make_terrain(grid, {whole_, window.column, window.row}, job_);
    made.finest.figures.name = "tile " + std::to_string(row) + " " + std::to_string(column);
    add_to(report_, made.report);
    if (interrupted()) return refused;
    if (!made.report.valid) return bug;
    if (!made.report.goal_reached && !command_.allow_unfinished) return unfinished;
    const auto writing = std::chrono::steady_clock::now();
    write_tile(made, grid, tile_suffix(row, column));
    report_.seconds.write += seconds_since(writing);
    report_.tiles.push_back(made.finest.figures);
    return done;
  }

  void write_tile(MadeTerrain& made, const HeightGrid& grid, const std::string& suffix) {
    const fs::path target = with_suffix(command_.output.target, suffix);
    if (command_.tile_output != TileOutput::mesh) {
      made.finest.figures.output = target.string();
      write_tin(made.finest.world, target, command_.tin_format());
      for (std::size_t i = 0; i < made.coarser.size(); ++i) {
        write_tin(made.coarser[i].world, with_suffix(target, level_suffix(i + 1)),
                  command_.tin_format());
      }
    }
    if (command_.tile_output != TileOutput::files) joined_.add(made.finest.world);
    if (command_.picture.empty()) return;
    HillshadeOptions options;
    options.width = command_.picture_width;
    options.cell_width = grid.cell_width;
    write_hillshade(made.finest.tin, with_suffix(command_.picture, suffix), options);
  }

  int write_joined() {
    const WorldTin world = joined_.join(whole_);
    const MeshReport checked = validate(world.mesh, {.delaunay = false});
    report_.whole.vertices = world.mesh.vertex_count();
    report_.violations.insert(report_.violations.end(), checked.violations.begin(),
                              checked.violations.end());
    report_.valid = report_.valid && checked.valid();
    if (!checked.valid()) return bug;
    write_tin(world, command_.output.target, command_.tin_format());
    report_.whole.output = command_.output.target.string();
    return done;
  }

  const TerrainCommand& command_;
  TerrainReport& report_;
  TileCounts counts_;
  HeightGridFile file_;
  const HeightGrid& whole_;  // without heights
  TerrainJob job_;
  JoinedTin joined_;
};

}  // namespace

int run_tiles(const TerrainCommand& command, TerrainReport& report) {
  return Tiles(command, report).run();
}

}  // namespace lepp::cli
