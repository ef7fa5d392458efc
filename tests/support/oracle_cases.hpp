#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "lepp/geometry/point.hpp"

namespace lepp::test {

/// Four points on which predicates go wrong when they are inexact. Case `seed` is one of: plain
/// random points; points on a line, on a circle or at a right angle, moved by a few ulp; the same
/// turned by the 3-4-5 angle, which rounds; far from the origin, at 1e7 and 1e15; scaled by 2^-140
/// to 2^190; each coordinate with an exponent of its own. Three of four cases are degenerate or
/// within a few ulp of it. All coordinates are in the supported range.
std::array<Point, 4> predicate_case(std::uint64_t seed);

/// Asks the library and the oracle about one case, in several orders of the points.
/// \return what differs, or nothing
std::optional<std::string> predicate_difference(std::uint64_t seed);

}  // namespace lepp::test
