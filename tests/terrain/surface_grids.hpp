#pragma once

#include <doctest/doctest.h>

#include "lepp/terrain/validate_surface.hpp"
#include "lepp/triangulation/validate.hpp"
#include "terrain/hills.hpp"

namespace lepp::test {

/// Hills as high as the grid is wide.
inline HeightGrid steep_hills(std::uint32_t columns, std::uint32_t rows) {
  return grid_of(columns, rows, [&](double x, double y) { return columns * hill(x, y) / 150; });
}

/// Cliffs, spikes and noise, some of them twice as high as the grid is wide.
inline HeightGrid wild(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
  Random random(seed);
  return grid_of(columns, rows, [&](double x, double y) {
    const double spike = random.below(40) == 0 ? 2.0 * columns : 0;
    return columns * (x > y ? 1.0 : 0.0) + spike + static_cast<double>(random.below(9));
  });
}

inline void check_surface(const HeightGrid& grid, const Tin& tin, const SimplifyReport& report,
                          double plan_angle_deg = 15) {
  MeshClaims claims;
  claims.delaunay = false;
  claims.min_angle_deg = plan_angle_deg;
  claims.unfinished = report.unfinished;
  CHECK(validate(tin.mesh, claims).summary() == "valid");
  CHECK(validate_surface(
            grid, tin,
            {report.surface.bound, report.surface.plan_angle_deg, report.surface.violations})
            .summary() == "valid");
}

}  // namespace lepp::test
