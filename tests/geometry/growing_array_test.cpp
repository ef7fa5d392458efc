#include "lepp/geometry/growing_array.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

using namespace lepp;

namespace {

using Array = GrowingArray<std::uint32_t>;

// Items 0, 1, 2, ...
void fill_up(Array& array, std::size_t size) {
  const std::size_t before = array.size();
  array.resize(size);
  for (std::size_t i = before; i < size; ++i) array[i] = static_cast<std::uint32_t>(i);
}

std::size_t wrong_items(const Array& array) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < array.size(); ++i) wrong += array[i] == i ? 0 : 1;
  return wrong;
}

}  // namespace

TEST_CASE("items stay what they are across all sizes, where blocks are moved in pages as well") {
  Array array;
  for (std::size_t size = 1; size < 3'000'000; size = 3 * size + 1) {
    CAPTURE(size);
    fill_up(array, size);
    REQUIRE(array.size() == size);
    REQUIRE(array.capacity() >= size);
    REQUIRE(wrong_items(array) == 0);
  }
  for (const std::size_t size : {1'000'000U, 300'000U, 10U, 0U}) {
    CAPTURE(size);
    array.resize(size);
    array.shrink_to_fit();
    REQUIRE(array.capacity() == size);
    REQUIRE(wrong_items(array) == 0);
  }
  fill_up(array, 5);
  CHECK(wrong_items(array) == 0);
}

TEST_CASE("room doubles at least, and smaller sizes keep it") {
  Array array;
  array.reserve(100);
  CHECK(array.capacity() == 100);
  array.resize(101);
  CHECK(array.capacity() >= 200);
  array.clear();
  CHECK(array.empty());
  CHECK(array.capacity() >= 200);
}

TEST_CASE("a random mixture of pushes and pops does what a vector does") {
  std::mt19937_64 random(31);
  Array array;
  std::vector<std::uint32_t> expected;
  for (int i = 0; i < 5000; ++i) {
    if (random() % 3 != 0 || expected.empty()) {
      expected.push_back(static_cast<std::uint32_t>(random()));
      array.push_back(expected.back());
    } else {
      expected.pop_back();
      array.pop_back();
    }
  }
  REQUIRE(std::vector(array.begin(), array.end()) == expected);
  array.push_back(7);
  for (int i = 0; i < 100; ++i) array.push_back(array[0]);  // an item of its own while it grows
  CHECK(array.back() == array[0]);
}

TEST_CASE("copies are deep, moves leave nothing behind, self-assignment changes nothing") {
  for (const std::size_t size : {100U, 1'000'000U}) {
    CAPTURE(size);
    Array array;
    fill_up(array, size);
    Array copy = array;
    copy[3] = 0;
    CHECK(wrong_items(array) == 0);
    copy = *&array;
    CHECK(wrong_items(copy) == 0);
    const Array moved = std::move(copy);
    CHECK(copy.empty());
    CHECK(moved.size() == size);
    array = *&array;
    CHECK(wrong_items(array) == 0);
  }
}

TEST_CASE("more than there can be is refused, and the array stays as it was") {
  Array array;
  fill_up(array, 10);
  CHECK_THROWS_AS(array.reserve(static_cast<std::size_t>(-1) / 2), std::bad_alloc);
  CHECK_THROWS_AS(array.reserve(std::size_t{1} << 58), std::bad_alloc);
  CHECK(array.size() == 10);
  CHECK(wrong_items(array) == 0);
}
