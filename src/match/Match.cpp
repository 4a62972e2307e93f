#include "match/Match.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <thread>

#include "base/File.h"
#include "base/Hash.h"
#include "measure/worlds/KickTables.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "robot/Configuration.h"
#include "simulation/scene/ProfileTable.h"
#include "streams/Json.h"
#include "streams/Type.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Whether a name is a robot's or its team's.
bool isNamed(const SceneRobot& robot, const std::string& name) {
  return name == robot.name || name == enumName(robot.team);
}

}  // namespace

Result<std::unique_ptr<Match>> Match::make(const MatchOptions& options) {
  const MatchSetup& setup = options;
  if (auto done = checked(valueOf(setup)); !done) return done.error();
  auto scene = loadScene(options.scene);
  if (!scene) return scene.error();
  if (auto found = findSceneFiles(*scene); !found) return found.error();
  if (options.minutes > 0) scene->game.minutes = options.minutes;
  if (!options.profile.empty()) {
    const auto profile = enumValue<Profile>(options.profile);
    if (!profile) return Error{.field = "profile", .what = "unknown: \"" + options.profile + "\""};
    setProfile(*scene, *profile);
  }
  if (!options.fidelity.empty()) {
    const auto fidelity = enumValue<Fidelity>(options.fidelity);
    if (!fidelity)
      return Error{.field = "fidelity", .what = "unknown: \"" + options.fidelity + "\""};
    scene->fidelity = *fidelity;
  }
  std::unique_ptr<Match> match{new Match{options}};
  match->options_.minutes = scene->game.minutes;
  auto teams = MatchTeams::load(match->options_, options.root, *scene);
  if (!teams) return teams.error();
  match->teams_ = std::move(*teams);
  const FieldDimensions& field = match->configuration().get<FieldDimensions>();
  if (scene->challenge && options.randomChallenge) scene->challenge->random = true;
  if (scene->challenge && scene->challenge->random)
    match->teams_.setTargets({randomTargets(field, Random{options.seed}.fork("targets"))});
  auto simulation = Simulation::make(*scene, options.seed, options.threads, field);
  if (!simulation) return simulation.error();
  match->simulation_ = std::move(*simulation);
  if (const auto done = match->setKicks(); !done) return done.error();
  if (const auto done = match->addRobots(); !done) return done.error();
  if (scene->challenge) {
    auto challenge = std::make_unique<Challenge>(
        *scene->challenge,
        match->teams_.of(TeamColor::red).configuration->get<TargetPoints>().points,
        Random{options.seed}.fork("challenge"));
    match->challenge_ = challenge.get();
    match->simulation_->add(std::move(challenge));
  }
  match->gameController_ =
      std::make_unique<GameControllerFollower>(*match->simulation_, match->allRobots_);
  if (!options.gameController.empty()) {
    const auto endpoint = parseEndpoint(options.gameController);
    if (!endpoint) return endpoint.error();
    if (auto done = match->gameController_->listen(*endpoint); !done) return done.error();
  }
  match->statistics_ = std::make_unique<MatchStatistics>(*match->simulation_, match->allRobots_,
                                                         match->kicks(), field);
  if (options.check)
    match->invariants_ = std::make_unique<Invariants>(*match->simulation_, match->allRobots_);
  match->images_ =
      std::make_unique<ReportImages>(options.images, scene->game.minutes, match->robots_);
  if (!options.logs.empty())
    if (const auto done = match->beginLogs(); !done) return done.error();
  return match;
}

Result<void> Match::setKicks() {
  const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::map<std::string, std::shared_ptr<const KickTable>> tables;  // by the motions' folder
  const std::vector<SceneRobot>& robots = simulation_->scene().robots;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const MatchTeam& team = teamOf(robots[i]);
    auto& table = tables[team.paths.motions];
    if (!table) {
      const Result<MotionNet> net = team.configuration ? team.configuration->get<MotionNet>()
                                                       : loadMotionNet(team.paths.motions);
      if (!net && team.program) continue;  // It reads them itself, and tells.
      if (!net) return net.error();
      auto kicks = kicksOfMotions(*net, team.paths, options_.root, threads);
      if (!kicks) return team.named(kicks.error());
      table = std::make_shared<KickTable>(*std::move(kicks));
    }
    simulation_->setKicks(i, table);
  }
  return {};
}

