#include "bench/counted_memory.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> held = 0, peak = 0;

void count(std::size_t bytes) {
  const std::size_t now = held += bytes;
  std::size_t most = peak;
  while (most < now && !peak.compare_exchange_weak(most, now)) {
  }
}

void* counted(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  count(malloc_usable_size(block));
  return block;
}

void release(void* block) {
  if (block != nullptr) held -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(std::max<std::size_t>(size, 1)));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(
      std::aligned_alloc(step, (std::max<std::size_t>(size, 1) + step - 1) / step * step));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

// Large arrays are mapped (geometry/growing_array.cpp). The linker puts these in between.
extern "C" {
void* __real_mmap(void*, std::size_t, int, int, int, off_t);
void* __real_mremap(void*, std::size_t, std::size_t, int);
int __real_munmap(void*, std::size_t);

void* __wrap_mmap(void* place, std::size_t bytes, int protection, int flags, int file, off_t from) {
  void* block = __real_mmap(place, bytes, protection, flags, file, from);
  if (block != MAP_FAILED) count(bytes);
  return block;
}
void* __wrap_mremap(void* old, std::size_t old_bytes, std::size_t bytes, int flags) {
  void* block = __real_mremap(old, old_bytes, bytes, flags);
  if (block == MAP_FAILED) return block;
  held -= old_bytes;
  count(bytes);
  return block;
}
int __wrap_munmap(void* block, std::size_t bytes) {
  held -= bytes;
  return __real_munmap(block, bytes);
}
}

namespace lepp::test {

std::size_t bytes_held() { return held; }
std::size_t peak_bytes() { return peak; }
void restart_peak() { peak = held.load(); }

}  // namespace lepp::test
