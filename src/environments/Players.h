#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "environments/Environment.h"
#include "match/SimulatedRobot.h"
#include "robot/Configuration.h"

namespace gt {

constexpr std::size_t sceneStriker = 2;  ///< Red's striker, of the robots of the scene of matches.

/// An environment of robots that run their own programs; those of the agents obey them instead of
/// their behavior, those of other players play as they always do.
///
/// Who observes the state has robots that know the truth, as with an oracle (report 5.1): no camera
/// takes images and nobody looks at them, which takes most of the time otherwise.
class Players : public Environment {
 protected:
  /// Which robots of the scene play: those of the agents first.
  struct Cast {
    std::vector<std::size_t> robots;
    std::size_t agents = 1;
    bool ball = true;
  };
  Players(EnvironmentOptions options, SceneDescription scene, const Cast& cast);

  Result<void> load() override;
  Result<void> loadFrom(const Environment& same) override;
  /// Lets the time pass that robots need to stand as they walk, after they were switched on: nearly
  /// a second, in which they look around.
  Result<void> begin(Random& random) override;
  void act(std::span<const float> actions) override;
  SceneCamera camera() const override;

  /// Puts robots and ball in their places, before the robots' programs begin.
  virtual void place(Random& random) = 0;
  /// What a robot's program does not do itself, because its agent does, or it need not.
  virtual std::vector<const char*> disabledTasks(bool agent) const = 0;
  /// Has a robot do what its agent decides, before a step.
  virtual void request(std::size_t agent, std::span<const float> actions) = 0;
  /// Forgets the episode before.
  virtual void restart() {}
  /// Does what begins when the robots are ready.
  virtual void start() {}

  const FieldDimensions& field() const { return configuration_->get<FieldDimensions>(); }
  SimulatedRobot& program(std::size_t robot) { return *programs_[robot]; }
  const SimulatedRobot& program(std::size_t robot) const { return *programs_[robot]; }
  const Pose2D& pose(std::size_t robot) const { return world().robot(robot).pose; }
  TeamColor team(std::size_t robot) const { return scene_.robots[robot].team; }
  /// A pose of a field's coordinates in those of a robot's team, which plays in the direction of x;
  /// and the other way round.
  Pose2D forTeam(std::size_t robot, const Pose2D& pose) const;

 private:
  Result<void> addRobot(std::size_t robot, std::uint64_t seed);
  void requestAll(std::span<const float> actions);

  std::shared_ptr<const Configuration> configuration_;
  std::optional<Layout> layout_;
  std::vector<SimulatedRobot*> programs_;  ///< Owned by the simulation.
};

}  // namespace gt
