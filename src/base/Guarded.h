#pragma once
#include <exception>

#include "base/Result.h"

namespace gt {

/// The message of an exception as an error of one line.
Error errorOf(const std::exception& exception);

/// Returns the Result of work(). An exception thrown by work() becomes an error.
template <typename Work>
auto guarded(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& exception) {
    return errorOf(exception);
  }
}

}  // namespace gt
