#pragma once

namespace gt {

/// How often the whole program has taken memory from the heap, for tests that it does not. Link
/// `gt_test_allocations`.
long allocations();

/// As long as an object exists, other threads than its maker's get no memory from the heap.
class NoMemoryElsewhere {
 public:
  NoMemoryElsewhere();
  ~NoMemoryElsewhere();
  NoMemoryElsewhere(const NoMemoryElsewhere&) = delete;
  NoMemoryElsewhere& operator=(const NoMemoryElsewhere&) = delete;
};

}  // namespace gt
