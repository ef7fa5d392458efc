#include "lepp/io/gmsh_curve_fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lepp;

namespace {

template <class Function>
CurveSampler sampler(Function f) {
  return [f](std::span<const double> parameters) {
    std::vector<Point> points;
    for (const double t : parameters) points.push_back(f(t));
    return points;
  };
}

template <class Function>
double deviation(const Curve& curve, Function f) {
  double most = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    most = std::max(most, std::sqrt(squared_distance(point_at(curve, t), f(t))));
  }
  return most;
}

}  // namespace

TEST_CASE("a straight run is straight, there and back is not") {
  CHECK(is_straight(fit_curve(sampler([](double t) { return Point{1 + 3 * t, 2 - t}; }))));
  CHECK(is_straight(fit_curve(sampler([](double t) { return Point{1e7 + t * t, 5e6 + t * t}; }))));
  CHECK_FALSE(is_straight(fit_curve(sampler([](double t) { return Point{t * (1 - t), 0}; }))));
}

TEST_CASE("a circle is found with its radius and sweep, closed or not") {
  for (const double sweep : {0.2, 1.5, -3.0, 2 * std::numbers::pi}) {
    CAPTURE(sweep);
    const auto f = [sweep](double t) {
      return Point{5 + 2 * std::cos(1 + t * sweep), 7 + 2 * std::sin(1 + t * sweep)};
    };
    const Curve curve = fit_curve(sampler(f));
    REQUIRE(std::holds_alternative<EllipseArc>(curve));
    CHECK(std::get<EllipseArc>(curve).sweep == doctest::Approx(sweep).epsilon(1e-11));
    CHECK(deviation(curve, f) < 1e-11);
  }
}

TEST_CASE("an ellipse is found from its eccentric angle") {
  const auto f = [](double t) {
    return Point{3 * std::cos(0.3 + 2 * t) - std::sin(0.3 + 2 * t), std::sin(0.3 + 2 * t)};
  };
  const Curve curve = fit_curve(sampler(f));
  REQUIRE(std::holds_alternative<EllipseArc>(curve));
  CHECK(deviation(curve, f) < 1e-11);
}

TEST_CASE("piecewise cubics with equal knots come back as themselves") {
  const auto f = [](double t) {  // the second derivative jumps at 1/3 and 2/3
    const auto cube_after = [t](double knot) { return std::pow(std::max(0.0, 3 * t - knot), 3); };
    return Point{3 * t, cube_after(0) - 2 * cube_after(1) + 3 * cube_after(2)};
  };
  const Curve curve = fit_curve(sampler(f));
  REQUIRE(std::holds_alternative<CubicPieces>(curve));
  CHECK(std::get<CubicPieces>(curve).pieces.size() == 3);
  CHECK(deviation(curve, f) < 1e-12);
}

TEST_CASE("any other curve is within the stated tolerance") {
  const auto f = [](double t) { return Point{4 * t, std::exp(std::sin(5 * t))}; };
  const Curve curve = fit_curve(sampler(f));
  REQUIRE(std::holds_alternative<CubicPieces>(curve));
  CHECK(deviation(curve, f) < 4 * cubic_tolerance);
}
