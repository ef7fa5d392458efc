#include "adaptive_problems.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "drawing.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::demo {
namespace {

constexpr double pi = std::numbers::pi;

struct Polar {
  double r, theta;  // 0 <= theta < 2 pi
};

Polar polar(Point p) {
  const double angle = std::atan2(p.y, p.x);
  return {std::hypot(p.x, p.y), angle < 0 ? angle + 2 * pi : angle};
}

/// The gradient of a function with these derivatives in r and, over r, in theta.
Point from_polar(double theta, double in_r, double in_theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return {in_r * c - in_theta * s, in_r * s + in_theta * c};
}

AdaptiveProblem problem_on(const Drawing& drawing, std::vector<CurveId> boundary,
                           std::vector<double> diffusion, const Field& source,
                           ExactSolution exact) {
  AdaptiveProblem made;
  made.start = constrained_delaunay(drawing.pslg()).mesh;
  made.problem.source.assign(diffusion.size(), source);
  made.problem.diffusion = std::move(diffusion);
  made.problem.dirichlet = {{{"boundary", std::move(boundary), {}}, exact.value}};
  made.exact = std::move(exact);
  return made;
}

AdaptiveProblem problem_on_unit_square(const std::string& name, const Field& source,
                                       ExactSolution exact) {
  Drawing draw(name);
  const VertexId a = draw.point({0, 0}), b = draw.point({1, 0}), c = draw.point({1, 1}),
                 d = draw.point({0, 1});
  const CurveId boundary = draw.curve("boundary", {a, b, c, d, a});
  draw.surface("square", {0.5, 0.25});
  return problem_on(draw, {boundary}, {1}, source, std::move(exact));
}

/// mu of kellogg(): in each quadrant a cosine, with u and D du/dn the same on both sides of the
/// axes and at the end what it was at the beginning. The constants solve the equations that say so.
struct KelloggAngular {
  static constexpr double gamma = 0.1, ratio = 161.4476387975881, rho = pi / 4,
                          sigma = -14.92256510455152;
  struct Piece {
    double factor, shift;  // factor cos((theta - shift) gamma)
  };

  static Piece piece(double theta) {
    if (theta < pi / 2) return {std::cos((pi / 2 - sigma) * gamma), pi / 2 - rho};
    if (theta < pi) return {std::cos(rho * gamma), pi - sigma};
    if (theta < 1.5 * pi) return {std::cos(sigma * gamma), pi + rho};
    return {std::cos((pi / 2 - rho) * gamma), 1.5 * pi + sigma};
  }
  static double value(double theta) {
    const auto [factor, shift] = piece(theta);
    return factor * std::cos((theta - shift) * gamma);
  }
  static double derivative(double theta) {
    const auto [factor, shift] = piece(theta);
    return -gamma * factor * std::sin((theta - shift) * gamma);
  }
};

struct Named {
  std::string_view name;
  AdaptiveProblem (*make)();
};
constexpr std::array<Named, 4> named = {
    {{"l-shape", l_shape}, {"front", arctan_front}, {"kellogg", kellogg}, {"peak", gaussian_peak}}};

}  // namespace

//     g---f---e      g (-1, 1)
//     |   |   |
//     h---c---d      c (0, 0)
//     |   |
//     a---b
AdaptiveProblem l_shape() {
  Drawing draw("the L-shape");
  const VertexId a = draw.point({-1, -1}), b = draw.point({0, -1}), c = draw.point({0, 0}),
                 d = draw.point({1, 0}), e = draw.point({1, 1}), f = draw.point({0, 1}),
                 g = draw.point({-1, 1}), h = draw.point({-1, 0});
  const CurveId boundary = draw.curve("boundary", {a, b, c, d, e, f, g, h, a});
  draw.surface("domain", {-0.5, 0.25});
  const double gamma = 2.0 / 3;
  const auto value = [=](Point p) {
    const auto [r, theta] = polar(p);
    return std::pow(r, gamma) * std::sin(gamma * theta);
  };
  const auto gradient = [=](Point p) {
    const auto [r, theta] = polar(p);
    const double slope = gamma * std::pow(r, gamma - 1);
    return from_polar(theta, slope * std::sin(gamma * theta), slope * std::cos(gamma * theta));
  };
  AdaptiveProblem made = problem_on(draw, {boundary}, {1}, {}, {value, gradient});
  made.name = "l-shape";
  made.title = "L-shape, u = r^(2/3) sin(2 theta/3)";
  made.singular = SingularPoint{{0, 0}, gamma};
  return made;
}

