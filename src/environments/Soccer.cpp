#include <algorithm>

#include "environments/BallGame.h"
#include "environments/Table.h"

namespace gt {
namespace {

constexpr std::size_t perTeam = 4;

/// Four against four.
class Soccer : public BallGame {
 public:
  Soccer(EnvironmentOptions options, SceneDescription scene, std::size_t agents)
      : BallGame{std::move(options),
                 std::move(scene),
                 {.robots = {0, 1, 2, 3, 4, 5, 6, 7}, .agents = agents},
                 {.skills = {skill::playSoccer, skill::stand, skill::goToPoint, skill::goToBall,
                             skill::handleBall, skill::searchBall, skill::guardGoal}}} {
    terms_ = {
        {"closer",
         "0.2 times by how much the player of the team that is closest to the ball got closer "
         "to it: m"},
        {"ball", "by how much the ball got closer to the opponent's ground line: m"},
        {"goal", "5 at the end, if the team has scored; -5 if the other one has"}};
  }

 protected:
  void place(Random& random) override {
    constexpr double variety = 250;  // mm
    world().placeBall(0, {400 * random.symmetric(), 800 * random.symmetric()});
    const Vector2d ball = this->ball().position;
    for (std::size_t i = 0; i < scene_.robots.size(); ++i) {
      Pose2D pose = scene_.robots[i].pose();
      pose.translation += variety * Vector2d{random.symmetric(), random.symmetric()};
      pose.rotate(0.5 * random.symmetric());
      keepOff(ball, i, pose.translation);
      world().placeRobot(i, pose);
    }
  }

  void start() override { before_ = now(); }

  bool judge(std::span<double> terms) override {
    const Progress after = now();
    const auto scored = scorer();
    for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
      const TeamColor own = team(agent);
      const auto part = terms.subspan(agent * terms_.size(), terms_.size());
      const double side = own == TeamColor::red ? 1 : -1;
      part[0] = 0.2 * (before_.closest[own] - after.closest[own]) / 1000;
      part[1] = side * (after.ball - before_.ball) / 1000;
      part[2] = !scored ? 0 : *scored == own ? 5 : -5;
    }
    before_ = after;
    return scored.has_value();
  }

 private:
  struct Progress {
    EnumArray<TeamColor, double> closest;  ///< mm: of each team's players to the ball.
    double ball = 0;                       ///< mm: its x.
  };

  Progress now() const {
    Progress progress;
    progress.ball = ball().position.x();
    for (std::size_t i = 0; i < scene_.robots.size(); ++i) {
      const double distance = (pose(i).translation - ball().position).norm();
      double& closest = progress.closest[team(i)];
      closest = i % perTeam == 0 ? distance : std::min(closest, distance);
    }
    return progress;
  }

  /// Moves a place (mm) backwards, if it is too close to the ball or to the robots that have been
  /// placed already.
  void keepOff(const Vector2d& ball, std::size_t robot, Vector2d& place) const {
    constexpr double ballGap = 350, robotGap = 350, step = 50;  // mm
    const double back = team(robot) == TeamColor::red ? -step : step;
    const auto tooClose = [&] {
      if ((place - ball).norm() < ballGap) return true;
      for (std::size_t i = 0; i < robot; ++i)
        if ((place - pose(i).translation).norm() < robotGap) return true;
      return false;
    };
    while (tooClose()) place.x() += back;
  }

  Progress before_;
};

}  // namespace

EnvironmentDescription soccerDescription() {
  return {"Soccer",
          "Four robots play against four. Agents have the red team, against robots that play as "
          "they always do, or both teams. There is no referee. Rewards are those of the team: all "
          "its robots get the same.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::motion, ActionKind::skills, ActionKind::joints},
          {AgentKind::red, AgentKind::all},
          {Fidelity::kinematic, Fidelity::dynamic},
          120,
          "the ball is in a goal",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            const bool all = options.agents == enumName(AgentKind::all);
            return std::make_unique<Soccer>(std::move(options), std::move(scene),
                                            all ? 2 * perTeam : perTeam);
          }};
}

}  // namespace gt
