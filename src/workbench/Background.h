#pragma once
#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace gt {

/// Runs long work on a thread of its own, one at a time, for which neither the window nor the
/// session waits. The destructor stops the running work.
class Background {
 public:
  /// To be called by the work with the share that is done; returns false if the work must stop.
  using Progress = std::function<bool(double share)>;

  Background() = default;
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() { end(); }

  /// Calls `work(progress)`, and then `show` with its result on the window's thread, unless
  /// `receiver` is gone by then. Exceptions of `work` are rethrown there (Application). Work that
  /// was running before is stopped, and its result is not shown.
  template <typename Work, typename Show>
  void start(QObject* receiver, Work work, Show show) {
    end();
    state_ = std::make_shared<State>();
    thread_ = std::thread{[state = state_, guard = QPointer<QObject>{receiver},
                           work = std::move(work), show = std::move(show)]() mutable {
      std::shared_ptr<decltype(work(Progress{}))> result;
      std::exception_ptr thrown;
      try {
        result = std::make_shared<decltype(work(Progress{}))>(work([state](double share) {
          state->share = share;
          return !state->stopping;
        }));
      } catch (...) {
        thrown = std::current_exception();
      }
      state->ended = true;
      QMetaObject::invokeMethod(
          QCoreApplication::instance(),
          [state, guard, show = std::move(show), result, thrown] {
            if (!guard || state->forgotten) return;
            if (thrown) std::rethrow_exception(thrown);
            show(*result);
          },
          Qt::QueuedConnection);
    }};
  }
  /// Lets the work stop and return its results so far.
  void stop() {
    if (state_) state_->stopping = true;
  }
  bool running() const { return state_ && !state_->ended; }
  double share() const { return state_ ? state_->share.load() : 0; }

 private:
  struct State {
    std::atomic<bool> stopping = false, ended = false, forgotten = false;
    std::atomic<double> share = 0;
  };

  void end() {
    stop();
    if (state_) state_->forgotten = true;
    if (thread_.joinable()) thread_.join();
  }

  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace gt
