#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "error_norms.hpp"

namespace lepp::demo {

/// Two materials, divided by the line through `foot` with unit normal `normal`; material 0 lies
/// behind it, material 1 in front.
struct TwoMaterials {
  Point foot;
  Point normal;
  std::array<double, 2> diffusion{1, 1};

  double distance(Point p) const { return dot(p - foot, normal); }
  double along(Point p) const { return cross(normal, p - foot); }
  double D(Point p) const { return diffusion[distance(p) < 0 ? 0 : 1]; }
};

/// Smooth in each material, with a kink at the interface. With s the distance to the interface and
/// t the place along it,
///   u = sin(pi s) cos(pi t) / D + cos(pi s / 2) sin(pi t):
/// the second term is the value at s = 0, and D du/dn = pi cos(pi t) there on both sides.
struct SmoothAcrossInterface {
  TwoMaterials materials;

  double value(Point p) const {
    const auto [s, t] = local(p);
    return std::sin(pi * s) * std::cos(pi * t) / materials.D(p) +
           std::cos(pi * s / 2) * std::sin(pi * t);
  }

  Point gradient(Point p) const {
    const auto [s, t] = local(p);
    const double D = materials.D(p);
    const double in_s = pi * std::cos(pi * s) * std::cos(pi * t) / D -
                        pi / 2 * std::sin(pi * s / 2) * std::sin(pi * t);
    const double in_t = -pi * std::sin(pi * s) * std::sin(pi * t) / D +
                        pi * std::cos(pi * s / 2) * std::cos(pi * t);
    const Point n = materials.normal, along{-n.y, n.x};
    return in_s * n + in_t * along;
  }

  /// f = -D laplace(u)
  double source(Point p) const {
    const auto [s, t] = local(p);
    return 2 * pi * pi * std::sin(pi * s) * std::cos(pi * t) +
           materials.D(p) * 1.25 * pi * pi * std::cos(pi * s / 2) * std::sin(pi * t);
  }

  /// D du/dn on a side with outward unit normal n.
  double flux(Point p, Point n) const { return materials.D(p) * dot(gradient(p), n); }

  ExactSolution exact() const {
    return {[*this](Point p) { return value(p); }, [*this](Point p) { return gradient(p); }};
  }

 private:
  static constexpr double pi = std::numbers::pi;
  struct Local {
    double s, t;
  };
  Local local(Point p) const { return {materials.distance(p), materials.along(p)}; }
};

/// Linear in each material, f = 0: u = s / D + t, where t is the place along the interface.
/// P1 elements and two-point fluxes reproduce it up to rounding if the interface is resolved and
/// the normal flux leaves through the boundary as `flux` says.
struct PiecewiseLinear {
  TwoMaterials materials;

  double value(Point p) const {
    return materials.distance(p) / materials.D(p) + materials.along(p);
  }
  Point gradient(Point p) const {
    const Point n = materials.normal, along{-n.y, n.x};
    return (1 / materials.D(p)) * n + along;
  }
  double flux(Point p, Point n) const { return materials.D(p) * dot(gradient(p), n); }
  ExactSolution exact() const {
    return {[*this](Point p) { return value(p); }, [*this](Point p) { return gradient(p); }};
  }
};

}  // namespace lepp::demo
