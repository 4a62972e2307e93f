#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "environments/Environment.h"
#include "match/SimulatedRobot.h"
#include "robot/Configuration.h"

namespace gt {

constexpr std::size_t sceneStriker = 2;  ///< Red's striker, of the robots of the scene of matches.

/// An environment of robots that run their own programs. Robots with agents follow these instead of
/// their behavior; other players play by their behavior.
///
/// With state observations robots get ground truth, as with an oracle (report 5.1); cameras and
/// vision are off, which saves most of the time.
class Players : public Environment {
 protected:
  /// The robots of the scene that play: those of the agents first.
  struct Cast {
    std::vector<std::size_t> robots;
    std::size_t agents = 1;
    bool ball = true;
  };
  Players(EnvironmentOptions options, SceneDescription scene, const Cast& cast);

  Result<void> load() override;
  Result<void> loadFrom(const Environment& same) override;
  /// Lets nearly a second pass, which robots need after they were switched on until they stand as
  /// for walking; meanwhile they look around.
  Result<void> begin(Random& random) override;
  void act(std::span<const float> actions) override;
  SceneCamera camera() const override;

  /// Places robots and ball, before the robots' programs begin.
  virtual void place(Random& random) = 0;
  /// The tasks that a robot's program does not execute, because its agent decides their results, or
  /// because they are not needed.
  virtual std::vector<const char*> disabledTasks(bool agent) const = 0;
  /// Passes an agent's decision to its robot, before a step.
  virtual void request(std::size_t agent, std::span<const float> actions) = 0;
  /// Discards the state of the previous episode.
  virtual void restart() {}
  /// Called when the robots are ready.
  virtual void start() {}

  const FieldDimensions& field() const { return configuration_->get<FieldDimensions>(); }
  SimulatedRobot& program(std::size_t robot) { return *programs_[robot]; }
  const SimulatedRobot& program(std::size_t robot) const { return *programs_[robot]; }
  const Pose2D& pose(std::size_t robot) const { return world().robot(robot).pose; }
  TeamColor team(std::size_t robot) const { return scene_.robots[robot].team; }
  /// Converts a pose from the field's coordinates to those of a robot's team, which plays in the
  /// direction of x, or back.
  Pose2D forTeam(std::size_t robot, const Pose2D& pose) const;

 private:
  Result<void> addRobot(std::size_t robot, std::uint64_t seed);
  void requestAll(std::span<const float> actions);

  std::shared_ptr<const Configuration> configuration_;
  std::optional<Layout> layout_;
  std::vector<SimulatedRobot*> programs_;  ///< Owned by the simulation.
};

}  // namespace gt
