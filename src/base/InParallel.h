#pragma once
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/Guarded.h"

namespace gt {

/// The results of work(i) for i = 0 .. count-1, in this order, computed by some threads, the caller
/// among them; by fewer if the system gives no more. `work` returns a Result<T>; an exception that
/// leaves it becomes its error.
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
