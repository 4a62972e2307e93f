#include "session/Session.h"

#include <algorithm>
#include <cstdio>
#include <thread>
#include <utility>

#include "simulation/PutText.h"
#include "views/ViewText.h"

namespace gt {
namespace {

/// If the session is later than this, the clock is reset instead of catching up.
constexpr std::chrono::milliseconds farBehind{100};
/// If the clock was reset by this in all, the session does not reach its pace.
constexpr std::chrono::milliseconds tooFarBehind{500};
/// Longest time that a remote robot may take for its first answer.
constexpr std::chrono::milliseconds connecting{1500};

FoxgloveTruth truthOf(const Simulation& simulation) {
  FoxgloveTruth truth;
  const World& world = simulation.world();
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    const Player& player = simulation.players()[i];
    truth.robots.push_back(
        {std::string{enumName(player.teamColor)} + std::to_string(player.number()),
         player.teamColor, world.robot(i).origin()});
  }
  for (std::size_t i = 0; i < world.ballCount(); ++i) {
    foxglove::TrueBody ball{.name = "ball" + std::to_string(i)};
    truth.ballRadius = world.ballRadius(i);
    ball.pose.translation = {world.ball(i).position.x(), world.ball(i).position.y(),
                             truth.ballRadius};
    truth.balls.push_back(ball);
  }
  return truth;
}

}  // namespace

Result<std::unique_ptr<Session>> Session::make(const MatchOptions& options, Screen& screen) {
  std::unique_ptr<Session> session{new Session{screen}};
  if (auto done = session->restart(options); !done) return done.error();
  return session;
}

Result<void> Session::restart(const MatchOptions& options) {
  // The same logs may be written anew.
  if (state_.match && !options_.logs.empty())
    if (const auto done = state_.match->close(); !done) screen_.print(done.error().text());
  auto match = Match::make(options);
  if (!match) return match.error();
  if (foxglove_) foxglove_->forget();
  state_.robots.clear();  // they still need the match
  state_ = {};
  work(**match);
  state_.owned = std::move(*match);
  options_ = options;
  behavior.clear();
  setPace(pace_);
  for (const std::string& line : describePuts(simulation())) screen_.print(line);
  for (const Error& warning : simulation().modelWarnings()) screen_.print(warning.text());
  return {};
}

/// Makes the session's robots those of a match.
void Session::work(Match& match) {
  state_.match = &match;
  for (std::size_t i = 0; i < match.robots().size(); ++i)
    state_.robots.push_back(makeSimulatedRobot(*match.robots()[i], match.robotIndex(i)));
}

Result<void> Session::load(const std::string& file,
                           const std::function<Result<void>(const std::string& line)>& perform) {
  if (foxglove_) foxglove_->forget();
  if (!options_.logs.empty())
    if (const auto done = state_.match->close(); !done) screen_.print(done.error().text());
  State before = std::exchange(state_, {});
  const std::string behaviorBefore = std::exchange(behavior, {});
  auto match = Match::load(file, options_, [&](Match& made, const std::string& line) {
    if (state_.match != &made) work(made);
    return perform(line);
  });
  if (!match) {
    if (foxglove_) foxglove_->forget();
    state_ = std::move(before);
    behavior = behaviorBefore;
    return match.error();
  }
  if (!state_.match) work(**match);
  state_.owned = std::move(*match);
  state_.reportedEvents = simulation().referee().events().size();
  state_.reportedFailures = state_.match->failures().size();
  options_ = state_.match->options();
  setPace(pace_);
  return {};
}

SceneTree& Session::tree() {
  if (!state_.tree) state_.tree = std::make_unique<SceneTree>(simulation());
  return *state_.tree;
}

bool Session::tick() {
  if (simulation().finished() || !state_.match->teamFailure()) return false;
  if (input_) input_();
  state_.match->step();
  if (state_.connection) state_.connection->step();
  for (const auto& robot : state_.robots)
    if (const auto done = robot->step(time()); !done) screen_.print(done.error().text());
  std::erase_if(listeners_, [](const auto& listener) { return listener.expired(); });
  for (std::size_t i = 0; i < listeners_.size(); ++i)
    if (const auto work = listeners_[i].lock()) (*work)();
  reportNews();
  updateFoxglove();
  screen_.stepped();
  return true;
}

