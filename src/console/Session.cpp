#include "console/Session.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace gt {
namespace {

/// Who falls further behind real time does not run to catch up.
constexpr std::chrono::milliseconds farBehind{100};

}  // namespace

std::string clockText(Time time) {
  const std::int64_t seconds = time.ms / 1000;
  const std::string s = std::to_string(seconds % 60);
  return std::to_string(seconds / 60) + (s.size() < 2 ? ":0" : ":") + s;
}

Result<std::unique_ptr<Session>> Session::make(const MatchOptions& options, Screen& screen) {
  std::unique_ptr<Session> session{new Session{screen}};
  if (auto done = session->restart(options); !done) return done.error();
  return session;
}

Result<void> Session::restart(const MatchOptions& options) {
  auto match = Match::make(options);
  if (!match) return match.error();
  state_ = {};
  work(**match);
  state_.owned = std::move(*match);
  options_ = options;
  behavior.clear();
  setPace(pace_);
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
  State before = std::exchange(state_, {});
  const std::string behaviorBefore = std::exchange(behavior, {});
  auto match = Match::load(file, options_, [&](Match& made, const std::string& line) {
    if (state_.match != &made) work(made);
    return perform(line);
  });
  if (!match) {
    state_ = std::move(before);
    behavior = behaviorBefore;
    return match.error();
  }
  if (!state_.match) work(**match);
  state_.owned = std::move(*match);
  state_.toldEvents = simulation().referee().events().size();
  options_ = state_.match->options();
  setPace(pace_);
  return {};
}

SceneTree& Session::tree() {
  if (!state_.tree) state_.tree = std::make_unique<SceneTree>(simulation());
  return *state_.tree;
}

bool Session::step() {
  if (simulation().finished()) return false;
  state_.match->step();
  if (state_.connection) state_.connection->step();
  for (const auto& robot : state_.robots)
    if (const auto done = robot->step(time()); !done) screen_.print(done.error().text());
  for (const auto& recorder : state_.recorders) recorder();
  tellNews();
  wait();
  screen_.stepped();
  return true;
}

void Session::tellNews() {
  const auto& events = simulation().referee().events();
  for (; state_.toldEvents < events.size(); ++state_.toldEvents)
    screen_.print(clockText(events[state_.toldEvents].time) + "  " +
                  describe(events[state_.toldEvents]));
  for (const auto& robot : state_.robots)
    for (const std::string& text : robot->memory().takeTexts())
      if (robot->printsTexts) screen_.print(robot->name() + ": " + text);
  if (state_.connection)
    for (const std::string& line : state_.connection->news()) screen_.print(line);
}

void Session::wait() {
  // Robots elsewhere live in real time.
  const double factor = state_.connection && pace_.factor == 0 ? 1 : pace_.factor;
  if (factor == 0) return;
  const std::chrono::duration<double, std::milli> simulated{
      static_cast<double>(time() - paceTime_) / factor};
  const auto due = paceBegin_ + std::chrono::duration_cast<Clock::duration>(simulated);
  const auto now = Clock::now();
  if (now > due + farBehind) paceBegin_ += now - due;
  std::this_thread::sleep_until(due);
}

void Session::setPace(const Pace& pace) {
  pace_ = pace;
  if (pace.slowness > 0) match().spoil("how long robots took was measured by the clock");
  paceBegin_ = Clock::now();
  paceTime_ = time();
  for (SimulatedRobot* robot : state_.match->robots()) robot->setSlowness(pace.slowness);
}

ConsoleRobot* Session::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(state_.robots, [&](const auto& robot) { return robot->name() == name; });
  return found == state_.robots.end() ? nullptr : found->get();
}

Result<void> Session::replay(const std::string& name, const std::string& file) {
  if (find(name)) return Error{"", 0, name, "there is already a robot of this name"};
  auto robot = makeLogRobot(name, file, state_.match->configuration(), time());
  if (!robot) return robot.error();
  match().spoil("a robot lives on a log");
  state_.robots.push_back(std::move(*robot));
  return {};
}

Result<void> Session::connect(const std::vector<std::string>& robots, bool gameManager) {
  if (state_.connection) return Error{"", 0, "sc", "robots are connected already"};
  auto connection = RobotConnection::open(robots, gameManager);
  if (!connection) return connection.error();
  auto connected = (*connection)->takeRobots();
  for (const auto& robot : connected)
    if (find(robot->name()))
      return Error{"", 0, robot->name(), "there is already a robot of this name"};
  state_.connection = std::move(*connection);
  match().spoil("robots live elsewhere");
  for (auto& robot : connected) state_.robots.push_back(std::move(robot));
  if (gameManager) screen_.print("game manager: " + state_.connection->gameManager());
  return {};
}

}  // namespace gt
