#include "workbench/SessionThread.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "base/Guarded.h"

namespace gt {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// Longest time that passes before commands and questions are processed, longest time for answering
/// questions at once, and interval at which they are answered while a command is executed.
constexpr milliseconds updateTime{10}, answerTime{20}, answerInterval{15}, restTime{20};
/// Time passes this many times as long as questions have taken, so that they cannot stop it.
constexpr int shareOfTime = 2;
/// A supply is made after `supplyInterval` of the session's time, and after `slowInterval` of real
/// time if time passes slowly or stands. The least real time between two of them is `fastInterval`,
/// or `leastInterval` if the session keeps to real time. A supply is not made if it was not renewed
/// for `lease`, or if `mostUnseen` results are not shown yet.
constexpr std::int64_t supplyInterval = 40;  // ms
constexpr milliseconds slowInterval{60}, fastInterval{40}, leastInterval{8}, lease{500};
constexpr int mostUnseen = 4;
/// A supply that takes much processor time rests this many times as long, so that it does not delay
/// the session and other supplies.
constexpr int restFactor = 5;
constexpr milliseconds speedInterval{1000};
constexpr std::size_t mostLines = 10000;

/// Processor time of this thread, which does not include other programs and threads.
std::chrono::nanoseconds processorTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

double seconds(Time time) {
  return static_cast<double>(time.ms) / 1000;
}

/// Whether time passes in real time at most.
bool isSlow(const Pace& pace) {
  return pace.factor > 0 && pace.factor <= 1;
}

Error discardedError() {
  return {.what = "the command was discarded"};
}

std::optional<LogPlace> logPlaceOf(const std::vector<ConsoleRobot*>& robots) {
  for (ConsoleRobot* robot : robots) {
    if (!robot->onLog()) continue;
    const LogPlayer& player = robot->onLog()->player();
    const std::uint64_t message = player.atEnd() || player.moments().empty()
                                      ? player.messages()
                                      : player.moments()[player.position()].first;
    return LogPlace{robot->name(),         player.path(),         player.playing(),
                    player.loop(),         player.speed(),        seconds(player.begin()),
                    seconds(player.now()), seconds(player.end()), message,
                    player.messages()};
  }
  return std::nullopt;
}

}  // namespace

/// Keeps what is printed for the window.
class SessionThread::ThreadScreen : public Screen {
 public:
  explicit ThreadScreen(SessionThread& owner) : owner_{owner} {}
  void print(std::string_view line) override { owner_.print(line); }
  void clear() override { owner_.print("\f"); }
  void stepped() override { owner_.stepped(); }

 private:
  SessionThread& owner_;
};

SessionThread::SessionThread(DataRoot root)
    : root_{std::move(root)}, screen_{std::make_unique<ThreadScreen>(*this)} {}

Result<std::unique_ptr<SessionThread>> SessionThread::make(const MatchOptions& options,
                                                           const FoxgloveAccess& foxglove) {
  std::unique_ptr<SessionThread> made{new SessionThread{options.root}};
  auto session = Session::make(options, *made->screen_);
  if (!session) return session.error();
  made->session_ = std::move(*session);
  if (!foxglove.endpoint.empty())
    if (const auto done = made->session_->serveFoxglove(foxglove); !done) return done.error();
  made->console_ = std::make_unique<Console>(*made->session_);
  made->updateStatus();
  made->thread_ = std::thread{[thread = made.get()] { thread->run(); }};
  return made;
}

SessionThread::~SessionThread() {
  join();
}

