#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lepp {

/// An exact real number as an unevaluated sum of doubles that do not overlap, smallest first,
/// zeros left out. Source [shewchuk1997]: two-sum, two-product, fast-expansion-sum,
/// scale-expansion. Needs round-to-nearest, no contraction, and no over- or underflow.
template <std::size_t Capacity>
class Expansion {
 public:
  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0 ? 1 : -1); }
  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return terms_[i]; }
  void append(double term) {
    if (term != 0) terms_[size_++] = term;
  }

 private:
  std::array<double, Capacity> terms_;
  std::size_t size_ = 0;
};

/// A rounded result and what rounding lost.
struct RoundedPair {
  double value, error;
};

inline RoundedPair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// \pre |a| >= |b|
inline RoundedPair fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

inline RoundedPair two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// a - b, exactly.
inline Expansion<2> difference(double a, double b) {
  const RoundedPair d = two_sum(a, -b);
  Expansion<2> e;
  e.append(d.error);
  e.append(d.value);
  return e;
}

/// e + f: merge by magnitude, then one pass that pushes the rounding errors down.
template <std::size_t M, std::size_t N>
Expansion<M + N> operator+(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<M + N> sum;
  std::size_t i = 0, j = 0;
  const auto smaller = [&] {
    if (j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]))) return e[i++];
    return f[j++];
  };
  const std::size_t count = e.size() + f.size();
  if (count == 0) return sum;
  double running = smaller();
  for (std::size_t k = 1; k < count; ++k) {
    const RoundedPair next = two_sum(running, smaller());
    sum.append(next.error);
    running = next.value;
  }
  sum.append(running);
  return sum;
}

template <std::size_t N>
Expansion<N> operator-(const Expansion<N>& e) {
  Expansion<N> negated;
  for (std::size_t i = 0; i < e.size(); ++i) negated.append(-e[i]);
  return negated;
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator-(const Expansion<M>& e, const Expansion<N>& f) {
  return e + (-f);
}

/// e * b for one double b.
template <std::size_t N>
Expansion<2 * N> scale(const Expansion<N>& e, double b) {
  Expansion<2 * N> product;
  if (e.size() == 0) return product;
  const RoundedPair first = two_product(e[0], b);
  product.append(first.error);
  double running = first.value;
  for (std::size_t i = 1; i < e.size(); ++i) {
    const RoundedPair term = two_product(e[i], b);
    const RoundedPair low = two_sum(running, term.error);
    product.append(low.error);
    const RoundedPair high = fast_two_sum(term.value, low.value);
    product.append(high.error);
    running = high.value;
  }
  product.append(running);
  return product;
}

/// e * f: f scaled by each term of e, summed in pairs of growing length by the caller's loop.
template <std::size_t M, std::size_t N>
Expansion<2 * M * N> operator*(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<2 * M * N> product;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const auto grown = product + scale(f, e[i]);
    product = {};
    for (std::size_t k = 0; k < grown.size(); ++k) product.append(grown[k]);
  }
  return product;
}

}  // namespace lepp
