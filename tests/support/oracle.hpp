#pragma once

#include "lepp/geometry/point.hpp"

namespace lepp::test {

/// Signs of the three determinants by exact integers: coordinates are brought to a common power
/// of two, then every operation is exact. Nothing is shared with the library's predicates.
/// \pre finite coordinates. Cost: 10 ns to 10 us, by the spread of the exponents.
int exact_orient2d(Point a, Point b, Point c);
int exact_incircle(Point a, Point b, Point c, Point d);
int exact_dot_sign(Point a, Point apex, Point b);

/// The same signs by rational numbers of Boost.Multiprecision, a hundred times slower: the oracle
/// of the oracle.
int rational_orient2d(Point a, Point b, Point c);
int rational_incircle(Point a, Point b, Point c, Point d);
int rational_dot_sign(Point a, Point apex, Point b);

/// The same signs, by doubles where their error bound allows it, else exactly.
/// \pre coordinates in the supported range of pslg.hpp
int oracle_orient2d(Point a, Point b, Point c);
int oracle_incircle(Point a, Point b, Point c, Point d);
int oracle_dot_sign(Point a, Point apex, Point b);

}  // namespace lepp::test