std::vector<std::vector<std::string>> Match::kicks() const {
  std::vector<std::vector<std::string>> all;
  for (const SceneRobot& robot : simulation_->scene().robots)
    if (const auto& own = teamOf(robot).configuration)
      all.push_back(kickNames(own->get<MotionNet>()));
    else
      all.emplace_back();
  forEachRobot<LockstepRobot>(
      [&](std::size_t index, const LockstepRobot& robot) { all[index] = robot.greeting().kicks; });
  return all;
}

Result<void> Match::addRobots() {
  const std::vector<SceneRobot>& robots = simulation_->scene().robots;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (teamOf(robots[i]).program && !isRemote(robots[i].name)) {
      if (auto added = addLockstepRobot(i); !added) return added;
      continue;
    }
    const auto layout = loadLayout(layoutFile(robots[i]));
    if (!layout) return layout.error();
    auto added = isRemote(robots[i].name) ? addRemoteRobot(i, *layout) : addRobot(i, *layout);
    if (!added) return added;
  }
  if (auto done = checkNames(); !done) return done;
  return greetLockstepRobots();
}

/// Checks that the scene has the robots that the options name, and that no robot in another program
/// gets the truth: such a robot gets only what its body senses.
Result<void> Match::checkNames() const {
  const std::vector<SceneRobot>& robots = simulation_->scene().robots;
  const auto wrong = [&](const std::string& name, const char* what) {
    return Error{.file = options_.scene, .field = name, .what = what};
  };
  for (const auto& [name, endpoint] : options_.remote)
    if (std::ranges::find(robots, name, &SceneRobot::name) == robots.end())
      return wrong(name, "the scene has no such robot");
  for (const std::string& name : options_.truth)
    if (std::ranges::none_of(robots, [&](const SceneRobot& r) { return isNamed(r, name); }))
      return wrong(name, "the scene has no such robot or team");
  for (const SceneRobot& robot : robots)
    if (getsTruth(robot) &&
        std::ranges::find(robots_, robot.name, &SimulatedRobot::name) == robots_.end())
      return wrong(robot.name, "runs in another program, which cannot be given the truth");
  return {};
}

bool Match::getsTruth(const SceneRobot& robot) const {
  return std::ranges::any_of(options_.truth,
                             [&](const std::string& name) { return isNamed(robot, name); });
}

std::string Match::layoutFile(const SceneRobot& robot) const {
  return options_.layout.empty() ? simulation_->scene().resolve(robot.layout) : options_.layout;
}

std::uint64_t Match::seedOf(const SceneRobot& robot) const {
  return Random{options_.seed}.fork(robot.name)();
}

Result<void> Match::addRobot(std::size_t index, const Layout& layout) {
  const SceneRobot& player = simulation_->scene().robots[index];
  const std::uint64_t seed = seedOf(player);
  const MatchTeam& team = teamOf(player);
  auto robot = SimulatedRobot::enter(
      *simulation_, index,
      {team.configuration, layout, player.player(), seed,
       getsTruth(player) ? representationsWithTruth() : platformRepresentations(), player.address});
  if (!robot) return team.named(robot.error());
  (*robot)->robot().provideSetup([setup = setupOf(player)] { return recordSetup(setup); });
  robots_.push_back(*robot);
  allRobots_.push_back(*robot);
  return {};
}

/// Attaches a robot as the next one of the scene.
void Match::attach(std::unique_ptr<MatchRobot> robot) {
  allRobots_.push_back(robot.get());
  simulation_->attach(allRobots_.size() - 1, std::move(robot));
}

