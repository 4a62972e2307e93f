#include "match/Match.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "robot/Configuration.h"

namespace gt {
namespace {

MatchEvent toMatchEvent(const GameEvent& event) {
  return {event.time,      std::string{enumName(event.type)},
          describe(event), event.team,
          event.number,    event.ownGoal,
          event.scoreRed,  event.scoreBlue};
}

std::string clock(Time time) {
  const auto seconds = time.ms / 1000;
  const std::string s = std::to_string(seconds % 60);
  return std::to_string(seconds / 60) + (s.size() < 2 ? ":0" : ":") + s;
}

/// A penalty as people say it: ball holding.
std::string penaltyText(Penalty penalty) {
  std::string text;
  for (const char c : enumName(penalty)) {
    if (std::isupper(c)) text += ' ';
    text += static_cast<char>(std::tolower(c));
  }
  return text;
}

}  // namespace

std::string describe(const GameEvent& event) {
  const std::string team{enumName(event.team)};
  const std::string score = std::to_string(event.scoreRed) + ":" + std::to_string(event.scoreBlue);
  const std::string player = event.number > 0 ? " " + std::to_string(event.number) : "";
  switch (event.type) {
    case GameEventType::kickOff:
      return "Kick-off for " + team;
    case GameEventType::goal:
      return "Goal for " + team +
             (event.ownGoal
                  ? ", an own goal by " + std::string{enumName(opponent(event.team))} + player
                  : " by player" + player) +
             ": " + score;
    case GameEventType::halfTime:
      return "Half time, " + score;
    case GameEventType::stuckBall:
      return "The ball is stuck and put elsewhere";
    case GameEventType::ballOut:
      return "The ball is out and put back";
    case GameEventType::placedRobot:
      return "The referee puts " + team + player + " in its place";
    case GameEventType::penalty:
      return "The referee takes " + team + player + " off the field: " + penaltyText(event.penalty);
    case GameEventType::returnedRobot:
      return team + player + " comes back";
    case GameEventType::shotGoal:
      return "Penalty shot of " + team + player + ": goal, " + score;
    case GameEventType::shotMissed:
      return "Penalty shot of " + team + player + ": missed, " + score;
    case GameEventType::gameOver:
      return "The game is over, " + score;
  }
  return "";
}

Result<std::unique_ptr<Match>> Match::make(const MatchOptions& options) {
  auto scene = loadScene(options.scene);
  if (!scene) return scene.error();
  scene->game.minutes = options.minutes;
  const auto configuration =
      loadConfiguration({scene->resolve(scene->config), options.motions, options.behavior});
  if (!configuration) return configuration.error();
  std::unique_ptr<Match> match{new Match{options}};
  auto simulation =
      Simulation::make(*scene, options.seed, options.threads, *(*configuration)->field);
  if (!simulation) return simulation.error();
  match->simulation_ = std::move(*simulation);
  match->configuration_ = *configuration;
  if (const auto done = match->addRobots(*configuration); !done) return done.error();
  if (options.gameControllerPort != 0) {
    auto link = GameControllerLink::listen(options.gameControllerPort);
    if (!link) return link.error();
    match->gameController_ = std::move(*link);
  }
  match->statistics_ = std::make_unique<MatchStatistics>(*match->simulation_, match->allRobots_,
                                                         *(*configuration)->motions);
  return match;
}

Result<void> Match::addRobots(const std::shared_ptr<const Configuration>& configuration) {
  const SceneDescription& scene = simulation_->scene();
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const auto layout = loadLayout(options_.layout.empty() ? scene.resolve(scene.robots[i].layout)
                                                           : options_.layout);
    if (!layout) return layout.error();
    auto added = isRemote(scene.robots[i].name) ? addRemoteRobot(i, *layout)
                                                : addRobot(i, *layout, configuration);
    if (!added) return added;
  }
  for (const auto& [name, endpoint] : options_.remote)
    if (std::none_of(scene.robots.begin(), scene.robots.end(),
                     [&, &robotName = name](const SceneRobot& r) { return r.name == robotName; }))
      return Error{options_.scene, 0, name, "the scene has no such robot"};
  return {};
}

bool Match::isRemote(const std::string& robot) const {
  return options_.remote.count(robot) > 0;
}

