#include "lepp/triangulation/components.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

// Labels everything that triangle `start` is connected to; true if the outside is among it.
bool flood(RawTriangulation& raw, std::uint32_t start, std::uint32_t label,
           std::vector<std::uint32_t>& front) {
  bool reaches_outside = false;
  raw.set_label(start, label);
  front.push_back(start);
  while (!front.empty()) {
    const std::uint32_t t = front.back();
    front.pop_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Code e = RawTriangulation::code(t, i);
      if (raw.is_constrained(e)) continue;
      const std::uint32_t across = RawTriangulation::triangle_of(raw.twin(e));
      if (raw.label(across) == label) continue;
      if (raw.is_ghost(across)) {
        reaches_outside = true;
        continue;
      }
      raw.set_label(across, label);
      front.push_back(across);
    }
  }
  return reaches_outside;
}

}  // namespace

Components label_components(RawTriangulation& raw) {
  Components components;
  std::vector<std::uint32_t> front;
  for (std::uint32_t t = 0; t < raw.triangles.size(); ++t) raw.set_label(t, 0);
  for (std::uint32_t t = 0; t < raw.triangles.size(); ++t) {
    if (raw.label(t) != 0 || raw.is_ghost(t)) continue;
    components.is_open.push_back(flood(raw, t, ++components.count, front));
  }
  return components;
}

}  // namespace lepp
