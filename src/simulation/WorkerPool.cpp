#include "simulation/WorkerPool.h"

#include <algorithm>

namespace gt {

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
  work_ = &work;
  count_ = count;
  next_ = 0;
  busy_ = threads_.size();
  ++job_;
  job_.notify_all();
  takeShare(0);
  for (std::size_t busy = busy_; busy > 0; busy = busy_) busy_.wait(busy);
}

void WorkerPool::run(std::size_t worker) {
  for (std::uint32_t done = 0;;) {
    job_.wait(done);
    done = job_;
    if (stop_) return;
    takeShare(worker);
    if (--busy_ == 0) busy_.notify_one();
  }
}

void WorkerPool::takeShare(std::size_t worker) {
  for (std::size_t i = next_++; i < count_; i = next_++) (*work_)(i, worker);
}

}  // namespace gt
