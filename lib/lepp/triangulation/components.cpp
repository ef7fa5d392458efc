#include "lepp/triangulation/components.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

// Waits for memory take most of the time of a flood. So it goes from front to front, and asks for a
// triangle when it is put into the next front, long before it is looked at; and that a triangle
// has been seen stands in a bit of its own, so that asking does not touch it.
class Flood {
 public:
  explicit Flood(RawTriangulation& raw) : raw_(raw), seen_(raw.triangles.size(), false) {}

  bool has_seen(std::uint32_t t) const { return seen_[t]; }

  // Labels what is connected to triangle `start`. \return true if the outside is among it
  bool run(std::uint32_t start, std::uint32_t label) {
    bool reaches_outside = false;
    next_.push_back(start);
    seen_[start] = true;
    while (!next_.empty()) {
      front_.swap(next_);
      for (const std::uint32_t t : front_) {
        if (raw_.is_ghost(t)) {
          reaches_outside = true;
          seen_[t] = false;  // other components may reach it, too
        } else {
          raw_.set_label(t, label);
          step_from(t);
        }
      }
      front_.clear();
    }
    return reaches_outside;
  }

 private:
  void step_from(std::uint32_t t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Code e = RawTriangulation::code(t, i);
      const std::uint32_t across = RawTriangulation::triangle_of(raw_.twin(e));
      if (raw_.is_constrained(e) || seen_[across]) continue;
      seen_[across] = true;
      raw_.prefetch(across);
      next_.push_back(across);
    }
  }

  RawTriangulation& raw_;
  std::vector<bool> seen_;
  std::vector<std::uint32_t> front_, next_;
};

}  // namespace

Components label_components(RawTriangulation& raw) {
  Components components;
  Flood flood(raw);
  for (std::uint32_t t = 0; t < raw.triangles.size(); ++t) {
    if (flood.has_seen(t)) continue;
    if (raw.is_ghost(t)) raw.set_label(t, 0);
    else components.is_open.push_back(flood.run(t, ++components.count));
  }
  return components;
}

}  // namespace lepp
