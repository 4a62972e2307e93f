#pragma once
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/Guarded.h"

namespace gt {

/// Runs work(i) for i = 0 .. count-1 in up to `threads` threads, including the caller's, and
/// returns the results in this order. Uses fewer threads if the system cannot create them. `work`
/// returns a Result<T>; an exception that it throws becomes an error.
template <typename Work>
auto inParallel(std::size_t count, unsigned threads, Work&& work) {
  using Outcome = decltype(work(std::size_t{}));
  std::vector<Outcome> results(count, Outcome{Error{.what = "was not done"}});
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i; (i = next++) < count;) results[i] = guarded([&] { return work(i); });
  };
  std::vector<std::jthread> others;
  try {
    for (unsigned i = 1; i < threads && i < count; ++i) others.emplace_back(run);
  } catch (const std::system_error&) {
  }
  run();
  others.clear();  // joins them
  return results;
}

}  // namespace gt