bool Session::step() {
  if (!tick()) return false;
  if (const auto time = due()) std::this_thread::sleep_until(*time);
  return true;
}

Session::RunEnd Session::run(const std::function<bool()>& done) {
  beginPace();
  while (!done()) {
    if (takeInterrupt()) return RunEnd::interrupted;
    if (!step()) return RunEnd::gameOver;
  }
  return RunEnd::done;
}

void Session::start() {
  started_ = true;
  setPace(pace_);
}

void Session::update(std::chrono::milliseconds atMost) {
  const auto end = Clock::now() + atMost;
  if (!started_) {
    if (input_) input_();
    listen();
    reportNews();
    return;
  }
  for (auto next = due(); started_ && Clock::now() < end; next = due()) {
    if (next && *next > Clock::now()) {
      std::this_thread::sleep_until(std::min(*next, end));
    } else if (!tick()) {
      stop();
      screen_.print(clockText(time()) + "  the game is over, so time stands");
    }
  }
}

bool Session::waitFor(const std::function<bool()>& holds, std::chrono::milliseconds patience) {
  const auto end = Clock::now() + patience;
  while (!holds()) {
    if (Clock::now() >= end || interrupted_) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
    listen();
  }
  return true;
}

std::shared_ptr<const void> Session::afterSteps(std::function<void()> work) {
  auto listener = std::make_shared<const std::function<void()>>(std::move(work));
  listeners_.push_back(listener);
  return listener;
}

void Session::listen() {
  if (state_.connection) state_.connection->step();
  for (const auto& robot : state_.robots)
    if (!robot->index()) robot->observed().update();
  updateFoxglove();
}

void Session::reportNews() {
  const auto& events = simulation().referee().events();
  for (; state_.reportedEvents < events.size(); ++state_.reportedEvents) {
    const std::string text = describe(events[state_.reportedEvents]);
    screen_.print(clockText(events[state_.reportedEvents].time) + "  " + text);
    if (foxglove_) foxglove_->log("referee", text);
  }
  for (const std::string& line : state_.match->takeGameControllerNews()) {
    screen_.print(line);
    if (foxglove_) foxglove_->log("referee", line, Severity::warning);
  }
  if (foxglove_)
    for (const std::string& line : foxglove_->takeNews()) screen_.print(line);
  const auto& failures = state_.match->failures();
  for (; state_.reportedFailures < failures.size(); ++state_.reportedFailures)
    screen_.print(failures[state_.reportedFailures].error.text());
  for (const Error& error : state_.match->takeLogErrors()) screen_.print(error.text());
  for (const auto& robot : state_.robots) {
    for (const std::string& text : robot->observed().takeTexts())
      if (robot->printsTexts) screen_.print(robot->name() + ": " + text);
    if (const auto error = robot->recorder.takeError())
      screen_.print(robot->name() + ": " + error->text());
  }
  if (state_.connection)
    for (const std::string& line : state_.connection->news()) screen_.print(line);
}

Result<void> Session::serveFoxglove(const FoxgloveAccess& access) {
  auto server = FoxgloveServer::open(access, "GT2003: " + options_.scene);
  if (!server) return server.error();
  foxglove_ = std::move(*server);
  return {};
}

void Session::updateFoxglove() {
  if (!foxglove_) return;
  FoxgloveSubject subject{.now = time(), .field = match().configuration().get<FieldDimensions>()};
  for (const auto& robot : state_.robots) subject.robots.push_back(&robot->observed());
  subject.truth = [this] { return truthOf(simulation()); };
  subject.parameterChanged = [this] {
    match().markIrreproducible("a viewer has changed parameters");
  };
  foxglove_->update(subject);
}

std::optional<Session::Clock::time_point> Session::due() {
  // Robots elsewhere run in real time.
  const double factor = state_.connection && pace_.factor == 0 ? 1 : pace_.factor;
  if (factor == 0) return std::nullopt;
  const std::chrono::duration<double, std::milli> simulated{
      static_cast<double>(time() - paceTime_) / factor};
  const auto due = paceBegin_ + std::chrono::duration_cast<Clock::duration>(simulated);
  const auto now = Clock::now();
  if (now > due + farBehind) {
    paceBegin_ += now - due;
    reportSlowness();
  }
  return due;
}

