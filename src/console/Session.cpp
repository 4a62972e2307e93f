#include "console/Session.h"

#include <algorithm>
#include <thread>

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
  robots_.clear();
  connection_.reset();
  match_ = std::move(*match);
  options_ = options;
  for (std::size_t i = 0; i < match_->robots().size(); ++i)
    robots_.push_back(makeSimulatedRobot(*match_->robots()[i], match_->robotIndex(i)));
  toldEvents_ = 0;
  deeds_.clear();
  recorders_.clear();
  behavior.clear();
  setPace(pace_);
  return {};
}

bool Session::step() {
  if (simulation().finished()) return false;
  match_->step();
  if (connection_) connection_->step();
  for (const auto& robot : robots_)
    if (const auto done = robot->step(time()); !done) screen_.print(done.error().text());
  for (const auto& recorder : recorders_) recorder();
  tellNews();
  wait();
  screen_.stepped();
  return true;
}

void Session::tellNews() {
  const auto& events = simulation().referee().events();
  for (; toldEvents_ < events.size(); ++toldEvents_)
    screen_.print(clockText(events[toldEvents_].time) + "  " + describe(events[toldEvents_]));
  for (const auto& robot : robots_)
    for (const std::string& text : robot->memory().takeTexts())
      if (robot->printsTexts) screen_.print(robot->name() + ": " + text);
  if (connection_)
    for (const std::string& line : connection_->news()) screen_.print(line);
}

void Session::wait() {
  // Robots elsewhere live in real time.
  const double factor = connection_ && pace_.factor == 0 ? 1 : pace_.factor;
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
  paceBegin_ = Clock::now();
  paceTime_ = time();
  for (SimulatedRobot* robot : match_->robots()) robot->setSlowness(pace.slowness);
}

ConsoleRobot* Session::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(robots_, [&](const auto& robot) { return robot->name() == name; });
  return found == robots_.end() ? nullptr : found->get();
}

Result<void> Session::replay(const std::string& name, const std::string& file) {
  if (find(name)) return Error{"", 0, name, "there is already a robot of this name"};
  auto robot = makeLogRobot(name, file, match_->configuration(), time());
  if (!robot) return robot.error();
  robots_.push_back(std::move(*robot));
  return {};
}

Result<void> Session::connect(const std::vector<std::string>& robots, bool gameManager) {
  if (connection_) return Error{"", 0, "sc", "robots are connected already"};
  auto connection = RobotConnection::open(robots, gameManager);
  if (!connection) return connection.error();
  auto connected = (*connection)->takeRobots();
  for (const auto& robot : connected)
    if (find(robot->name()))
      return Error{"", 0, robot->name(), "there is already a robot of this name"};
  connection_ = std::move(*connection);
  for (auto& robot : connected) robots_.push_back(std::move(robot));
  if (gameManager) screen_.print("game manager: " + connection_->gameManager());
  return {};
}

}  // namespace gt