SetupFiles Match::setupOf(const SceneRobot& robot) const {
  return {teamOf(robot).paths, layoutFile(robot), robot.player(), seedOf(robot), robot.address};
}

/// Replaces the logs of the previous match. To be called when nothing else of this match can fail.
Result<void> Match::beginLogs() {
  const fs::path folder{options_.logs};
  const SceneDescription& scene = simulation_->scene();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const SceneRobot& player = scene.robots[robotIndex(i)];
    const std::string base = (folder / player.name).string();
    const McapWriter::Metadata about{{"scene", fs::path{options_.scene}.filename().string()},
                                     {"seed", std::to_string(options_.seed)},
                                     {"robot", player.name},
                                     {"minutes", std::to_string(scene.game.minutes)}};
    robots_[i]->saveTo(base);
    if (auto done = robots_[i]->record(base + ".mcap", about, teamOf(player).configuration->log,
                                       setupOf(player), options_.inputs);
        !done)
      return done;
  }
  if (!scene.ceilingCamera) return {};
  auto log = McapWriter::open((folder / "ceiling.mcap").string());
  if (!log) return log.error();
  ceilingLog_ = std::move(*log);
  return {};
}

Result<void> Match::addRemoteRobot(std::size_t index, const Layout& layout) {
  const auto plan = robotPlan(layout, platformRepresentations());
  if (!plan) return plan.error();
  markIrreproducible("robots outside take part");
  const std::string folder = options_.sockets.empty() ? defaultSocketFolder() : options_.sockets;
  RobotAddresses addresses{folder, simulation_->scene().robots[index].name, {}};
  if (const std::string& endpoint = options_.remote.at(addresses.robot); !endpoint.empty())
    addresses.elsewhere[platformProcess] = endpoint;
  auto controller = RemoteRobot::make(addresses, *plan, options_.keys);
  if (!controller) return controller.error();
  attach(std::move(*controller));
  return {};
}

Result<void> Match::addLockstepRobot(std::size_t index) {
  const SceneRobot& player = simulation_->scene().robots[index];
  const MatchTeam& team = teamOf(player);
  const std::uint64_t seed = seedOf(player);
  std::vector<std::string> command{
      team.program->file,
      "--lockstep",
      "--root",
      team.program->root.path("."),
      "--robot",
      player.name,
      "--layout",
      team.program->root.path("layouts/" + fs::path{layoutFile(player)}.filename().string()),
      "--team",
      std::string{enumName(player.team)},
      "--role",
      std::string{enumName(player.player().role)},
      "--seed",
      std::to_string(seed),
      "--config",
      team.paths.config,
      "--motions",
      team.paths.motions,
      "--behavior",
      team.paths.behavior};
  if (!player.address.empty()) command.insert(command.end(), {"--address", player.address});
  auto controller = LockstepRobot::start(player.name, command, options_.patience);
  if (!controller) return controller.error();
  attach(std::move(*controller));
  return {};
}

/// To be called after all programs have been started, since they read their files at the same time.
Result<void> Match::greetLockstepRobots() {
  Result<void> all;
  forEachRobot<LockstepRobot>([&](std::size_t index, LockstepRobot& robot) {
    if (!all) return;
    if (auto done = robot.greet(); !done)
      all = teamOf(simulation_->scene().robots[index]).named(done.error());
    else
      simulation_->setCamera(index, robot.camera());
  });
  return all;
}

Result<void> Match::teamFailure() const {
  Result<void> first;
  forEachRobot<LockstepRobot>([&](std::size_t, const LockstepRobot& robot) {
    if (first && robot.failure()) first = *robot.failure();
  });
  return first;
}

std::vector<const RemoteRobot*> Match::remoteRobots() const {
  std::vector<const RemoteRobot*> all;
  forEachRobot<RemoteRobot>([&](std::size_t, const RemoteRobot& robot) { all.push_back(&robot); });
  return all;
}

std::size_t Match::robotIndex(std::size_t robot) const {
  return static_cast<std::size_t>(std::ranges::find(allRobots_, robots_[robot]) -
                                  allRobots_.begin());
}

