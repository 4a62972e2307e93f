#pragma once

namespace gt {

/// How often the whole program has taken memory from the heap, for tests that it does not. Link
/// `gt_test_allocations`.
long allocations();

}  // namespace gt
