#include "support/TestAllocations.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> count = 0;
std::atomic<bool> exhausted = false;
thread_local bool isSpared = false;

/// Null if there is none.
void* memoryOf(std::size_t size) {
  ++count;
  return exhausted && !isSpared ? nullptr : std::malloc(size);
}

}  // namespace

void* operator new(std::size_t size) {
  if (void* memory = memoryOf(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return memoryOf(size);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace gt {

long allocations() {
  return count;
}

NoMemoryElsewhere::NoMemoryElsewhere() {
  isSpared = true;
  exhausted = true;
}
NoMemoryElsewhere::~NoMemoryElsewhere() {
  exhausted = false;
  isSpared = false;
}

}  // namespace gt