AdaptiveProblem arctan_front() {
  const Point center{1.25, -0.25};
  const double steep = 60, radius = pi / 3;
  const auto place = [=](Point p) {
    const Point off = p - center;
    return Polar{std::hypot(off.x, off.y), std::atan2(off.y, off.x)};
  };
  const auto value = [=](Point p) { return std::atan(steep * (place(p).r - radius)); };
  const auto slope = [=](double r) {
    return steep / (1 + steep * steep * (r - radius) * (r - radius));
  };
  const auto gradient = [=](Point p) {
    const auto [r, theta] = place(p);
    return from_polar(theta, slope(r), 0);
  };
  const auto source = [=](Point p) {  // -(u'' + u' / r)
    const double r = place(p).r, d = slope(r);
    return 2 * steep * (r - radius) * d * d - d / r;
  };
  AdaptiveProblem made = problem_on_unit_square("the front", source, {value, gradient});
  made.name = "front";
  made.first_rounds = 4;
  made.title = "Front, u = atan(60 (r - pi/3))";
  return made;
}

//     g---f---e      interfaces: the axes, with c (0, 0)
//     |   |   |
//     h---c---d      D is large in c d e f and in a b c h
//     |   |   |
//     a---b---i
AdaptiveProblem kellogg() {
  Drawing draw("the checkerboard");
  const VertexId a = draw.point({-1, -1}), b = draw.point({0, -1}), i = draw.point({1, -1}),
                 h = draw.point({-1, 0}), c = draw.point({0, 0}), d = draw.point({1, 0}),
                 g = draw.point({-1, 1}), f = draw.point({0, 1}), e = draw.point({1, 1});
  const CurveId boundary = draw.curve("boundary", {a, b, i, d, e, f, g, h, a});
  draw.curve("interface x", {h, c, d});
  draw.curve("interface y", {b, c, f});
  draw.surface("first", {0.5, 0.25});
  draw.surface("second", {-0.5, 0.25});
  draw.surface("third", {-0.5, -0.25});
  draw.surface("fourth", {0.5, -0.25});
  using Mu = KelloggAngular;
  const auto value = [](Point p) {
    const auto [r, theta] = polar(p);
    return std::pow(r, Mu::gamma) * Mu::value(theta);
  };
  const auto gradient = [](Point p) {
    const auto [r, theta] = polar(p);
    const double scale = std::pow(r, Mu::gamma - 1);
    return from_polar(theta, Mu::gamma * scale * Mu::value(theta), scale * Mu::derivative(theta));
  };
  AdaptiveProblem made =
      problem_on(draw, {boundary}, {Mu::ratio, 1, Mu::ratio, 1}, {}, {value, gradient});
  made.name = "kellogg";
  made.title = "Checkerboard of two materials, u = r^0.1 mu(theta)";
  made.singular = SingularPoint{{0, 0}, Mu::gamma};
  return made;
}

AdaptiveProblem gaussian_peak() {
  const Point center{0.5, 0.5};
  const double sharp = 1000;
  const auto value = [=](Point p) { return std::exp(-sharp * squared_distance(p, center)); };
  const auto gradient = [=](Point p) { return (-2 * sharp * value(p)) * (p - center); };
  const auto source = [=](Point p) {
    return 4 * sharp * (1 - sharp * squared_distance(p, center)) * value(p);
  };
  AdaptiveProblem made = problem_on_unit_square("the peak", source, {value, gradient});
  made.name = "peak";
  made.first_rounds = 6;
  made.title = "Peak, u = exp(-1000 r^2)";
  return made;
}

AdaptiveProblem adaptive_problem(std::string_view name) {
  for (const Named& one : named) {
    if (one.name == name) return one.make();
  }
  std::string names;
  for (const Named& one : named) names += (names.empty() ? "" : ", ") + std::string(one.name);
  throw InputError(std::string(name), "is no problem of the adaptive loop",
                   "choose one of " + names);
}

std::vector<std::string> adaptive_problem_names() {
  std::vector<std::string> names;
  for (const Named& one : named) names.emplace_back(one.name);
  return names;
}

}  // namespace lepp::demo
