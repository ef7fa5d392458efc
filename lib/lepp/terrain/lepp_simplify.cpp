#include "lepp/terrain/lepp_simplify.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "lepp/terrain/lepp_loop.hpp"
#include "lepp/terrain/tin_clean_up.hpp"

namespace lepp {

namespace {

// A round of clean-up that takes less than this part of the vertices away is the last.
constexpr std::size_t next_to_nothing = 200;
constexpr int most_rounds = 12;
// Of Effort::normal: a small TIN is cleaned up several times in no time.
constexpr int some_rounds = 3;
constexpr std::size_t small = 10000;
constexpr std::size_t few = 16;

class LeppSimplification {
 public:
  LeppSimplification(TerrainMesh& terrain, Levels& levels, const SimplifyOptions& options)
      : terrain_(terrain),
        levels_(levels),
        options_(options),
        loop_(terrain, options.min_angle_deg, [this] { return go_on(); }) {}

  std::vector<Unfinished> run() {
    for (;;) {
      reach_level();
      const bool has_more =
          levels_.next(terrain_.tin(), loop_.largest_error(), small_angles(levels_.vertices()));
      if (!has_more) break;
      loop_.freeze();
    }
    return small_angles(options_.max_vertices);
  }

 private:
  bool go_on() { return levels_.ask_now_and_then(terrain_.mesh().vertex_count()); }

  // What clean-up leaves to be mended, and the vertices that it sets free where there is a limit on
  // them, are the next round's.
  void reach_level() {
    std::optional<TerrainMesh::State> start;
    if (options_.effort != Effort::fast && is_limited(small)) start = terrain_.save();
    loop_.run(levels_.error(), levels_.vertices());
    if (options_.effort == Effort::fast) return;
    if (start && loop_.limited()) mend_angles_alone(std::move(*start));
    start.reset();
    for (int round = 0; round < rounds() && !loop_.cancelled(); ++round) {
      const std::size_t before = terrain_.mesh().vertex_count();
      std::optional<TerrainMesh::State> good;
      if (is_limited(few) && !loop_.limited()) good = terrain_.save();
      const std::size_t gone = clean_up(std::max(levels_.error(), loop_.largest_error()));
      loop_.run(levels_.error(), levels_.vertices());
      if (good && loop_.limited()) {  // small angles that the round made have no room
        terrain_.restore(std::move(*good));
        loop_.run(levels_.error(), levels_.vertices());
        return;
      }
      if (gone * next_to_nothing < before) return;
    }
  }

  // True if there may be only so many vertices more.
  bool is_limited(std::size_t more) const {
    return levels_.vertices() <= terrain_.mesh().vertex_count() + more;
  }

  // Insertions for small angles overshoot; without what is needless then, there may be room.
  void mend_angles_alone(TerrainMesh::State start) {
    constexpr double any_error = std::numeric_limits<double>::infinity();
    TerrainMesh::State before = terrain_.save();
    terrain_.restore(std::move(start));
    loop_.run(any_error, std::numeric_limits<std::size_t>::max());
    const auto has_room = [&] { return terrain_.mesh().vertex_count() <= levels_.vertices(); };
    for (int round = 0; round < most_rounds && !has_room() && !loop_.cancelled(); ++round) {
      const std::size_t gone = clean_up(any_error);
      loop_.run(any_error, std::numeric_limits<std::size_t>::max());
      if (gone == 0) break;
    }
    if (!has_room()) terrain_.restore(std::move(before));
    loop_.run(levels_.error(), levels_.vertices());
  }

  int rounds() const {
    const std::size_t vertices = terrain_.mesh().vertex_count();
    if (is_limited(few) || options_.effort == Effort::best) return most_rounds;
    return vertices <= small ? some_rounds : 1;
  }

  std::size_t clean_up(double error) {
    const std::size_t before = terrain_.mesh().vertex_count();
    terrain_.renumber(loop_.frozen());
    TinCleanUp clean_up(terrain_, options_.min_angle_deg, error, loop_.frozen(),
                        [this] { return go_on(); });
    clean_up.remove_needless();
    clean_up.merge();
    clean_up.remove_needless();
    return before - terrain_.mesh().vertex_count();
  }

  std::vector<Unfinished> small_angles(std::size_t most_vertices) const {
    const Mesh& mesh = terrain_.mesh();
    const bool used_up =
        loop_.out_of_budget() || loop_.limited() || mesh.vertex_count() >= most_vertices;
    return lepp::small_angles(mesh, options_.min_angle_deg, {loop_.cancelled(), used_up},
                              loop_.at_kept_border());
  }

  TerrainMesh& terrain_;
  Levels& levels_;
  const SimplifyOptions& options_;
  LeppLoop loop_;
};

}  // namespace

std::vector<Unfinished> lepp_simplify(TerrainMesh& terrain, Levels& levels,
                                      const SimplifyOptions& options) {
  return LeppSimplification(terrain, levels, options).run();
}

}  // namespace lepp
