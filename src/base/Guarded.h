#pragma once
#include <exception>

#include "base/Result.h"

namespace gt {

/// What an exception reports, as one line.
Error errorOf(const std::exception& exception);

/// What work() returns, a Result; an exception that leaves it becomes an error.
template <typename Work>
auto guarded(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& exception) {
    return errorOf(exception);
  }
}

}  // namespace gt
