#pragma once

#include <cstddef>

#include "lepp/terrain/simplify.hpp"

namespace lepp {

/// The levels of detail that one run passes, from the coarsest on: where each one ends, and what it
/// reached. A level ends at its error or at its count of vertices, whichever comes first.
class Levels {
 public:
  Levels(const HeightGrid& grid, const SimplifyOptions& options, SimplifyReport& report);

  /// The error at which the level in hand ends, and the whole run. A trifle above what was asked
  /// for: two ways of interpolating differ by as much.
  double error() const;
  double last_error() const { return raised(options_.max_error); }
  /// The number of vertices at which the level in hand ends.
  std::size_t vertices() const;

  /// Notes each level that `tin`, which is off by `error`, brings to its end.
  /// \return false if the last one has ended, or the caller said stop
  bool go_on(const Tin& tin, double error);
  bool cancelled() const { return cancelled_; }

 private:
  double raised(double error) const { return error * (1 + 1e-12) + rounding_; }
  bool is_last() const;
  void note(const Tin& tin);

  const HeightGrid& grid_;
  const SimplifyOptions& options_;
  SimplifyReport& report_;
  double rounding_;
  std::size_t next_error_ = 0, next_count_ = 0;
  bool cancelled_ = false;
};

}  // namespace lepp
