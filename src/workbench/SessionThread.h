#pragma once
#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "console/Console.h"

namespace gt {

/// The data about a robot for the lists of a window.
struct RobotInfo {
  std::string name;
  RobotKind kind = RobotKind::simulated;
  bool onLog = false;
  bool inScene = false;
  bool selected = false;
};

/// An unsaved recording of a robot.
struct RecordingInfo {
  std::string robot;
  std::uint64_t messages = 0;
};

/// The present position of a log that a robot runs on.
struct LogPlace {
  std::string robot, file;
  bool playing = false, loop = false;
  double speed = 1;
  double begin = 0, now = 0, end = 0;  ///< s
  std::uint64_t message = 0, messages = 0;
};

/// The status of a session for a window.
struct SessionStatus {
  Time time;
  bool started = false;
  double pace = 0;   ///< Greatest multiple of real time; 0: as fast as possible.
  double speed = 0;  ///< Simulated time divided by real time, over the last second.
  bool gameOver = false;
  GameState state = GameState::initial;
  std::array<int, 2> score{};
  std::string scene;
  std::uint64_t seed = 0;
  std::uint64_t beginnings = 0;  ///< How often the session was restarted or resumed.
  std::vector<RobotInfo> robots;
  std::vector<RecordingInfo> recordings;
  std::optional<LogPlace> log;  ///< Of the first selected robot that runs on a log.
};

/// A session and its console on a thread of their own, so that a window stays responsive. The
/// window executes command lines, and asks questions, which are answered between two steps, even
/// while a command such as `run` is executed.
class SessionThread {
 public:
  using Done = std::function<void(const Result<void>&)>;

  /// `foxglove` is the access for viewers (Session::serveFoxglove).
  static Result<std::unique_ptr<SessionThread>> make(const MatchOptions& options,
                                                     const FoxgloveAccess& foxglove = {});
  ~SessionThread();  ///< Interrupts the running command.
  /// To be called when a signal ends the program: ends the thread, and calls
  /// Console::keepRecordings().
  std::vector<Result<std::string>> end();
  SessionThread(const SessionThread&) = delete;
  SessionThread& operator=(const SessionThread&) = delete;

  /// The root of the data files.
  const DataRoot& root() const { return root_; }

  /// Executes a command line after those that are already queued. The line and its error are
  /// printed. `done` is called on the window's thread, unless `receiver` is gone by then; with an
  /// error if the line was discarded.
  void execute(std::string line, QObject* receiver = nullptr, Done done = {});
  /// As `execute`, for one robot, independent of the selection.
  void executeFor(std::string robot, std::string line, QObject* receiver = nullptr, Done done = {});
  /// Executes a line that no person typed: only its error is printed, and it is never discarded.
  void executeQuietly(std::string line);
  /// Executes the scene's start script.
  void callStartScript();
  /// Calls `work` on the session's thread between two commands; it may change the session.
  void change(std::function<void(Console&)> work);
  /// Calls `work` with the console on the session's thread, and then `show` with the result on the
  /// window's thread, unless `receiver` is gone by then. `work` must not let time pass.
  template <typename Work, typename Show>
  void ask(QObject* receiver, Work work, Show show) {
    post([guard = QPointer<QObject>{receiver}, work = std::move(work),
          show = std::move(show)](Console& console) mutable {
      auto answer = std::make_shared<decltype(work(console))>(work(console));
      inWindow([guard = std::move(guard), show = std::move(show), answer] {
        if (guard) show(*answer);
      });
    });
  }
  /// Data that are made repeatedly for a window, on the session's thread.
  class Supply {
   public:
    /// To be called while the data are visible; otherwise they are not made.
    void renew() { renewed_ = std::chrono::steady_clock::now(); }

