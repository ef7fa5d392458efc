#include <algorithm>
#include <array>
#include <thread>

#include "lepp/bisection/cutter.hpp"
#include "lepp/bisection/forest.hpp"
#include "lepp/bisection/make_room_for.hpp"
#include "lepp/geometry/memory_access.hpp"
#include "lepp/geometry/two_threads.hpp"

namespace lepp {

namespace {

constexpr std::size_t at_once = 4096, too_few_for_threads = 1024;

// More threads would wait for each other.
unsigned processors() {
  const unsigned number = std::thread::hardware_concurrency();
  return number > 0 ? number : 2;  // it is not known everywhere
}

}  // namespace

// Lists have triangles that must be cut, and are worked on some thousand at a time: a batch. A
// triangle whose edge is the edge of its neighbour as well, or on the boundary, is cut with that
// neighbour: such edges belong to different triangles, so all of them can be cut at the same time.
// Any other one waits for its neighbour, which joins the next list; when that has been cut, it
// wakes those that waited for it. So each path is followed once, and each of its triangles comes up
// as often as the triangle across its edge changes.
//
// Two threads have half of a batch each; what they find follows each other in the order of the
// list, so that ids do not depend on their number.
class Bisector {
 public:
  Bisector(Forest& forest, const BisectOptions& options, Refinement& done)
      : forest_(forest),
        mesh_(forest.mesh_),
        threads_(std::min(options.threads, processors())),
        most_vertices_(options.max_vertices),
        cutter_(forest, options),
        result_(done) {}

  void run(std::span<const TriangleId> marked);

 private:
  using State = Forest::State;
  // What one thread has of a batch.
  struct Part {
    std::span<const TriangleId> list;
    std::vector<Cut> cuts;
    std::vector<TriangleId> refused, stuck, woken;  // stuck: they wait for what nobody has listed
    std::vector<TriangleId> waited;                 // of all batches
    std::size_t sides = 0, constrained = 0;         // of the cuts
    std::size_t first_cut = 0, first_side = 0;      // how many come before it
  };

  void work_on_lists(std::span<const TriangleId> marked);
  std::span<const TriangleId> take(std::span<const TriangleId>& left);
  void work_on(std::span<const TriangleId> batch);
  void judge(Part& part);
  void judge(Part& part, TriangleId t);
  void keep_within_limit();
  void make_room();
  void give_ids(Part& part);
  std::size_t sides() const { return parts_[0].sides + parts_[1].sides; }
  std::uint32_t pair(std::size_t i) const;
  void settle();
  void split_records(const Part& part);
  void refuse(const Part& part);
  void refuse(TriangleId t);
  void list_stuck(const Part& part);
  void finish();
  void make_idle();
  void list(TriangleId t);
  bool is_wanted(TriangleId t) const;
  template <class Work>
  void in_parts(const Work& work);

  State& state(TriangleId t) { return forest_.leaves_[t.index()].state; }
  State state(TriangleId t) const { return forest_.leaves_[t.index()].state; }

