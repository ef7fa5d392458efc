#include "lepp/terrain/greedy.hpp"

#include "lepp/terrain/error_heap.hpp"

namespace lepp {

void greedy(TerrainMesh& terrain, Levels& levels, std::vector<double>& error_of_prefix) {
  ErrorHeap heap(levels.last_error());
  for (std::size_t t = 0; t < terrain.mesh().triangle_count(); ++t) {
    heap.set(TriangleId(t), terrain.error(TriangleId(t)));
  }
  std::vector<TriangleId> changed;
  error_of_prefix.push_back(heap.top_error());
  while (levels.ask_now_and_then(terrain.mesh().vertex_count())) {
    if (levels.has_ended(terrain.tin(), heap.top_error())) {
      if (!levels.next(terrain.tin(), heap.top_error())) return;
      continue;
    }
    const auto t = heap.top();
    changed.clear();
    if (!terrain.insert(*t, terrain.worst(*t).at, changed)) {
      heap.set(*t, 0);
      continue;
    }
    terrain.rescan(changed);
    for (const TriangleId c : changed) heap.set(c, terrain.error(c));
    error_of_prefix.push_back(heap.top_error());
  }
}

}  // namespace lepp
