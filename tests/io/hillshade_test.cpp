#include "lepp/io/hillshade.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "io/scratch_folder.hpp"
#include "lepp/io/png.hpp"
#include "support/hand_made.hpp"

using namespace lepp;
using test::contains;
using test::ScratchFolder;

namespace {

// A roof: ridge from south to north, slopes to the west and to the east, 45 degrees steep.
//
//   3 - 4 - 5
//   |   |   |     heights 0, 10, 0 in cells of 10
//   0 - 1 - 2
Tin roof() {
  return {test::from_triangles({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}},
                               {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}),
          {0, 10, 0, 0, 10, 0}};
}

int brightness(const Color& c) { return std::accumulate(c.begin(), c.end(), 0); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// The bytes of the pixels of a PNG with stored blocks.
std::string pixels_of(const std::string& png) {
  const std::size_t data = png.find("IDAT") + 4;
  std::string result;
  std::size_t at = data + 2;
  for (bool last = false; !last;) {
    last = png[at] == 1;
    const auto length = static_cast<std::size_t>(static_cast<unsigned char>(png[at + 1])) +
                        256 * static_cast<std::size_t>(static_cast<unsigned char>(png[at + 2]));
    result += png.substr(at + 5, length);
    at += 5 + length;
  }
  return result;
}

}  // namespace

TEST_CASE("the light comes from the north-west: western slopes are brighter than eastern ones") {
  const Tin tin = roof();
  const Hillshade shade(tin, 10);
  CHECK(shade.exaggeration() == 1);
  const TriangleId west(0U), east(2U);
  CHECK(brightness(shade(west)) > brightness(shade(east)) + 100);
}

TEST_CASE("heights of flat land are stretched until slopes show, those of steep land are not") {
  Tin tin = roof();
  for (double& h : tin.heights) h /= 100;
  CHECK(Hillshade(tin, 10).exaggeration() == doctest::Approx(40));
  for (double& h : tin.heights) h = 3;
  CHECK(Hillshade(tin, 10).exaggeration() == 1);
}

TEST_CASE("tints go by the heights given: a part of a land has the colours of the whole") {
  const Tin tin = roof();
  const auto [low, high] = std::ranges::minmax(tin.heights);
  const Hillshade own(tin, 10), same(tin, 10, {{low, high}}), part(tin, 10, {{low, 9 * high}});
  bool differs = false;
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    CHECK(own(TriangleId(i)) == same(TriangleId(i)));
    differs = differs || own(TriangleId(i)) != part(TriangleId(i));
  }
  CHECK(differs);
}

TEST_CASE("SVG: a polygon per triangle, edges where they can be seen or are asked for") {
  const ScratchFolder folder;
  write_hillshade(roof(), folder / "a.svg", {.width = 100, .cell_width = 10, .edges = {}});
  const std::string text = folder.text("a.svg");
  CHECK(text.starts_with("<svg "));
  CHECK(text.ends_with("</svg>\n"));
  CHECK(count(text, "Z\"/>") == 4);
  CHECK(count(text, "M") == 4 + 9 + 0 + 6);  // triangles, edges, lines inside, boundary
  write_hillshade(roof(), folder / "b.svg", {.width = 100, .cell_width = 10, .edges = false});
  CHECK(count(folder.text("b.svg"), "M") == 4 + 6);
}

TEST_CASE("PNG: the size asked for, western half brighter than the eastern one") {
  const ScratchFolder folder;
  write_hillshade(roof(), folder / "a.png", {.width = 20, .cell_width = 10, .edges = false});
  const std::string pixels = pixels_of(folder.text("a.png"));
  REQUIRE(pixels.size() == 10 * (1 + 3 * 20));  // rows of 20 pixels behind their filter
  const auto pixel = [&](std::size_t x, std::size_t y) {
    int sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += static_cast<unsigned char>(pixels[y * 61 + 1 + 3 * x + k]);
    }
    return sum;
  };
  CHECK(pixel(5, 5) > pixel(15, 5) + 100);
  CHECK(pixel(8, 7) == pixel(6, 6));
}

TEST_CASE("PNG, byte for byte") {
  const ScratchFolder folder;
  const std::uint8_t red_green[] = {255, 0, 0, 0, 128, 0};
  write_png(folder / "a.png", 2, 1, red_green);
  const std::string wanted(
      "\x89PNG\r\n\x1A\n"
      "\0\0\0\x0DIHDR\0\0\0\x02\0\0\0\x01\x08\x02\0\0\0\x7B\x40\xE8\xDD"
      "\0\0\0\x12IDAT\x78\x01\x01\x07\0\xF8\xFF\0\xFF\0\0\0\x80\0",
      8 + 25 + 8 + 14);
  CHECK(folder.text("a.png").substr(0, wanted.size()) == wanted);
  CHECK(folder.text("a.png").ends_with(std::string("\0\0\0\0IEND\xAE\x42\x60\x82", 12)));
}
