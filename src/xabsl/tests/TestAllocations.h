#pragma once

namespace xabsl::test {

/// How often this program has allocated memory so far.
long allocations();

}  // namespace xabsl::test
