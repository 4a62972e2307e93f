#include "simulation/WorkerPool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>

namespace gt {
namespace {

TEST(WorkerPool, EveryIndexIsWorkedOnOnce) {
  for (const std::size_t threads : {0, 1, 2, 5}) {
    WorkerPool pool{threads};
    for (int job = 0; job < 300; ++job) {
      std::vector<int> done(static_cast<std::size_t>(job % 23));
      pool.forEach(done.size(), [&](std::size_t i, std::size_t worker) {
        ASSERT_LT(worker, pool.threads());
        ++done[i];
      });
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), job % 23);
      EXPECT_EQ(std::count(done.begin(), done.end(), 1), job % 23);
    }
  }
}

TEST(WorkerPool, OthersHelp) {
  WorkerPool pool{2};
  // Each of two indices waits for the other: one thread alone would never end.
  std::atomic<int> arrived{0};
  pool.forEach(2, [&](std::size_t, std::size_t) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

/// Returns what a job of 20 indices throws, each from a lowest one on.
std::string thrownFrom(WorkerPool& pool, std::size_t lowest) {
  try {
    pool.forEach(20, [&](std::size_t i, std::size_t) {
      if (i >= lowest) throw std::runtime_error{std::to_string(i)};
    });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(WorkerPool, ThrowsWhatWorkOfTheLowestIndexHasThrown) {
  for (const std::size_t threads : {1, 2, 5}) {
    WorkerPool pool{threads};
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(thrownFrom(pool, 7), "7");
      EXPECT_EQ(thrownFrom(pool, 20), "") << "nothing is kept for the next job";
    }
  }
}

/// Makes a pool without room for all stacks, and ends with status 0 if it works.
void workWithoutRoom() {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = 1 << 30;
  setrlimit(RLIMIT_AS, &limit);
  WorkerPool pool{200};
  std::atomic<int> done{0};
  pool.forEach(20, [&](std::size_t, std::size_t) { ++done; });
  std::_Exit(done == 20 && pool.threads() < 200 ? 0 : 1);
}

TEST(WorkerPoolDeathTest, WorksWithAsManyThreadsAsTheSystemGives) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need address space of their own";
#endif
  EXPECT_EXIT(workWithoutRoom(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace gt