  Forest& forest_;
  Mesh& mesh_;
  const unsigned threads_;
  const std::size_t most_vertices_;  // 0: any number
  Cutter cutter_;
  SecondThread second_;
  Refinement& result_;
  std::vector<TriangleId> list_, next_, batch_;
  std::array<Part, 2> parts_;
  // Of the batch: what there was before it.
  std::size_t vertices_ = 0, triangles_ = 0, cuts_ = 0, halves_ = 0, pairs_ = 0, free_pairs_ = 0;
};

void Bisector::run(std::span<const TriangleId> marked) {
  result_ = {};
  try {
    work_on_lists(marked);
    finish();
  } catch (...) {
    make_idle();
    throw;
  }
}

void Bisector::work_on_lists(std::span<const TriangleId> marked) {
  result_.vertices.reserve(marked.size() / 2);
  result_.triangles.reserve(marked.size());
  next_.reserve(marked.size());
  for (const TriangleId t : marked) list(t);
  while (!next_.empty()) {  // ends: keys grow along a path, and each cut fulfils a wish
    list_.swap(next_);
    next_.clear();
    for (std::span<const TriangleId> left = list_; !left.empty();) {
      work_on(take(left));
      if (result_.limited) return;
    }
  }
}

void Bisector::list(TriangleId t) {
  if (is_wanted(t) || state(t) == State::refused) return;
  next_.push_back(t);
  state(t) = State::listed;
}

bool Bisector::is_wanted(TriangleId t) const {
  return state(t) == State::listed || state(t) == State::taken;
}

// The next batch of what is `left` of the list.
std::span<const TriangleId> Bisector::take(std::span<const TriangleId>& left) {
  constexpr std::size_t ahead = 32;
  batch_.clear();
  std::size_t i = 0;
  for (; i < left.size() && batch_.size() < at_once; ++i) {
    if (i + ahead < left.size()) cutter_.prefetch(left[i + ahead]);
    const TriangleId t = left[i];
    if (state(t) != State::listed) continue;  // cut with a neighbour since, or refused with it
    state(t) = State::taken;                  // a half with this id may be listed once more
    batch_.push_back(t);
  }
  left = left.subspan(i);
  return batch_;
}

template <class Work>
void Bisector::in_parts(const Work& work) {
  second_.run(
      parts_[1].list.empty() ? 1 : 2, [&] { work(parts_[0]); }, [&] { work(parts_[1]); });
}

void Bisector::work_on(std::span<const TriangleId> batch) {
  const bool alone = threads_ < 2 || batch.size() < too_few_for_threads;
  const std::size_t half = alone ? batch.size() : batch.size() / 2;
  parts_[0].list = batch.first(half);
  parts_[1].list = batch.subspan(half);
  in_parts([&](Part& part) { judge(part); });
  make_room();
  in_parts([&](Part& part) { give_ids(part); });
  in_parts([&](Part& part) {
    for (std::size_t i = 0; i < part.cuts.size(); ++i) {
      cutter_.prefetch_for_writes(part.cuts, i);
      cutter_.write(part.cuts[i], part.woken);
    }
  });
  in_parts([&](Part& part) {
    for (const Cut& cut : part.cuts) cutter_.forget(cut);
  });
  settle();
}

void Bisector::judge(Part& part) {
  part.cuts.clear();
  part.refused.clear();
  part.stuck.clear();
  part.woken.clear();
  part.sides = part.constrained = 0;
  for (std::size_t i = 0; i < part.list.size(); ++i) {
    cutter_.prefetch_for_plans(part.list, i);
    judge(part, part.list[i]);
  }
}

void Bisector::judge(Part& part, TriangleId t) {
  const HalfEdge e = forest_.edge_to_cut(t);
  const auto across = mesh_.twin(e);
  if (across && forest_.edge_to_cut(across->triangle) != *across) {
    if (load_relaxed(state(across->triangle)) == State::idle) part.stuck.push_back(t);
    part.waited.push_back(t);
    store_relaxed(state(t), State::waiting);
  } else if (across && is_wanted(across->triangle) && across->triangle < t) {
    return;  // cut when the neighbour's turn comes
  } else if (const auto cut = cutter_.plan(e, across)) {
    part.cuts.push_back(*cut);
    part.sides += cut->side_count;
    part.constrained += cut->constrained ? 1 : 0;
  } else {
    part.refused.push_back(t);
  }
}

// The first cuts of the batch, as many as may be.
void Bisector::keep_within_limit() {
  if (most_vertices_ == 0) return;
  std::size_t left = most_vertices_ - std::min(most_vertices_, mesh_.vertex_count());
  for (Part& part : parts_) {
    for (; part.cuts.size() > left; part.cuts.pop_back()) {
      part.sides -= part.cuts.back().side_count;
      part.constrained -= part.cuts.back().constrained ? 1 : 0;
      result_.limited = true;
    }
    left -= part.cuts.size();
  }
}

// All that may fail comes before the first change: a batch that has room is cut to its end.
void Bisector::make_room() {
  constexpr std::size_t most_woken = 4;  // by one cut
  keep_within_limit();
  vertices_ = mesh_.vertex_count();
  triangles_ = mesh_.triangle_count();
  cuts_ = result_.vertices.size();
  halves_ = result_.triangles.size();
  pairs_ = forest_.pairs_.size();
  free_pairs_ = forest_.free_pairs_.size();
  parts_[1].first_cut = parts_[0].cuts.size();
  parts_[1].first_side = parts_[0].sides;
  const std::size_t cuts = parts_[1].first_cut + parts_[1].cuts.size();
  const std::size_t new_pairs = sides() - std::min(free_pairs_, sides());
  for (Part& part : parts_) part.woken.reserve(most_woken * part.cuts.size());
  make_room_for(result_.vertices, cuts);
  make_room_for(result_.triangles, sides());
  forest_.leaves_.make_room_for(sides());
  forest_.pairs_.make_room_for(new_pairs);
  mesh_.make_room_for_records(parts_[0].constrained + parts_[1].constrained);
  mesh_.grow(cuts, sides());
  forest_.leaves_.resize(triangles_ + sides());
  forest_.pairs_.resize(pairs_ + new_pairs);
  result_.vertices.resize(cuts_ + cuts);
  result_.triangles.resize(halves_ + sides());
}

// Ids follow the order of the list.
void Bisector::give_ids(Part& part) {
  std::size_t cuts = part.first_cut, sides = part.first_side;
  for (Cut& cut : part.cuts) {
    const HalfEdge e = cut.sides[0].e;
    cut.vertex = VertexId(vertices_ + cuts);
    result_.vertices[cuts_ + cuts++] = {cut.vertex, mesh_.origin(e), mesh_.destination(e)};
    for (Cut::Side& side : cut.both()) {
      side.second = TriangleId(triangles_ + sides);
      side.pair = pair(sides);
      result_.triangles[halves_ + sides++] = {side.e.triangle, side.second};
    }
    cutter_.announce(cut);
  }
}

// Unused ones come first, the last of them at first.
std::uint32_t Bisector::pair(std::size_t i) const {
  if (i < free_pairs_) return forest_.free_pairs_[free_pairs_ - 1 - i];
  return static_cast<std::uint32_t>(pairs_ + i - free_pairs_);
}

// What may concern triangles of the other part, or tables: each step for both parts, so that it
// does not matter where one ends. First what the cuts leave to do, which cannot fail.
void Bisector::settle() {
  forest_.free_pairs_.resize(free_pairs_ - std::min(free_pairs_, sides()));
  for (const Part& part : parts_) split_records(part);
  for (const Part& part : parts_) refuse(part);
  for (const Part& part : parts_) list_stuck(part);
  for (const Part& part : parts_) next_.insert(next_.end(), part.woken.begin(), part.woken.end());
}

void Bisector::split_records(const Part& part) {
  for (const Cut& cut : part.cuts) {
    if (!cut.constrained) continue;
    const Cut::Side& side = cut.sides[0];
    const VertexId a = mesh_.origin(side.e), b = mesh_.destination({side.second, side.e.edge});
    mesh_.split_record(a, b, cut.vertex, cut.parameter);
  }
}

void Bisector::refuse(const Part& part) {
  for (const TriangleId t : part.refused) {
    refuse(t);
    const auto across = mesh_.twin(forest_.edge_to_cut(t));
    if (across && is_wanted(across->triangle)) refuse(across->triangle);
  }
}

void Bisector::refuse(TriangleId t) {
  state(t) = State::refused;
  result_.refused.push_back(t);
}

void Bisector::list_stuck(const Part& part) {
  for (const TriangleId t : part.stuck) {
    if (state(t) == State::waiting) list(mesh_.twin(forest_.edge_to_cut(t))->triangle);
  }
}

// What still waits does so for a triangle that was refused, unless the limit was met.
void Bisector::finish() {
  if (result_.limited) make_idle();
  for (const Part& part : parts_) {
    for (const TriangleId t : part.waited) {
      if (state(t) == State::waiting) refuse(t);
    }
  }
  for (const TriangleId t : result_.refused) state(t) = State::idle;
  std::ranges::sort(result_.refused);
}

// Lists have all that is in any other state.
void Bisector::make_idle() {
  for (const auto* all : {&list_, &next_, &result_.refused}) {
    for (const TriangleId t : *all) state(t) = State::idle;
  }
  for (const Part& part : parts_) {
    for (const TriangleId t : part.waited) state(t) = State::idle;  // those woken as well
  }
}

Refinement Forest::bisect(std::span<const TriangleId> marked, const BisectOptions& options) {
  Refinement done;
  bisect(marked, options, done);
  return done;
}

void Forest::bisect(std::span<const TriangleId> marked, const BisectOptions& options,
                    Refinement& done) {
  Bisector(*this, options, done).run(marked);
}

}  // namespace lepp
