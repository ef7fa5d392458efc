#include "lepp/triangulation/components.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "lepp/geometry/two_threads.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

// Floods the triangles [begin, end). Waits for memory take most of the time of a flood. So it goes
// from front to front, and asks for a triangle when it is put into the next front, long before it
// is looked at; and that a triangle has been seen stands in a bit of its own, so that asking does
// not touch it.
class Flood {
 public:
  Flood(RawTriangulation& raw, std::uint32_t begin, std::uint32_t end)
      : raw_(raw), begin_(begin), end_(end), seen_(end - begin, false) {}

  // Numbers what it finds from 1 on, in the order of first triangles.
  void run() {
    for (std::uint32_t t = begin_; t < end_; ++t) {
      if (seen_[t - begin_]) continue;
      if (raw_.is_ghost(t)) {
        raw_.set_label(t, 0);
      } else {
        is_open_.push_back(false);
        fill_from(t);
      }
    }
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(is_open_.size()); }
  // By label - 1.
  const std::vector<bool>& is_open() const { return is_open_; }
  // Unconstrained edges to triangles behind the range.
  const std::vector<Code>& leaving() const { return leaving_; }

 private:
  void fill_from(std::uint32_t start) {
    next_.push_back(start);
    seen_[start - begin_] = true;
    while (!next_.empty()) {
      front_.swap(next_);
      for (const std::uint32_t t : front_) {
        if (raw_.is_ghost(t)) {
          is_open_.back() = true;
          seen_[t - begin_] = false;  // other components may reach it, too
        } else {
          raw_.set_label(t, count());
          step_from(t);
        }
      }
      front_.clear();
    }
  }

  void step_from(std::uint32_t t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Code e = RawTriangulation::code(t, i);
      const std::uint32_t across = RawTriangulation::triangle_of(raw_.twin(e));
      if (raw_.is_constrained(e)) continue;
      if (across < begin_ || across >= end_) {
        if (raw_.is_ghost(across)) is_open_.back() = true;
        else if (across >= end_) leaving_.push_back(e);
      } else if (!seen_[across - begin_]) {
        seen_[across - begin_] = true;
        raw_.prefetch(across);
        next_.push_back(across);
      }
    }
  }

  RawTriangulation& raw_;
  std::uint32_t begin_, end_;
  std::vector<bool> seen_, is_open_;
  std::vector<Code> leaving_;
  std::vector<std::uint32_t> front_, next_;
};

// Which of the labels of two floods belong together. Labels of the second one follow those of the
// first; each set is known by its smallest label.
class Joins {
 public:
  Joins(std::uint32_t first, std::uint32_t second) : first_(first), parent_(first + second + 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  void join(std::uint32_t of_first, std::uint32_t of_second) {
    const std::uint32_t a = root(of_first), b = root(first_ + of_second);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  // A number for each label, from 1 on, equal for those that belong together.
  std::vector<std::uint32_t> numbers() {
    std::vector<std::uint32_t> number(parent_.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t label = 1; label < parent_.size(); ++label) {
      const std::uint32_t first = root(label);
      number[label] = first == label ? ++count : number[first];
    }
    return number;
  }

 private:
  std::uint32_t root(std::uint32_t label) {
    while (parent_[label] != label) label = parent_[label] = parent_[parent_[label]];
    return label;
  }

  std::uint32_t first_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace

// Each thread floods the triangles of one half of the array. Sets are numbered by their smallest
// labels, which is the order of first triangles; so the labels do not depend on where halves meet.
Components label_components(RawTriangulation& raw, unsigned threads) {
  const auto end = static_cast<std::uint32_t>(raw.triangles.size());
  const std::uint32_t middle = end / 2;
  Flood first(raw, 0, middle), second(raw, middle, end);
  in_parallel(
      threads, [&] { first.run(); }, [&] { second.run(); });
  Joins joins(first.count(), second.count());
  for (const Code e : first.leaving()) {
    joins.join(raw.label(RawTriangulation::triangle_of(e)),
               raw.label(RawTriangulation::triangle_of(raw.twin(e))));
  }
  const std::vector<std::uint32_t> number = joins.numbers();
  Components components;
  components.count = *std::ranges::max_element(number);
  components.is_open.assign(components.count, false);
  for (std::uint32_t label = 1; label < number.size(); ++label) {
    const bool is_open = label <= first.count() ? first.is_open()[label - 1]
                                                : second.is_open()[label - 1 - first.count()];
    if (is_open) components.is_open[number[label] - 1] = true;
  }
  const auto renumber = [&](std::uint32_t from, std::uint32_t to, std::uint32_t before) {
    for (std::uint32_t t = from; t < to; ++t) {
      if (raw.label(t) != 0) raw.set_label(t, number[before + raw.label(t)]);
    }
  };
  in_parallel(
      threads, [&] { renumber(0, middle, 0); }, [&] { renumber(middle, end, first.count()); });
  return components;
}

}  // namespace lepp
