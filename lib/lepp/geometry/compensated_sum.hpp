#pragma once

#include <cmath>

namespace lepp {

/// A sum of doubles that keeps the low parts each addition drops, so its error does not grow with
/// the number of terms.  Source [neumaier1974]
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    dropped_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + dropped_; }

 private:
  double sum_ = 0;
  double dropped_ = 0;
};

}  // namespace lepp
