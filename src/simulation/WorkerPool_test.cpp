#include "simulation/WorkerPool.h"

#include <gtest/gtest.h>

#include <numeric>

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

}  // namespace
}  // namespace gt
