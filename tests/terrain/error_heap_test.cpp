#include "lepp/terrain/error_heap.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "support/random.hpp"

using namespace lepp;

TEST_CASE("ErrorHeap: the top is the worst triangle above the limit, of equals the lowest id") {
  constexpr std::uint64_t seed = 5;
  CAPTURE(seed);
  test::Random random(seed);
  constexpr double limit = 3;
  ErrorHeap heap(limit);
  std::vector<double> errors;
  for (int step = 0; step < 2000; ++step) {
    const std::size_t t = random.below(40);
    if (errors.size() <= t) errors.resize(t + 1, 0);
    errors[t] = random.below(10);
    heap.set(TriangleId(t), errors[t]);
    std::size_t worst = 0, above = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      above += errors[i] > limit ? 1 : 0;
      if (errors[i] > errors[worst]) worst = i;
    }
    REQUIRE(heap.size() == above);
    REQUIRE(heap.top().has_value() == (above > 0));
    if (above == 0) continue;
    REQUIRE(heap.top() == TriangleId(worst));
    REQUIRE(heap.top_error() == errors[worst]);
  }
}
