#include "group_options.hpp"

#include <doctest/doctest.h>

#include "../support/hand_made.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "linear_expression.hpp"
#include "two_materials.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

Mesh two_materials() { return constrained_delaunay(test::two_materials_pslg()).mesh; }

void check_refused(const GroupOptions& options, const char* part_of_message) {
  CAPTURE(part_of_message);
  CHECK_THROWS_WITH_AS(problem_from(options, two_materials()), doctest::Contains(part_of_message),
                       InputError);
}

}  // namespace

TEST_CASE("values reach the surfaces and curves of their group, by name or by tag") {
  const Mesh mesh = two_materials();
  const PoissonProblem problem = problem_from({.diffusion = {"soft=2", "2=30"},
                                               .source = {"hard=1+x"},
                                               .dirichlet = {"left=0", "right=1-2*y"},
                                               .neumann = {"1=4"},
                                               .robin = {"above=10,300"}},
                                              mesh);
  CHECK(problem.diffusion == std::vector<double>{2, 30});
  CHECK_FALSE(problem.source[0]);
  CHECK(problem.source[1]({3, 0}) == 4);
  REQUIRE(problem.dirichlet.size() == 2);
  CHECK(problem.dirichlet[1].value({0, 3}) == -5);
  CHECK(edges_of(mesh, problem.dirichlet[0].part).size() == 1);
  CHECK(edges_of(mesh, problem.neumann[0].part).size() == 2);  // the interface ends there
  CHECK(problem.robin[0].alpha == 10);
  CHECK(problem.robin[0].outside({0, 0}) == 300);
}

TEST_CASE("without any --diffusion, D is 1 everywhere") {
  CHECK(problem_from({}, two_materials()).diffusion == std::vector<double>{1, 1});
}

TEST_CASE("a group that is not there is refused, and those that are there are listed") {
  check_refused({.dirichlet = {"lefft=0"}}, "there is no group of curves \"lefft\"");
  check_refused({.dirichlet = {"lefft=0"}}, "1 \"below\", 2 \"right\"");
  check_refused({.neumann = {"soft=0"}}, "there is no group of curves \"soft\"");
  check_refused({.robin = {"nowhere=1,0"}}, "nowhere");
  check_refused({.source = {"left=0"}}, "there is no group of surfaces \"left\"");
  check_refused({.source = {"left=0"}}, "1 \"soft\", 2 \"hard\"");
  check_refused({.diffusion = {"9=0.5"}}, "there is no group of surfaces \"9\"");
}

TEST_CASE("a surface without D, or with two, is named") {
  check_refused({.diffusion = {"soft=1"}}, "is missing for surface 2, group \"hard\"");
  check_refused({.diffusion = {"soft=1", "soft=2", "hard=1"}}, "already has a diffusion");
  check_refused({.source = {"soft=1", "1=2"}}, "already has a source");
}

TEST_CASE("a group with two Dirichlet values is refused, whether by name or by tag") {
  check_refused({.dirichlet = {"left=0", "right=1", "left=2"}}, "--dirichlet left=2: this group");
  check_refused({.dirichlet = {"right=0", "2=1"}}, "already has a value, by --dirichlet right");
}

TEST_CASE("the form of options is checked without a mesh") {
  CHECK_NOTHROW(check_form({.diffusion = {"any=1"}, .robin = {"any=1,x"}}));
  for (const GroupOptions& wrong :
       {GroupOptions{.diffusion = {"any=0"}}, GroupOptions{.source = {"any"}},
        GroupOptions{.dirichlet = {"any=z"}}, GroupOptions{.neumann = {"=1"}},
        GroupOptions{.robin = {"any=1"}}}) {
    CHECK_THROWS_AS(check_form(wrong), InputError);
  }
}

TEST_CASE("values that cannot be read are refused with what was typed") {
  check_refused({.dirichlet = {"left"}}, "--dirichlet left: is not of the form GROUP=VALUE");
  check_refused({.dirichlet = {"left="}}, "GROUP=VALUE");
  check_refused({.dirichlet = {"=1"}}, "GROUP=VALUE");
  check_refused({.dirichlet = {"left=sin(x)"}}, "\"sin(x)\"");
  check_refused({.diffusion = {"soft=-1"}}, "no positive number");
  check_refused({.diffusion = {"soft=0"}}, "no positive number");
  check_refused({.diffusion = {"soft=1+x"}}, "no positive number");
  check_refused({.robin = {"left=3"}}, "GROUP=ALPHA,V");
  check_refused({.robin = {"left=-3,1"}}, "no positive number");
  check_refused({.robin = {"left=3,"}}, "no sum");
}

TEST_CASE("a mesh without groups is addressed by its tags") {
  const Mesh mesh = test::grid({.columns = 4, .rows = 2, .regions = 2});  // surfaces 1 and 2
  CHECK(problem_from({.diffusion = {"1=5", "2=7"}}, mesh).diffusion == std::vector<double>{5, 7});
  CHECK_THROWS_WITH_AS(problem_from({.diffusion = {"3=5"}}, mesh),
                       doctest::Contains("use one of the tags: 1, 2"), InputError);
}

TEST_CASE("linear expressions are read to the last character") {
  const auto value = [](const char* text) { return parse_linear(text)->operator()({10, 100}); };
  CHECK(value("3") == 3);
  CHECK(value("-3.5") == -3.5);
  CHECK(value("x") == 10);
  CHECK(value("-y") == -100);
  CHECK(value("1+2*x-0.5*y") == -29);
  CHECK(value("1e-1*x+1E2") == 101);
  for (const char* wrong : {"", "-", "+1", "1+", "1-+2", "2x", "x*2", "2*", "2*z", "1 + x", "nan",
                            "inf", "1e999", "0x10", "1,5", "--1", "x y"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_linear(wrong).has_value());
  }
  CHECK(parse_number("-2.5") == -2.5);
  CHECK_FALSE(parse_number("2.5 ").has_value());
  CHECK_FALSE(parse_number("x").has_value());
}
