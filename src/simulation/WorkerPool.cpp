#include "simulation/WorkerPool.h"

#include <algorithm>

namespace gt {
namespace {

/// Waits until a value is no longer what it was. The next job mostly comes at once, and waking a
/// thread that sleeps takes longer than many a job: so first it only steps aside for others.
void awaitChange(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  constexpr int looks = 500;  // some 200 us
  for (int i = 0; i < looks; ++i) {
    if (value != old) return;
    std::this_thread::yield();
  }
  value.wait(old);
}

}  // namespace

WorkerPool::WorkerPool(std::size_t threads) {
  for (std::size_t worker = 1; worker < std::max<std::size_t>(threads, 1); ++worker)
    threads_.emplace_back([this, worker] { run(worker); });
}

WorkerPool::~WorkerPool() {
  stop_ = true;
  ++job_;
  job_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::forEach(std::size_t count, const Work& work) {
  if (threads_.empty() || count < 2) {
    for (std::size_t i = 0; i < count; ++i) work(i, 0);
    return;
  }
  work_ = &work;
  count_ = static_cast<std::uint32_t>(count);
  unfinished_ = count_;
  open_ = static_cast<std::uint64_t>(job_ + 1) << 32 | count_;
  ++job_;
  job_.notify_all();
  takeShare(0);
  for (std::uint32_t left = unfinished_; left > 0; left = unfinished_)
    awaitChange(unfinished_, left);
}

void WorkerPool::run(std::size_t worker) {
  for (std::uint32_t done = 0;;) {
    awaitChange(job_, done);
    done = job_;
    if (stop_) return;
    takeShare(worker);
  }
}

void WorkerPool::takeShare(std::size_t worker) {
  for (std::size_t index; take(index);) {
    (*work_)(index, worker);
    if (--unfinished_ == 0) unfinished_.notify_one();
  }
}

bool WorkerPool::take(std::size_t& index) {
  std::uint64_t open = open_;
  do {
    if (static_cast<std::uint32_t>(open) == 0) return false;
  } while (!open_.compare_exchange_weak(open, open - 1));
  index = count_ - static_cast<std::uint32_t>(open);
  return true;
}

}  // namespace gt
