#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "lepp/io/height_grid_read.hpp"
#include "pipeline/program.hpp"

namespace lepp::test {

inline std::string hill() {
  return quoted(std::filesystem::path(LEPP_MESHES) / "terrain" / "hill.asc");
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

using Place = std::array<double, 3>;

/// A TIN as its .obj file has it.
struct ObjTin {
  std::vector<Place> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
};

inline ObjTin read_obj(const std::filesystem::path& file) {
  std::ifstream in(file);
  ObjTin tin;
  for (std::string kind; in >> kind;) {
    if (kind == "v") {
      auto& [x, y, z] = tin.vertices.emplace_back();
      in >> x >> y >> z;
    } else if (kind == "f") {
      auto& [a, b, c] = tin.triangles.emplace_back();
      in >> a >> b >> c;
    } else {
      std::getline(in, kind);
    }
  }
  return tin;
}

struct Found {
  double error = 0;
  std::size_t outside = 0, covered = 0;
};

/// The largest error, sample by sample and triangle by triangle, in world coordinates.
inline Found measured(const ObjTin& tin, const HeightGrid& grid) {
  Found found;
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const Point p{grid.origin.x + column * grid.step_x, grid.origin.y + row * grid.step_y};
      bool is_inside = false;
      for (const auto& [i, j, k] : tin.triangles) {
        const Place &a = tin.vertices[i - 1], &b = tin.vertices[j - 1], &c = tin.vertices[k - 1];
        const auto area = [](const Place& u, const Place& v, double x, double y) {
          return (v[0] - u[0]) * (y - u[1]) - (v[1] - u[1]) * (x - u[0]);
        };
        const double whole = area(a, b, c[0], c[1]);
        const double wa = area(b, c, p.x, p.y) / whole, wb = area(c, a, p.x, p.y) / whole;
        if (std::min({wa, wb, 1 - wa - wb}) < -1e-9) continue;
        is_inside = true;
        if (!grid.has_data(column, row)) break;
        const double height = wa * a[2] + wb * b[2] + (1 - wa - wb) * c[2];
        found.error = std::max(found.error, std::abs(height - grid.height(column, row)));
      }
      if (grid.has_data(column, row) && !is_inside) ++found.outside;
      if (!grid.has_data(column, row) && is_inside) ++found.covered;
    }
  }
  return found;
}

inline HeightGrid hill_grid() {
  return read_height_grid(std::filesystem::path(LEPP_MESHES) / "terrain" / "hill.asc");
}

/// The vertices with x or y of a place.
inline std::set<Place> on_line(const ObjTin& tin, std::size_t axis, double at) {
  std::set<Place> places;
  for (const Place& v : tin.vertices) {
    if (v[axis] == at) places.insert(v);
  }
  return places;
}

}  // namespace lepp::test
