#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "environments/Players.h"
#include "representations/motion/KickTable.h"

namespace gt {

/// A part of behavior/ that an agent can let its robot execute.
struct AgentSkill {
  /// The meaning of the numbers that follow the choice of the skill.
  enum class Target { none, direction, point };

  std::string_view
      name;  ///< Of an option or a basic behavior; play_soccer is the agent's own root.
  bool basicBehavior;
  Target target;
  const char* what;
};

/// All skills.
namespace skill {
inline constexpr AgentSkill stand{"stand", true, AgentSkill::Target::none, "stands still"};
inline constexpr AgentSkill goToBall{"go_to_ball", true, AgentSkill::Target::direction,
                                     "walks behind the ball, so that it faces `direction`"};
inline constexpr AgentSkill goToPoint{"go_to_point", true, AgentSkill::Target::point,
                                      "walks to `point`, so that it faces `direction`"};
inline constexpr AgentSkill handleBall{"handle_ball", false, AgentSkill::Target::none,
                                       "walks to the ball and kicks it towards the goal"};
inline constexpr AgentSkill searchBall{"search_ball", false, AgentSkill::Target::none,
                                       "looks for the ball"};
inline constexpr AgentSkill guardGoal{"goalie_playing", false, AgentSkill::Target::none,
                                      "guards the own goal, as a goalie does"};
inline constexpr AgentSkill playSoccer{"play_soccer", false, AgentSkill::Target::none,
                                       "plays as robots do without an agent"};
}  // namespace skill

/// Players and a ball. An agent decides how its robot moves (`motion`), which part of the behavior
/// it executes (`skills`), or the angles of its joints (`joints`); a step is 40 ms, with joints
/// 8 ms. It observes the ball, itself and the other players, in the coordinates of its team.
class BallGame : public Players {
 protected:
  /// The abilities of agents.
  struct Abilities {
    std::vector<AgentSkill> skills;
    bool kicks = true;  ///< Whether agents that decide the `motion` can kick, too.
  };
  BallGame(EnvironmentOptions options, SceneDescription scene, const Cast& cast,
           Abilities abilities);

  std::vector<const char*> disabledTasks(bool agent) const override;
  void request(std::size_t agent, std::span<const float> actions) override;
  void restart() override;
  void observe(std::size_t agent, std::span<float> numbers) override;

  /// Distance ahead of a robot at which the ball lies when the robot has walked to it (mm).
  static constexpr double ballDistance = 150;

  const BallState& ball() const { return world().ball(0); }
  /// The middle of the line of the goal that a team attacks (mm, on the field).
  Vector2d goalOf(TeamColor team) const {
    return {team == TeamColor::red ? field().xGroundline : -field().xGroundline, 0};
  }
  /// The team that has scored: the whole ball is behind the opponents' line. Empty if none has.
  std::optional<TeamColor> scorer() const;
  /// Draws a place on the field (mm), at least `margin` (mm) from its border.
  Vector2d anywhere(Random& random, double margin) const;

 private:
  void addActions();
  void addObservations();
  void requestJoints(std::size_t agent, std::span<const float> actions);
  void requestMotion(std::size_t agent, std::span<const float> actions);
  void requestSkill(std::size_t agent, std::span<const float> actions);
  void observePlayers(std::size_t robot, const Pose2D& self, std::vector<double>& numbers) const;
  /// The other robots of the scene, of this robot's team or not.
  std::vector<std::size_t> others(std::size_t robot, bool teammates) const;

  Abilities abilities_;
  std::vector<KickDescription> kicks_;  ///< The kicks of the kick table.
  std::vector<JointAngles> requested_;  ///< The last requested angles of each agent (rad).
};

}  // namespace gt
