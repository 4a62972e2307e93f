#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace gt {

/// Threads that wait for work and share it: each index of a job is worked on by exactly one of
/// them. A job whose indices access disjoint data gives the same result with any number of threads.
class WorkerPool {
 public:
  using Work = std::function<void(std::size_t index, std::size_t worker)>;

  /// `threads` counts the calling thread; at least 1.
  explicit WorkerPool(std::size_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  std::size_t threads() const { return threads_.size() + 1; }

  /// Calls work(index, worker) for 0 .. count-1, worker in 0 .. threads()-1; returns when all is
  /// done. The calling thread works, too, and takes all indices that the others have not taken. Not
  /// to be called from within work.
  void forEach(std::size_t count, const Work& work);

 private:
  void run(std::size_t worker);
  void takeShare(std::size_t worker);
  bool take(std::size_t& index);

  std::vector<std::thread> threads_;
  const Work* work_ = nullptr;
  std::uint32_t count_ = 0;
  std::atomic<std::uint32_t> job_{0};
  /// Upper half: the number of the job. Lower half: how many of its indices no thread has taken
  /// yet. So a thread that is too late for one job never takes an index of the next one with the
  /// old work.
  std::atomic<std::uint64_t> open_{0};
  std::atomic<std::uint32_t> unfinished_{0};
  std::atomic<bool> stop_{false};
};

}  // namespace gt
