#include "lepp/io/tin_files.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "io/small_tins.hpp"
#include "lepp/geometry/error.hpp"
#include "support/hand_made.hpp"

using namespace lepp;
using test::Bytes;
using test::contains;
using test::error_of;
using test::ring;
using test::ScratchFolder;
using test::small_tin;
using test::utm;

namespace {

// A record of a Fortran file, whose length stands before and after it.
template <class Number>
std::vector<Number> record(Bytes& bytes) {
  const auto length = bytes.next<std::int32_t>();
  std::vector<Number> numbers(static_cast<std::size_t>(length) / sizeof(Number));
  for (Number& n : numbers) n = bytes.next<Number>();
  CHECK(bytes.next<std::int32_t>() == length);
  return numbers;
}

std::string text_record(Bytes& bytes) {
  const auto characters = record<char>(bytes);
  return {characters.begin(), characters.end()};
}

}  // namespace

TEST_CASE("single-precision Selafin refuses what its 32 bits cannot hold") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  tin.mesh = test::two_triangles({1e10, 0}, {1e10 + 1, 0}, {1e10 + 1, 1}, {1e10, 1});
  CHECK_THROWS_AS(write_selafin(tin, folder / "a.slf", SelafinPrecision::floats), RefusedError);
  tin.mesh = test::two_triangles({0, 0}, {1e8, 0}, {1e8, 1e8}, {1e8 - 1, 1e8});
  CHECK_THROWS_AS(write_selafin(tin, folder / "a.slf", SelafinPrecision::floats), InputError);
  CHECK_FALSE(std::filesystem::exists(folder / "a.slf"));
}

TEST_CASE("Selafin: big-endian records, in doubles as they are") {
  const ScratchFolder folder;
  write_selafin(ring({500000.25, 4100000.75}), folder / "a.slf");
  Bytes bytes(folder.text("a.slf"), std::endian::big);
  CHECK(text_record(bytes) == "ring" + std::string(68, ' ') + "SERAFIND");
  CHECK(record<std::int32_t>(bytes) == std::vector{1, 0});
  CHECK(text_record(bytes) == "BOTTOM          M               ");
  CHECK(record<std::int32_t>(bytes) == std::vector{1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(record<std::int32_t>(bytes) == std::vector{8, 8, 3, 1});
  const auto corners = record<std::int32_t>(bytes);
  CHECK(corners.size() == 24);
  CHECK(std::vector(corners.begin(), corners.begin() + 6) == std::vector{1, 2, 5, 2, 6, 5});
  CHECK(record<std::int32_t>(bytes) == std::vector{1, 2, 3, 4, 6, 5, 8, 7});
  CHECK(record<double>(bytes)[1] == 500003.25);
  CHECK(record<double>(bytes)[2] == 4100003.75);
  CHECK(record<double>(bytes) == std::vector<double>{0});
  CHECK(record<double>(bytes) == std::vector<double>(8, 10));
  CHECK(bytes.at_end());
}

TEST_CASE("Selafin in floats stores the corner that it subtracts") {
  const ScratchFolder folder;
  write_selafin(ring({500000.25, 4100000.75}), folder / "a.slf", SelafinPrecision::floats);
  Bytes bytes(folder.text("a.slf"), std::endian::big);
  CHECK(text_record(bytes).ends_with("SERAFIN "));
  for (int i = 0; i < 2; ++i) record<char>(bytes);
  CHECK(record<std::int32_t>(bytes) == std::vector{1, 0, 500000, 4100000, 0, 0, 0, 0, 0, 0});
  for (int i = 0; i < 3; ++i) record<std::int32_t>(bytes);
  CHECK(record<float>(bytes)[1] == 3.25f);
  CHECK(record<float>(bytes)[2] == 3.75f);
}

TEST_CASE("offsets beyond whole numbers: Selafin in floats refuses them, STL writes their digits") {
  const ScratchFolder folder;
  for (const Point corner : {Point{3e9, 0}, Point{0, -3e9}}) {
    CAPTURE(corner.x);
    const std::string message = error_of<RefusedError>(
        [&] { write_selafin(ring(corner), folder / "a.slf", SelafinPrecision::floats); });
    CHECK(contains(message, "serafind"));
    CHECK(folder.names().empty());
  }
  WorldTin tin = small_tin();
  tin.mesh = test::two_triangles({1e20, 0}, {1e20 + 1e18, 0}, {1e20 + 1e18, 1e18}, {1e20, 1e18});
  write_stl(tin, folder / "a.stl");
  CHECK(contains(folder.text("a.stl"), "add 1e+20 to x, 0 to y"));
}
