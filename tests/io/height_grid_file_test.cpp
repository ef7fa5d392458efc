#include <doctest/doctest.h>

#include <fstream>

#include "io/grid_texts.hpp"
#include "support/random.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

// `rows` lines of `columns` numbers: 0, 1, 2, ...
std::string counted(std::uint32_t columns, std::uint32_t rows) {
  std::string text = "ncols " + std::to_string(columns) + "\nnrows " + std::to_string(rows) +
                     "\nxllcenter 0\nyllcenter 0\ncellsize 1\n";
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    text += std::to_string(i);
    text += i % columns + 1 == columns ? '\n' : ' ';
  }
  return text;
}

bool holds_its_numbers(const HeightGrid& part, const GridWindow& window, std::uint32_t columns) {
  if (part.heights.size() != part.size()) return false;
  for (std::uint32_t row = 0; row < window.rows; ++row) {
    for (std::uint32_t column = 0; column < window.columns; ++column) {
      const double wanted = double(window.row + row) * columns + window.column + column;
      if (part.height(column, row) != wanted) return false;
    }
  }
  return true;
}

// Bytes that this process has read so far, where the system counts them.
std::uint64_t bytes_read() {
  std::ifstream in("/proc/self/io");
  std::string word;
  std::uint64_t count = 0;
  in >> word >> count;
  return word == "rchar:" ? count : 0;
}

}  // namespace

TEST_CASE("an open grid file gives the parts that its windows read alone, in any order") {
  constexpr std::uint64_t seed = 16;
  CAPTURE(seed);
  test::Random random(seed);
  const ScratchFolder folder;
  std::string floats = "F32 7 9000 nan\n", plain = "P2 7 9000 65535\n";
  std::vector<float> values;
  for (std::uint32_t i = 0; i < 63000; ++i) values.push_back(static_cast<float>(i));
  for (std::uint32_t i = 0; i < 63000; ++i)
    plain += std::to_string(i) + (i % 7 == 2 ? " # 5 6\n" : i % 7 == 6 ? "\n" : " ");
  for (const auto& path : {folder.put("a.asc", counted(7, 9000)), folder.put("a.pgm", plain),
                           folder.put("a.f32", floats + test::bytes_of_values(values, false))}) {
    CAPTURE(path.string());
    HeightGridFile file(path);
    CHECK(file.whole().rows == 9000);
    CHECK(file.whole().heights.empty());
    for (int i = 0; i < 40; ++i) {
      const std::uint32_t column = random.below(7), row = random.below(9000);
      const GridWindow window{column, row, 1 + random.below(7 - column),
                              1 + random.below(std::min(9000 - row, 50U))};
      CAPTURE(window.row);
      const HeightGrid part = file.read(window);
      CHECK(holds_its_numbers(part, window, 7));
      CHECK(part.origin == Point{double(column), double(8999 - row)});
    }
    const GridPart part = file.read_part({2, 8990, 3, 10});
    CHECK(holds_its_numbers(part.grid, {2, 8990, 3, 10}, 7));
    CHECK((part.south.empty() && part.north.size() == 5));
    CHECK(error_of<InputError>([&] { file.read({5, 0, 3, 1}); }) != "");
  }
}

TEST_CASE(
    "a text grid is passed once; later parts begin near their rows, neighbours cost nothing") {
  if (bytes_read() == 0) {
    MESSAGE("skipped: this system does not count the bytes that are read");
    return;
  }
  const ScratchFolder folder;
  const std::string text = counted(500, 2000);
  HeightGridFile file(folder.put("a.asc", text));
  const auto cost = [&](const GridWindow& window) {
    const std::uint64_t before = bytes_read();
    CHECK(holds_its_numbers(file.read(window), window, 500));
    return bytes_read() - before;
  };
  CHECK(cost({0, 0, 250, 100}) >= text.size());
  CHECK(cost({250, 0, 250, 100}) < 1000);
  CHECK(cost({0, 1900, 250, 100}) < text.size() / 4);
  CHECK(cost({250, 1900, 250, 100}) < 1000);
  CHECK(cost({0, 1000, 500, 1}) < text.size() / 4);
}

TEST_CASE("a text grid is checked to its end at the first part, and its end is missed later") {
  const ScratchFolder folder;
  std::string text = counted(7, 9000);
  const auto path = folder.put("a.asc", text + "1");
  const std::string longer = error_of<InputError>([&] { HeightGridFile(path).read({0, 0, 1, 1}); });
  CHECK(contains(longer, "holds 63001 values"));
  folder.put("a.asc", text);
  HeightGridFile file(path);
  file.read({0, 0, 1, 1});
  std::filesystem::resize_file(path, text.size() / 2);
  const std::string shorter = error_of<InputError>([&] { file.read({0, 8000, 1, 1000}); });
  CHECK(contains(shorter, "has become shorter"));
}

TEST_CASE("bands cover a window once, in order, in parts of some millions of samples") {
  for (const GridWindow& window : {GridWindow{3, 5, 10'000, 10'000}, GridWindow{0, 0, 1, 1},
                                   GridWindow{0, 1, 1U << 28, 3}, GridWindow{2, 0, 7, 1U << 28}}) {
    CAPTURE(window.columns);
    std::uint32_t next = window.row;
    for (const GridWindow& band : bands_of(window)) {
      CHECK(band.row == next);
      CHECK(band.column == window.column);
      CHECK(band.columns == window.columns);
      CHECK((band.rows == 1 || std::uint64_t{band.rows} * band.columns <= std::uint64_t{1} << 22));
      next += band.rows;
    }
    CHECK(next == window.row + window.rows);
  }
}
