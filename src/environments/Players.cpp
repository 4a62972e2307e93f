#include "environments/Players.h"

#include <algorithm>

#include "framework/Requests.h"

namespace gt {

Players::Players(EnvironmentOptions options, SceneDescription scene, const Cast& cast)
    : Environment{std::move(options), std::move(scene)} {
  ticksPerStep_ = Simulation::ticksPerImage;
  scene_.game.referee = false;
  const std::vector<SceneRobot> all = std::move(scene_.robots);
  scene_.robots.clear();
  for (const std::size_t robot : cast.robots) scene_.robots.push_back(all[robot]);
  for (std::size_t i = 0; i < cast.agents; ++i) agents_.push_back(scene_.robots[i].name);
  scene_.balls.resize(cast.ball ? 1 : 0);
}

Result<void> Players::load() {
  const auto configuration =
      loadConfiguration({.config = scene_.resolve(scene_.config),
                         .motions = scene_.resolve("../motions"),
                         .behavior = scene_.resolve("../behavior/GT2003.xabsl")});
  if (!configuration) return configuration.error();
  configuration_ = *configuration;
  auto layout = loadLayout(scene_.resolve(scene_.robots.front().layout));
  if (!layout) return layout.error();
  layout_ = std::move(*layout);
  return {};
}

Result<void> Players::loadFrom(const Environment& same) {
  const auto& other = static_cast<const Players&>(same);
  configuration_ = other.configuration_;
  layout_ = other.layout_;
  return {};
}

Result<void> Players::begin(Random& random) {
  place(random);
  restart();
  programs_.clear();
  for (std::size_t i = 0; i < scene_.robots.size(); ++i)
    if (auto added = addRobot(i, random()); !added) return added;
  constexpr int images = 23;
  const std::vector<float> nothing(agents_.size() * actionSpace_.count());
  for (int i = 0; i < images * Simulation::ticksPerImage; ++i) {
    if (i % Simulation::ticksPerImage == 0) requestAll(nothing);
    tick();
  }
  start();
  return {};
}

Result<void> Players::addRobot(std::size_t robot, std::uint64_t seed) {
  const SceneRobot& player = scene_.robots[robot];
  const std::vector<const char*> disabled = disabledTasks(robot < agents_.size());
  const bool sees =
      std::ranges::find(disabled, std::string_view{"ImageProcessor"}) == disabled.end();
  const auto program = SimulatedRobot::enter(
      simulation(), robot,
      {configuration_, *layout_, player.player(), seed,
       sees ? platformRepresentations() : representationsWithTruth(), player.address});
  if (!program) return program.error();
  for (const char* task : disabled)
    if (auto done = (*program)->robot().request(SolutionRequest{task, "disabled"}); !done)
      return done;
  programs_.push_back(*program);
  simulation().takeImages(robot, sees);
  return {};
}

void Players::requestAll(std::span<const float> actions) {
  const std::size_t share = actionSpace_.count();
  for (std::size_t agent = 0; agent < agents_.size(); ++agent)
    request(agent, actions.subspan(agent * share, share));
}

void Players::act(std::span<const float> actions) {
  requestAll(actions);
  for (int i = 0; i < ticksPerStep_; ++i) tick();
}

Pose2D Players::forTeam(std::size_t robot, const Pose2D& pose) const {
  if (team(robot) == TeamColor::red) return pose;
  return {normalize(pose.rotation + pi), -pose.translation};
}

SceneCamera Players::camera() const {
  SceneCamera camera = Environment::camera();
  camera.from = {0, -3450, 2600};
  return camera;
}

}  // namespace gt