Result<void> Match::addRobot(std::size_t index, const Layout& layout,
                             const std::shared_ptr<const Configuration>& configuration) {
  const SceneRobot& player = simulation_->scene().robots[index];
  const std::uint64_t seed = Random{options_.seed}.fork(player.name)();
  auto robot = Robot::make(
      {configuration, layout, player.player(), seed, platformRepresentations(), player.address});
  if (!robot) return robot.error();
  auto controller = std::make_unique<SimulatedRobot>(player.name, std::move(*robot));
  const SceneDescription& scene = simulation_->scene();
  const SetupFiles setup{{scene.resolve(scene.config), options_.motions, options_.behavior},
                         options_.layout.empty() ? scene.resolve(player.layout) : options_.layout,
                         player.player(),
                         seed,
                         player.address};
  controller->robot().tellSetup([setup] { return recordSetup(setup); });
  if (!options_.logs.empty()) {
    controller->saveTo((std::filesystem::path{options_.logs} / player.name).string());
    const McapWriter::Metadata about{
        {"scene", std::filesystem::path{options_.scene}.filename().string()},
        {"seed", std::to_string(options_.seed)},
        {"robot", player.name},
        {"minutes", std::to_string(options_.minutes)}};
    const auto path = std::filesystem::path{options_.logs} / (player.name + ".mcap");
    if (auto done =
            controller->record(path.string(), about, configuration->log, setup, options_.inputs);
        !done)
      return done;
    const DebugRequest decisions{"BehaviorControl/trace", DebugKeyMode::always, 0};
    if (options_.trace)
      if (auto done = controller->robot().request(decisions); !done) return done;
  }
  simulation_->setCamera(
      index, withSettings(simulation_->scene().camera, configuration->camera.of(player.address)));
  robots_.push_back(controller.get());
  indices_.push_back(index);
  allRobots_.push_back(controller.get());
  simulation_->attach(index, std::move(controller));
  return {};
}

Result<void> Match::addRemoteRobot(std::size_t index, const Layout& layout) {
  const auto plan = robotPlan(layout, platformRepresentations());
  if (!plan) return plan.error();
  spoil("robots outside take part");
  const std::string folder = options_.sockets.empty() ? defaultSocketFolder() : options_.sockets;
  RobotAddresses addresses{folder, simulation_->scene().robots[index].name, {}};
  if (const std::string& endpoint = options_.remote.at(addresses.robot); !endpoint.empty())
    addresses.elsewhere[platformProcess] = endpoint;
  auto controller = RemoteRobot::make(addresses, *plan, options_.keys);
  if (!controller) return controller.error();
  remoteRobots_.push_back(controller->get());
  allRobots_.push_back(controller->get());
  simulation_->attach(index, std::move(*controller));
  return {};
}

void Match::step() {
  if (options_.pictures > 0) keepPicture();
  if (gameController_) hearGameController();
  simulation_->step();
  statistics_->update();
}

/// Spread over the match and the robots: when a picture's time has come, the next picture of the
/// next robot is kept.
void Match::keepPicture() {
  if (requestedPicture_ >= 0) {
    const auto requested = static_cast<std::size_t>(requestedPicture_);
    auto drawings = robots_[requested]->takeDrawings();
    if (!drawings.empty()) {
      const std::size_t index = indices_[requested];
      pictures_.push_back({simulation_->scene().robots[index].name + " at " + clock(time()),
                           simulation_->image(index), std::move(drawings)});
      requestedPicture_ = -1;
    }
  }
  const double total = options_.minutes * 60'000;
  const auto due =
      static_cast<std::size_t>(static_cast<double>(time().ms) / total * options_.pictures);
  if (requestedPicture_ < 0 && pictures_.size() < due && !robots_.empty()) {
    requestedPicture_ = static_cast<int>(pictures_.size() * 3 % robots_.size());
    robots_[static_cast<std::size_t>(requestedPicture_)]->requestDrawings();
  }
}

Result<void> Match::close() {
  Result<void> first;
  for (SimulatedRobot* robot : robots_)
    if (auto done = robot->closeLog(); !done && first) first = done;
  return first;
}

MatchSummary Match::summary() const {
  MatchSummary summary;
  summary.scene = std::filesystem::path{options_.scene}.filename().string();
  summary.seed = options_.seed;
  summary.duration = simulation_->time();
  summary.redScore = simulation_->referee().score(TeamColor::red);
  summary.blueScore = simulation_->referee().score(TeamColor::blue);
  for (const GameEvent& event : simulation_->referee().events())
    summary.events.push_back(toMatchEvent(event));
  statistics_->summarize(summary);
  for (RobotSummary& robot : summary.robots) {
    if (!options_.logs.empty() && !isRemote(robot.name)) robot.log = robot.name + ".mcap";
    for (const GameEvent& event : simulation_->referee().events()) {
      if (event.type != GameEventType::goal || event.number != robot.player) continue;
      robot.goals += !event.ownGoal && event.team == robot.team;
      robot.ownGoals += event.ownGoal && event.team != robot.team;
    }
  }
  return summary;
}

std::vector<PartTime> Match::times() const {
  std::vector<PartTime> parts;
  const auto add = [&](const Stopwatch& watch) {
    if (watch.count == 0) return;
    auto part = std::find_if(parts.begin(), parts.end(),
                             [&](const PartTime& p) { return p.part == watch.name; });
    if (part == parts.end()) part = parts.insert(parts.end(), PartTime{watch.name, 0, 0});
    part->count += watch.count;
    part->totalMs += watch.totalMs;
  };
  for (const SimulatedRobot* robot : robots_)
    for (const auto& process : robot->robot().processes())
      for (const Stopwatch& watch : process->times()) add(watch);
  for (const Stopwatch* watch : simulation_->times()) add(*watch);
  for (const SimulatedRobot* robot : robots_) add(robot->logTime());
  return parts;
}

}  // namespace gt
