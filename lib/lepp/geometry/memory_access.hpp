#pragma once

#include <atomic>

namespace lepp {

/// Asks the memory for what will be looked at soon; any address will do, nothing is read.
inline void prefetch(const void* address) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#else
  (void)address;  // only slower
#endif
}

// Values that two threads may look at and change at the same time, each in one piece, where the
// order of what else they do does not matter. std::atomic_ref, which libc++ has had since LLVM 19
// only.

template <class T>
T load_relaxed(const T& value) {
#ifdef __cpp_lib_atomic_ref
  return std::atomic_ref(const_cast<T&>(value)).load(std::memory_order_relaxed);
#else
  T loaded;
  __atomic_load(&value, &loaded, __ATOMIC_RELAXED);
  return loaded;
#endif
}

template <class T>
void store_relaxed(T& value, T stored) {
#ifdef __cpp_lib_atomic_ref
  std::atomic_ref(value).store(stored, std::memory_order_relaxed);
#else
  __atomic_store(&value, &stored, __ATOMIC_RELAXED);
#endif
}

}  // namespace lepp
