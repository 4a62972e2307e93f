#include "simulation/WorkerPool.h"

#include <algorithm>
#include <exception>
#include <mutex>

namespace gt {
namespace {

/// Waits until a value differs from `old`. The next job mostly comes at once, and waking a sleeping
/// thread takes longer than many a job: so the thread first only yields.
void awaitChange(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  constexpr int looks = 500;  // some 200 us
  for (int i = 0; i < looks; ++i) {
    if (value != old) return;
    std::this_thread::yield();
  }
  value.wait(old);
}

/// Calls work and keeps its exception; of several exceptions that of the lowest index.
struct GuardedWork {
  const WorkerPool::Work& work;
  std::mutex mutex{};  ///< Of the following two.
  std::exception_ptr failure{};
  std::size_t failed = 0;  ///< The index whose work threw `failure`.

  void operator()(std::size_t index, std::size_t worker) {
    try {
      work(index, worker);
    } catch (...) {
      const std::lock_guard lock{mutex};
      if (failure && failed < index) return;
      failure = std::current_exception();
      failed = index;
    }
  }
};

}  // namespace

WorkerPool::WorkerPool(std::size_t threads) {
  threads_.reserve(std::max<std::size_t>(threads, 1) - 1);
  try {
    for (std::size_t worker = 1; worker < threads; ++worker)
      threads_.emplace_back([this, worker] { run(worker); });
  } catch (const std::exception&) {
  }
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
  GuardedWork job{work};
  const Work guarded = [&job](std::size_t index, std::size_t worker) { job(index, worker); };
  work_ = &guarded;
  count_ = static_cast<std::uint32_t>(count);
  unfinished_ = count_;
  open_ = static_cast<std::uint64_t>(job_ + 1) << 32 | count_;
  ++job_;
  job_.notify_all();
  takeShare(0);
  for (std::uint32_t left = unfinished_; left > 0; left = unfinished_)
    awaitChange(unfinished_, left);
  if (job.failure) std::rethrow_exception(job.failure);
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
