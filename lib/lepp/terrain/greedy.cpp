#include "lepp/terrain/greedy.hpp"

#include <algorithm>

#include "lepp/terrain/terrain_errors.hpp"

namespace lepp {

namespace {

class Greedy {
 public:
  Greedy(TerrainMesh& terrain, Levels& levels, std::vector<double>& error_of_prefix)
      : terrain_(terrain),
        levels_(levels),
        error_of_prefix_(error_of_prefix),
        heap_(errors_above(terrain, levels.last_error())),
        given_up_(0),
        at_lines_(error_at_lines(terrain)) {}

  void run() {
    note_prefix();
    while (levels_.ask_now_and_then(terrain_.mesh().vertex_count())) {
      if (!levels_.has_ended(terrain_.tin(), heap_.top_error())) insert_worst(*heap_.top());
      else if (!levels_.next(terrain_.tin(), heap_.top_error())) return;
    }
  }

 private:
  void insert_worst(TriangleId t) {
    changed_.clear();
    if (!terrain_.insert(t, terrain_.worst(t).at, changed_)) {
      given_up_.set(t, terrain_.error(t));
      heap_.set(t, 0);
      return;
    }
    terrain_.rescan(changed_);
    for (const TriangleId c : changed_) {
      heap_.set(c, terrain_.error(c));
      if (given_up_.size() > 0) given_up_.set(c, 0);
    }
    note_prefix();
  }

  // As long as the heap is not empty, what is in none of the three is off by less.
  void note_prefix() {
    error_of_prefix_.push_back(std::max({heap_.top_error(), given_up_.top_error(), at_lines_}));
  }

  TerrainMesh& terrain_;
  Levels& levels_;
  std::vector<double>& error_of_prefix_;
  ErrorHeap heap_, given_up_;
  const double at_lines_;  // no insertion changes it
  std::vector<TriangleId> changed_;
};

}  // namespace

void greedy(TerrainMesh& terrain, Levels& levels, std::vector<double>& error_of_prefix) {
  Greedy(terrain, levels, error_of_prefix).run();
}

}  // namespace lepp
