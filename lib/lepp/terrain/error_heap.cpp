#include "lepp/terrain/error_heap.hpp"

#include <algorithm>

namespace lepp {

void ErrorHeap::set(TriangleId t, double error) {
  if (place_.size() <= t.index())
    place_.resize(std::max(t.index() + 1, 2 * place_.size()), nowhere);
  const std::uint32_t place = place_[t.index()];
  if (!(error > limit_)) {
    if (place != nowhere) remove(place);
    return;
  }
  const Entry entry{error, t.value};
  if (place == nowhere) {
    heap_.push_back(entry);
    rise(heap_.size() - 1, entry);
  } else if (entry < heap_[place]) {
    rise(place, entry);
  } else {
    sink(place, entry);
  }
}

std::optional<TriangleId> ErrorHeap::top() const {
  if (heap_.empty()) return std::nullopt;
  return TriangleId(heap_.front().triangle);
}

void ErrorHeap::put(std::size_t place, const Entry& entry) {
  heap_[place] = entry;
  place_[entry.triangle] = static_cast<std::uint32_t>(place);
}

void ErrorHeap::rise(std::size_t place, const Entry& entry) {
  while (place > 0) {
    const std::size_t parent = (place - 1) / 2;
    if (!(entry < heap_[parent])) break;
    put(place, heap_[parent]);
    place = parent;
  }
  put(place, entry);
}

void ErrorHeap::sink(std::size_t place, const Entry& entry) {
  while (2 * place + 1 < heap_.size()) {
    std::size_t child = 2 * place + 1;
    if (child + 1 < heap_.size() && heap_[child + 1] < heap_[child]) ++child;
    if (!(heap_[child] < entry)) break;
    put(place, heap_[child]);
    place = child;
  }
  put(place, entry);
}

void ErrorHeap::remove(std::size_t place) {
  place_[heap_[place].triangle] = nowhere;
  const Entry last = heap_.back();
  heap_.pop_back();
  if (place == heap_.size()) return;
  if (place > 0 && last < heap_[(place - 1) / 2]) rise(place, last);
  else sink(place, last);
}

}  // namespace lepp