void Match::step() {
  images_->step(time());
  gameController_->hear([this](std::span<const std::byte> message) {
    note(InterventionKind::gameController, hexOf(message));
  });
  simulation_->step();
  noteFailures();
  if (const auto* seen = simulation_->ceilingPercept(); seen && ceilingLog_)
    ceilingLog_->write(ceilingTopic, time(), *seen);
  statistics_->update();
  if (invariants_) invariants_->update();
}

Result<void> Match::control(std::span<const std::byte> message) {
  const auto changed = gameController_->follow(message);
  if (!changed) return changed.error();
  if (*changed) note(InterventionKind::gameController, hexOf(message));
  return {};
}

void Match::note(InterventionKind kind, std::string line) {
  history_.push_back({time(), kind, std::move(line)});
}

void Match::markIrreproducible(const std::string& why) {
  if (irreproducible_.empty()) irreproducible_ = why;
}

std::uint64_t Match::fingerprint() const {
  Fingerprint sum;
  const std::uint64_t world = simulation_->fingerprint();
  sum.addBytes(&world, sizeof world);
  for (const MatchRobot* robot : allRobots_) {
    if (robot->belief().pose) sum.add(robot->belief().pose->pose.translation.data(), 2);
    if (robot->belief().ball) sum.add(robot->belief().ball->position.data(), 2);
  }
  return sum.value();
}

Result<void> Match::save(const std::string& path) const {
  if (!irreproducible_.empty())
    return Error{.file = path, .what = "this match cannot be repeated: " + irreproducible_};
  MatchState state;
  static_cast<MatchSetup&>(state) = options_;
  state.time = time();
  state.history = history_;
  state.fingerprint = fingerprint();
  return writeFile(path, jsonText(state, 1) + "\n");
}

Result<std::unique_ptr<Match>> Match::load(const std::string& path, MatchOptions options,
                                           const Perform& perform) {
  const auto state = readMatchState(path);
  if (!state) return state.error();
  static_cast<MatchSetup&>(options) = *state;
  options.remote.clear();
  auto match = make(options);
  if (!match) return match.error();
  if (const auto done = (*match)->repeat(state->history, state->time, perform); !done)
    return Error{.file = path, .field = done.error().field, .what = done.error().text()};
  if (state->fingerprint != 0 && (*match)->fingerprint() != state->fingerprint)
    return Error{.file = path,
                 .field = "fingerprint",
                 .what = "the match went another way: its files or the program have changed"};
  return match;
}

Result<void> Match::repeat(std::span<const Intervention> history, Time until,
                           const Perform& perform, const std::function<bool()>& interrupted) {
  auto next = history.begin();
  while (true) {
    for (; next != history.end() && next->time == time(); ++next) {
      const auto done = next->kind == InterventionKind::gameController
                            ? control(bytesOf(next->line))
                            : perform(*this, next->line);
      if (!done) return done;
    }
    if (time() >= until) break;
    if (finished()) return Error{.field = "time", .what = "the match is over before"};
    if (interrupted()) return Error{.what = "stopped"};
    step();
  }
  history_.assign(history.begin(), history.end());
  if (next != history.end())
    return Error{.field = "history", .what = "something between two ticks"};
  return {};
}

Result<void> Match::close() {
  Result<void> first = ceilingLog_ ? ceilingLog_->close() : Result<void>{};
  ceilingLog_.reset();
  for (SimulatedRobot* robot : robots_)
    if (auto done = robot->closeLog(); !done && first) first = done;
  return first;
}

std::vector<Error> Match::takeLogErrors() {
  std::vector<Error> errors;
  const auto add = [&](std::optional<Error> error) {
    if (error) errors.push_back(*std::move(error));
  };
  if (ceilingLog_) add(ceilingLog_->takeError());
  for (SimulatedRobot* robot : robots_) add(robot->takeLogError());
  return errors;
}

}  // namespace gt
