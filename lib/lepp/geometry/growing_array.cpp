#include "lepp/geometry/growing_array.hpp"

#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lepp::pages {

namespace {

void* checked(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

#ifdef __linux__

constexpr std::size_t least_mapped = std::size_t{1} << 20;  // bytes

void* mapped(void* block) { return checked(block == MAP_FAILED ? nullptr : block); }

// Blocks of at least `least_mapped` bytes are mapped, so that they can be moved.
bool is_mapped(std::size_t bytes) { return bytes >= least_mapped; }

void* map(std::size_t bytes) {
  return mapped(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
}

void* move_to(void* block, std::size_t old_bytes, std::size_t bytes) {
  return mapped(::mremap(block, old_bytes, bytes, MREMAP_MAYMOVE));
}

void unmap(void* block, std::size_t bytes) { ::munmap(block, bytes); }

#else

bool is_mapped(std::size_t) { return false; }
void* map(std::size_t) { return nullptr; }
void* move_to(void*, std::size_t, std::size_t) { return nullptr; }
void unmap(void*, std::size_t) {}

#endif

}  // namespace

void* resize(void* old, std::size_t old_bytes, std::size_t bytes) {
  if (bytes == 0) {
    release(old, old_bytes);
    return nullptr;
  }
  if (is_mapped(old_bytes) && is_mapped(bytes)) return move_to(old, old_bytes, bytes);
  if (is_mapped(old_bytes) == is_mapped(bytes)) return checked(std::realloc(old, bytes));
  void* block = is_mapped(bytes) ? map(bytes) : checked(std::malloc(bytes));
  if (old_bytes != 0) std::memcpy(block, old, std::min(old_bytes, bytes));
  release(old, old_bytes);
  return block;
}

void release(void* block, std::size_t bytes) noexcept {
  if (is_mapped(bytes)) unmap(block, bytes);
  else std::free(block);
}

}  // namespace lepp::pages
