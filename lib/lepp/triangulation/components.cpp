#include "lepp/triangulation/components.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

// Union-find on the labels: a triangle's label leads towards the first triangle of its component.
class Forest {
 public:
  explicit Forest(RawTriangulation& raw) : raw_(raw) {}

  std::uint32_t root(std::uint32_t t) {
    while (raw_.label(t) != t) {  // halves the path on the way
      raw_.set_label(t, raw_.label(raw_.label(t)));
      t = raw_.label(t);
    }
    return t;
  }

  void join(std::uint32_t t, std::uint32_t u) {
    t = root(t);
    u = root(u);
    if (t < u) raw_.set_label(u, t);
    else raw_.set_label(t, u);
  }

 private:
  RawTriangulation& raw_;
};

}  // namespace

// Triangles are passed in the order of memory, three times; a flood would jump about.
Components label_components(RawTriangulation& raw) {
  const auto count = static_cast<std::uint32_t>(raw.triangles.size());
  Forest forest(raw);
  for (std::uint32_t t = 0; t < count; ++t) {
    raw.set_label(t, t);
    if (raw.is_ghost(t)) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Code e = RawTriangulation::code(t, i);
      const std::uint32_t across = RawTriangulation::triangle_of(raw.twin(e));
      if (across < t && !raw.is_constrained(e) && !raw.is_ghost(across)) forest.join(t, across);
    }
  }
  Components components;
  for (std::uint32_t t = 0; t < count; ++t) {  // the label of a first triangle is final by now
    if (raw.is_ghost(t)) raw.set_label(t, 0);
    else raw.set_label(t, raw.label(t) == t ? ++components.count : raw.label(raw.label(t)));
  }
  components.is_open.assign(components.count, false);
  for (std::uint32_t t = 0; t < count; ++t) {
    const Code hull = RawTriangulation::code(t, 2);
    if (!raw.is_ghost(t) || raw.is_constrained(hull)) continue;
    components.is_open[raw.label(RawTriangulation::triangle_of(raw.twin(hull))) - 1] = true;
  }
  return components;
}

}  // namespace lepp