void SessionThread::join() {
  ending_ = true;
  if (session_) interrupt();
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::vector<Result<std::string>> SessionThread::end() {
  join();
  return console_->keepRecordings();
}

void SessionThread::run() {
  while (!ending_) {
    const auto done = guarded([this]() -> Result<void> {
      workOff();
      return {};
    });
    if (done) continue;
    session_->stop();  // or it would fail again and again
    print("error: " + done.error().text());
  }
}

/// Answers what was asked, executes what was given, and lets some time pass.
void SessionThread::workOff() {
  answer();
  while (auto command = take(commands_)) {
    session_->takeInterrupt();  // it was meant for an earlier one
    if (ending_) return;
    command->work(*console_);
    ++version_;
    updateStatus();
    answer();
    if (ending_) return;
  }
  if (console_->ended()) exited_ = true;
  const Time before = session_->time();
  session_->update(std::max(updateTime, restAfterAnswers_));
  if (session_->time() != before) ++version_;
  updateStatus();
  std::unique_lock lock{mutex_};
  busy_ = !commands_.empty();
  current_.clear();
  if (!session_->started() && !busy_ && questions_.empty() && !ending_)
    wake_.wait_for(lock, restTime);
}

void SessionThread::post(Command command) {
  {
    const std::lock_guard lock{mutex_};
    commands_.push_back(std::move(command));
    busy_ = true;
  }
  wake_.notify_one();
}

void SessionThread::post(Task question) {
  {
    const std::lock_guard lock{mutex_};
    questions_.push_back(std::move(question));
  }
  wake_.notify_one();
}

template <typename T>
std::optional<T> SessionThread::take(std::deque<T>& queue) {
  const std::lock_guard lock{mutex_};
  if (queue.empty()) return std::nullopt;
  T first = std::move(queue.front());
  queue.pop_front();
  return first;
}

void SessionThread::answer() {
  const auto begin = Clock::now(), end = begin + answerTime;
  while (!ending_ && Clock::now() < end) {
    const auto question = take(questions_);
    if (!question) break;
    (*question)(*console_);
  }
  makeSupplies();
  answered_ = Clock::now();
  restAfterAnswers_ = shareOfTime * std::chrono::duration_cast<milliseconds>(answered_ - begin);
}

void SessionThread::makeSupplies() {
  {
    const std::lock_guard lock{mutex_};
    std::ranges::move(newSupplies_, std::back_inserter(supplies_));
    newSupplies_.clear();
  }
  const milliseconds interval = isSlow(session_->pace()) ? leastInterval : fastInterval;
  const Time now = session_->time();
  std::erase_if(supplies_, [](const auto& supply) { return supply.expired(); });
  for (const auto& known : supplies_) {
    const auto supply = known.lock();
    if (!supply || supply->version_ == version_ || supply->unseen_ >= mostUnseen) continue;
    const auto begin = Clock::now();
    if (begin > supply->renewed_.load() + lease || begin < supply->rest_) continue;
    const bool due = now < supply->time_ || now - supply->time_ >= supplyInterval;
    if (!due && begin < supply->made_ + slowInterval) continue;
    supply->version_ = version_;
    supply->time_ = now;
    supply->made_ = begin;
    const auto before = processorTime();
    supply->make_(*console_, supply);
    supply->rest_ = begin + std::max(std::chrono::nanoseconds{interval},
                                     (restFactor + 1) * (processorTime() - before));
  }
}

void SessionThread::stepped() {
  ++version_;
  if (isSlow(session_->pace())) makeSupplies();  // no image may be left out
  if (Clock::now() < answered_ + std::max(answerInterval, restAfterAnswers_)) return;
  updateStatus();
  answer();
}

/// Executes a line on the session's thread, for some robots or for the selected ones.
Result<void> SessionThread::perform(const std::string& line, bool quiet,
                                    const std::optional<std::vector<std::string>>& robots) {
  {
    const std::lock_guard lock{mutex_};
    current_ = line;
  }
  if (!quiet) print("> " + line);
  auto done = guarded(
      [&] { return robots ? console_->executeFor(*robots, line) : console_->execute(line); });
  if (!done) print("error: " + done.error().text());
  auto offers = console_->takeOffers();
  const std::lock_guard lock{mutex_};
  std::ranges::move(offers, std::back_inserter(offers_));
  return done;
}

/// Calls back in the window's thread, if anyone waits for it.
SessionThread::Done SessionThread::reportTo(QObject* receiver, Done done) {
  if (!done) return [](const Result<void>&) {};
  return [guard = QPointer<QObject>{receiver}, done = std::move(done)](const Result<void>& result) {
    inWindow([guard, done, result] {
      if (guard) done(result);
    });
  };
}

void SessionThread::execute(std::string line, QObject* receiver, Done done) {
  const Done report = reportTo(receiver, std::move(done));
  post({[this, line = std::move(line), report](Console&) { report(perform(line, false)); },
        [report] { report(discardedError()); }});
}

void SessionThread::executeQuietly(std::string line) {
  change([this, line = std::move(line)](Console&) { static_cast<void>(perform(line, true)); });
}

void SessionThread::executeFor(std::string robot, std::string line, QObject* receiver, Done done) {
  const Done report = reportTo(receiver, std::move(done));
  post({[this, robot = std::move(robot), line = std::move(line), report](Console&) {
          report(perform(line, false, std::vector{robot}));
        },
        [report] { report(discardedError()); }});
}

void SessionThread::callStartScript() {
  change([this](Console& console) {
    if (const auto done = console.callStartScript(); !done) print("error: " + done.error().text());
  });
}

void SessionThread::change(std::function<void(Console&)> work) {
  post({std::move(work), {}});
}

void SessionThread::interrupt() {
  const std::lock_guard lock{mutex_};
  for (const Command& command : commands_)
    if (command.discarded) command.discarded();
  std::erase_if(commands_, [](const Command& command) { return command.discarded != nullptr; });
  session_->interrupt();
}

std::string SessionThread::current() const {
  const std::lock_guard lock{mutex_};
  return current_;
}

SessionStatus SessionThread::status() const {
  const std::lock_guard lock{mutex_};
  return status_;
}

std::vector<std::string> SessionThread::linesSince(std::uint64_t& seen) const {
  const std::lock_guard lock{mutex_};
  const std::uint64_t missing = std::min<std::uint64_t>(printed_ - seen, lines_.size());
  seen = printed_;
  return {lines_.end() - static_cast<std::ptrdiff_t>(missing), lines_.end()};
}

std::uint64_t SessionThread::printed() const {
  const std::lock_guard lock{mutex_};
  return printed_;
}

std::vector<std::string> SessionThread::takeOffers() {
  const std::lock_guard lock{mutex_};
  return std::exchange(offers_, {});
}

void SessionThread::print(std::string_view line) {
  const std::lock_guard lock{mutex_};
  lines_.emplace_back(line);
  ++printed_;
  if (lines_.size() > mostLines) lines_.pop_front();
}

void SessionThread::inWindow(std::function<void()> work) {
  if (auto* application = QCoreApplication::instance())
    QMetaObject::invokeMethod(application, std::move(work), Qt::QueuedConnection);
}

/// Selects the robots that were selected before the session began anew, or else the first one,
/// unless a script has.
void SessionThread::select() {
  if (!console_->selection().empty()) return;
  std::vector<std::string> names;
  for (const std::string& name : selection_)
    if (session_->find(name)) names.push_back(name);
  if (names.empty() && beginnings_ == 1 && !session_->robots().empty())
    names.push_back(session_->robots().front()->name());
  console_->select(std::move(names));
}

void SessionThread::updateStatus() {
  SessionStatus status;
  status.time = session_->time();
  status.started = session_->started();
  status.pace = session_->pace().factor;
  const auto now = Clock::now();
  status.scene = session_->options().scene;
  status.seed = session_->options().seed;
  // A new match may lie where the old one lay.
  if (match_ != &session_->match() || status.time < lastTime_ || status.scene != status_.scene ||
      status.seed != status_.seed) {
    ++beginnings_;
    select();
    match_ = &session_->match();
    measured_ = now;
    measuredTime_ = status.time;
  }
  lastTime_ = status.time;
  if (now > measured_ + speedInterval) {
    const std::chrono::duration<double, std::milli> passed = now - measured_;
    speed_ = static_cast<double>(status.time - measuredTime_) / passed.count();
    measured_ = now;
    measuredTime_ = status.time;
  }
  status.speed = speed_;
  status.gameOver = session_->match().finished();
  const Referee& referee = session_->simulation().referee();
  status.state = referee.state();
  status.score = {referee.score(TeamColor::red), referee.score(TeamColor::blue)};
  status.beginnings = beginnings_;
  selection_ = console_->selection();
  const auto selected = console_->selected();
  for (const auto& robot : session_->robots())
    status.robots.push_back({robot->name(), robot->observed().kind(), robot->onLog() != nullptr,
                             robot->index().has_value(),
                             std::ranges::find(selected, robot.get()) != selected.end()});
  for (const auto& robot : session_->robots())
    if (const std::uint64_t messages = robot->recorder.unsaved())
      status.recordings.push_back({robot->name(), messages});
  status.log = logPlaceOf(selected);
  const std::lock_guard lock{mutex_};
  status_ = std::move(status);
}

}  // namespace gt
