#include "lepp/io/plot.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::ScratchFolder;

TEST_CASE("a plot has a mark per point, a legend and the reference slopes") {
  const ScratchFolder folder;
  LogLogPlot plot{"Errors & orders", "h", "error", {}, {{2, "slope 2"}}};
  plot.series = {{"FE", {0.4, 0.2, 0.1}, {1e-2, 2.5e-3, 6e-4}}, {"FV", {0.4, 0.2}, {2e-2, 0}}};
  write_plot(plot, folder / "a.svg");
  const std::string text = folder.text("a.svg");
  std::size_t marks = 0;
  for (auto at = text.find("<circle"); at != std::string::npos; at = text.find("<circle", at + 1)) {
    ++marks;
  }
  CHECK(marks == 4 + 2);  // the error of 0 has no logarithm; one more per line of the legend
  CHECK(contains(text, "Errors &amp; orders"));
  CHECK(contains(text, ">FV</text>"));
  CHECK(contains(text, ">slope 2</text>"));
  CHECK(contains(text, "transform=\"rotate(-90)"));  // the label of y is clear of a long title
  CHECK(contains(text, "stroke-dasharray"));
  CHECK_FALSE(contains(text, "nan"));
  CHECK_FALSE(contains(text, "inf"));
}

TEST_CASE("a plot of one point, or of equal values, still has axes") {
  const ScratchFolder folder;
  write_plot({"", "h", "e", {{"a", {0.1}, {0.5}}}, {{1, "slope 1"}}}, folder / "a.svg");
  write_plot({"", "h", "e", {{"a", {0.1, 0.2}, {0.5, 0.5}}}, {}}, folder / "b.svg");
  for (const char* name : {"a.svg", "b.svg"}) {
    CHECK_FALSE(contains(folder.text(name), "nan"));
    CHECK(contains(folder.text(name), "<circle"));
  }
}

TEST_CASE("nothing to draw is an error and leaves no file") {
  const ScratchFolder folder;
  CHECK(contains(test::error_of<InputError>([&] {
                   write_plot({"", "h", "e", {{"a", {0.1, -1}, {0, 1}}}, {}}, folder / "a.svg");
                 }),
                 "the axes are logarithmic"));
  CHECK(folder.names().empty());
}
