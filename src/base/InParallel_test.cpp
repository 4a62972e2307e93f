#include "base/InParallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>

namespace gt {
namespace {

TEST(InParallel, ResultsStandInTheOrderOfTheWork) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    const auto results =
        inParallel(100, threads, [](std::size_t i) { return Result<std::size_t>{i * i}; });
    ASSERT_EQ(results.size(), 100u);
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(*results[i], i * i);
  }
}

TEST(InParallel, UsesAsManyThreadsAsItIsTold) {
  std::mutex mutex;
  std::condition_variable more;
  std::set<std::thread::id> used;
  inParallel(200, 3, [&](std::size_t) {
    std::unique_lock lock{mutex};
    used.insert(std::this_thread::get_id());
    more.notify_all();
    // None does it all before the others have begun.
    more.wait_for(lock, std::chrono::minutes{1}, [&] { return used.size() >= 3; });
    return Result<void>{};
  });
  EXPECT_EQ(used.size(), 3u);
}

TEST(InParallel, AnExceptionIsAnErrorOfThatWorkAlone) {
  const auto results = inParallel(10, 2, [](std::size_t i) -> Result<int> {
    if (i == 3) throw std::runtime_error{"three"};
    if (i == 4) return Error{.what = "four"};
    return 1;
  });
  EXPECT_EQ(results[3].error().what, "three");
  EXPECT_EQ(results[4].error().what, "four");
  EXPECT_EQ(*results[5], 1);
}

}  // namespace
}  // namespace gt
