#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lepp {

/// As GrowingArray::make_room_for(): the next so many items cannot fail; room doubles.
template <class T>
void make_room_for(std::vector<T>& items, std::size_t more) {
  if (more <= items.capacity() - items.size()) return;
  items.reserve(std::max(items.size() + more, 2 * items.capacity()));
}

}  // namespace lepp
