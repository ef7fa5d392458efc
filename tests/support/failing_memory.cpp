#include "support/failing_memory.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>

namespace {

// How many more succeed; below 0: all.
std::atomic<std::int64_t> left = -1;

bool fails() {
  if (left.load() < 0) return false;
  return left.fetch_sub(1) == 0;
}

void* allocate(std::size_t bytes) {
  void* block = fails() ? nullptr : std::malloc(std::max<std::size_t>(bytes, 1));
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

}  // namespace

namespace lepp::test {

FailingMemory::FailingMemory(std::size_t allowed) { left = static_cast<std::int64_t>(allowed); }
FailingMemory::~FailingMemory() { left = -1; }

}  // namespace lepp::test

void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new[](std::size_t bytes) { return allocate(bytes); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }

// What GrowingArray asks for (geometry/growing_array.cpp). The linker puts this in between.
extern "C" {
void* __real_realloc(void*, std::size_t);
void* __wrap_realloc(void* block, std::size_t bytes) {
  return fails() ? nullptr : __real_realloc(block, bytes);
}
}