void Session::reportSlowness() {
  if (slownessReported_ || pace_.factor == 0 || paceBegin_ - paceSince_ < tooFarBehind) return;
  slownessReported_ = true;
  const std::chrono::duration<double, std::milli> passed = Clock::now() - paceSince_;
  char line[120];
  std::snprintf(line, sizeof line,
                "time passes %.2g times as fast as real time, not %g: the computer is too slow",
                static_cast<double>(time() - paceTime_) / passed.count(), pace_.factor);
  screen_.print(line);
}

void Session::beginPace() {
  paceBegin_ = paceSince_ = Clock::now();
  paceTime_ = time();
}

void Session::setPace(const Pace& pace) {
  pace_ = pace;
  if (pace.slowness > 0)
    match().markIrreproducible("how long robots took was measured by the clock");
  beginPace();
  slownessReported_ = false;
  for (SimulatedRobot* robot : state_.match->robots()) robot->setSlowness(pace.slowness);
}

ConsoleRobot* Session::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(state_.robots, [&](const auto& robot) { return robot->name() == name; });
  return found == state_.robots.end() ? nullptr : found->get();
}

Result<void> Session::replay(const std::string& name, const std::string& file,
                             const std::string& colorTable) {
  if (find(name)) return Error{.field = name, .what = "there is already a robot of this name"};
  auto robot = makeLogRobot(name, file, logOptions(colorTable), time());
  if (!robot) return robot.error();
  match().markIrreproducible("a robot runs on a log");
  state_.robots.push_back(std::move(*robot));
  while (const auto warning = state_.robots.back()->onLog()->takeWarning())
    screen_.print(warning->text());
  alignLogs();
  return {};
}

/// Lets logs that have not been played yet begin in step with those that are running at that time:
/// the later ones wait.
void Session::alignLogs() {
  std::vector<LogPlayer*> logs;
  for (const auto& robot : state_.robots)
    if (robot->onLog()) logs.push_back(&robot->onLog()->player());
  std::ranges::sort(logs, {}, &LogPlayer::begin);
  for (LogPlayer* log : logs) {
    if (log->position() > 0) continue;
    Time start = log->begin();
    for (const LogPlayer* other : logs)
      if (other != log && other->begin() <= log->begin() && log->begin() <= other->end())
        start = std::min(start, other->time());
    log->waitFrom(start);
  }
}

Time Session::timeOnLog(const LogPlayer& log, Time time) const {
  Time start = log.begin();
  for (const auto& robot : state_.robots) {
    if (!robot->onLog()) continue;
    const LogPlayer& other = robot->onLog()->player();
    if (other.begin() <= log.begin() && log.begin() <= other.end())
      start = std::min(start, other.begin());
  }
  return std::max(start, time);
}

Result<void> Session::connect(const std::vector<std::string>& robots, bool gameManager) {
  if (state_.connection) return Error{.field = "sc", .what = "robots are connected already"};
  auto connection = RobotConnection::open(robots, gameManager, options_.root, options_.keys);
  if (!connection) return connection.error();
  auto connected = (*connection)->takeRobots();
  for (const auto& robot : connected)
    if (find(robot->name()))
      return Error{.field = robot->name(), .what = "there is already a robot of this name"};
  state_.connection = std::move(*connection);
  match().markIrreproducible("robots run elsewhere");
  for (auto& robot : connected) state_.robots.push_back(std::move(robot));
  if (gameManager) screen_.print("game manager: " + state_.connection->gameManager());
  waitFor([&] { return state_.connection->silent().empty(); }, connecting);
  reportNews();
  for (const auto& robot : state_.connection->silent())
    screen_.print("router: " + robot.robot + " does not answer" +
                  (robot.trouble.empty() ? "" : " (" + robot.trouble + ")") +
                  "; it is connected as soon as it does");
  return {};
}

}  // namespace gt
