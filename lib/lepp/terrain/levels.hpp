#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lepp/terrain/simplify.hpp"

namespace lepp {

/// The levels of detail that one run passes, from the coarsest on: where each one ends, and what it
/// reached. A level ends at its error or at its count of vertices, whichever comes first. A TIN
/// that reaches several at once is noted for each, the last one included, so that level i is there
/// whatever the ground is like: tiles can be joined level by level.
class Levels {
 public:
  Levels(const HeightGrid& grid, const SimplifyOptions& options, SimplifyReport& report);

  /// The error at which the level in hand ends, and the whole run: interpolation_rounding()
  /// above what was asked for.
  double error() const;
  double last_error() const { return raised(options_.max_error); }
  /// True if a TIN with this error is what the run was asked for.
  bool is_kept(double error) const { return error <= kept_error(options_.max_error, rounding_); }
  /// The number of vertices at which the level in hand ends.
  std::size_t vertices() const;

  /// True if a TIN that is off by `error` has reached where the level in hand ends.
  bool has_ended(const Tin& tin, double error) const;
  /// Ends the level in hand with `tin`, whether or not it got there.
  /// \param unfinished  its triangles below the angle bound
  /// \return false if that was the last one
  bool next(const Tin& tin, double error, std::vector<Unfinished> unfinished = {});
  /// Asks the caller whether to go on; once false, it stays so.
  bool ask(std::size_t vertices) {
    if (!cancelled_ && options_.progress) cancelled_ = !options_.progress(vertices);
    return !cancelled_;
  }
  bool ask_now_and_then(std::size_t vertices) {
    constexpr std::size_t turns = 1024;
    return ++turns_ % turns == 0 ? ask(vertices) : !cancelled_;
  }

 private:
  double raised(double error) const { return error * (1 + 1e-12) + rounding_; }
  // Goes on to the first level that is not reached. Returns the counts asked for of those that it
  // passes, nothing where it was an error.
  std::vector<std::optional<std::size_t>> pass(double error, std::size_t count, bool is_last);

  const HeightGrid& grid_;
  const SimplifyOptions& options_;
  SimplifyReport& report_;
  double rounding_;
  std::size_t next_error_ = 0, next_count_ = 0;
  std::size_t turns_ = 0;
  bool cancelled_ = false;
};

}  // namespace lepp