   private:
    friend SessionThread;
    std::function<void(Console&, const std::shared_ptr<Supply>&)> make_;
    std::atomic<std::chrono::steady_clock::time_point> renewed_ = std::chrono::steady_clock::now();
    std::atomic<int> unseen_ = 0;  ///< Number of results that are not shown yet.
    std::uint64_t version_ = 0;    ///< From here on: when the data were made last.
    Time time_;
    std::chrono::steady_clock::time_point made_, rest_;  ///< Until when it is not made again.
  };
  /// Calls `work` and `show` as `ask` does, repeatedly as the session changes, for as long as the
  /// supply exists: in real time after each 40 ms of the session's time, so that none of a camera's
  /// images is left out.
  template <typename Work, typename Show>
  [[nodiscard]] std::shared_ptr<Supply> supply(QObject* receiver, Work work, Show show) {
    auto made = std::make_shared<Supply>();
    made->make_ = [guard = QPointer<QObject>{receiver}, work = std::move(work),
                   show = std::move(show)](Console& console, const std::shared_ptr<Supply>& self) {
      auto answer = std::make_shared<decltype(work(console))>(work(console));
      ++self->unseen_;
      inWindow([guard, show, answer, self] {
        --self->unseen_;
        if (guard) show(*answer);
      });
    };
    const std::lock_guard lock{mutex_};
    newSupplies_.push_back(made);
    return made;
  }
  /// Ends a command that lets time pass after its current step, and discards the queued command
  /// lines.
  void interrupt();
  /// Whether a command is executed or queued.
  bool busy() const { return busy_; }
  /// The command line that is executed; empty if none is.
  std::string current() const;

  /// A copy of the newest status.
  SessionStatus status() const;
  /// Increases with each step and each command, after which a window's content may have changed.
  std::uint64_t version() const { return version_; }
  /// The lines that were printed after the first `seen` ones; advances `seen`. Old lines are
  /// missing if there were too many. A line "\f" clears the lines before it.
  std::vector<std::string> linesSince(std::uint64_t& seen) const;
  /// The number of lines printed so far.
  std::uint64_t printed() const;
  /// Commands that were offered to the user since the last call (console command echo).
  std::vector<std::string> takeOffers();
  /// Whether the session was ended by the command exit.
  bool ended() const { return exited_; }

 private:
  using Task = std::function<void(Console&)>;
  struct Command {
    Task work;
    std::function<void()> discarded;  ///< Empty: it is never discarded.
  };
  class ThreadScreen;

  explicit SessionThread(DataRoot root);
  void run();
  void workOff();
  void post(Command command);
  void post(Task question);
  Result<void> perform(const std::string& line, bool quiet,
                       const std::optional<std::vector<std::string>>& robots = {});
  template <typename T>
  std::optional<T> take(std::deque<T>& queue);
  /// Answers questions, as long as there are any, for a limited time.
  void answer();
  /// Makes the supplies that are due.
  void makeSupplies();
  void stepped();
  void select();
  void updateStatus();
  void join();
  void print(std::string_view line);
  static void inWindow(std::function<void()> work);
  static Done reportTo(QObject* receiver, Done done);

  const DataRoot root_;
  std::unique_ptr<ThreadScreen> screen_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Console> console_;

  mutable std::mutex mutex_;  ///< Of what follows.
  std::condition_variable wake_;
  std::deque<Command> commands_;
  std::deque<Task> questions_;
  std::vector<std::weak_ptr<Supply>> newSupplies_;
  std::deque<std::string> lines_;
  std::uint64_t printed_ = 0;  ///< Lines so far.
  std::vector<std::string> offers_;
  std::string current_;
  SessionStatus status_;

  std::atomic<bool> ending_ = false, exited_ = false, busy_ = false;
  std::atomic<std::uint64_t> version_ = 1;
  std::uint64_t beginnings_ = 0;  ///< From here on of the session's thread only.
  Match* match_ = nullptr;
  std::vector<std::string> selection_;  ///< Of robots, before the session began anew.
  std::vector<std::weak_ptr<Supply>> supplies_;
  std::chrono::steady_clock::time_point answered_, measured_;
  std::chrono::milliseconds restAfterAnswers_{};
  Time lastTime_, measuredTime_;
  double speed_ = 0;
  std::thread thread_;
};

}  // namespace gt
