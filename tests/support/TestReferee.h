#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "simulation/rules/Referee.h"
#include "support/TestScenes.h"

namespace gt {

/// A match that nobody plays, with a referee.
class UnplayedMatch : public testing::Test {
 protected:
  void start() {
    world_ = worldOf(scene_);
    std::vector<Player> players;
    for (const SceneRobot& robot : scene_.robots) players.push_back(robot.player());
    referee_ = std::make_unique<Referee>(scene_.game, scene_.rules, FieldDimensions{}, players);
    commands_.assign(scene_.robots.size(), standingCommand());
  }
  void tick() {
    world_->step(commands_);
    referee_->update(*world_);
  }
  int count(GameEventType type) const {
    return static_cast<int>(std::ranges::count(referee_->events(), type, &GameEvent::type));
  }

  SceneDescription scene_ = matchScene();
  std::unique_ptr<World> world_;
  std::unique_ptr<Referee> referee_;
  std::vector<RobotCommand> commands_;
};

}  // namespace gt
