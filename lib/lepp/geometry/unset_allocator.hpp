#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace lepp {

/// An allocator whose vectors grow without writing to the new elements: large arrays that are
/// filled by two threads, or not in order, need not be swept through twice.
/// \pre the elements are trivially copyable, and are assigned before they are read
template <class T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  UnsetAllocator() = default;
  template <class U>
  constexpr UnsetAllocator(const UnsetAllocator<U>&) noexcept {}  // converts, as allocators do
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <class U>
  void construct(U*) const noexcept {}
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) const {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

}  // namespace lepp
