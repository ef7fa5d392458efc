#pragma once

#include <optional>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// Of the places for a vertex that were tried and not found good enough, the best one.
class BestPlace {
 public:
  void clear() { best_.reset(); }
  /// \param badness  cos^2 of the smallest angle of the star there
  void note(Point place, double badness) {
    if (!best_ || badness < best_->badness) best_ = Candidate{place, badness};
  }
  bool exists() const { return best_.has_value(); }
  Point place() const { return best_->place; }  ///< \pre exists()

 private:
  struct Candidate {
    Point place;
    double badness;
  };
  std::optional<Candidate> best_;
};

}  // namespace lepp
