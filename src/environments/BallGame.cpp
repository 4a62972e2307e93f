#include "environments/BallGame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/Number.h"
#include "environments/JointSpace.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/modeling/PlayersCollection.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// The requested walk at a full action; the walking engine limits it to what it can do.
constexpr double mostAhead = 250, mostLeft = 200, mostTurn = 2;  // mm/s, rad/s
/// Least action for which a kick is executed.
constexpr float kickFrom = 0.5F;

/// Tasks of perception and modeling whose results the oracle provides instead.
constexpr std::array seeing{"ImageProcessor", "SelfLocator", "BallLocator", "TeamBallLocator",
                            "PlayersLocator"};

bool uses(const std::vector<AgentSkill>& skills, AgentSkill::Target target) {
  return std::ranges::count(skills, target, &AgentSkill::target) > 0;
}

/// Describes the effect of a kick on the ball.
std::string described(const KickDescription& kick) {
  const auto number = [](double value) { return numberText(std::round(value)); };
  return "kicks a ball at " + number(kick.x) + ", " + number(kick.y) + " mm to " +
         number(kick.direction) + " degrees";
}

}  // namespace

BallGame::BallGame(EnvironmentOptions options, SceneDescription scene, const Cast& cast,
                   Abilities abilities)
    : Players{std::move(options), std::move(scene), cast}, abilities_{std::move(abilities)} {
  if (actions() == ActionKind::joints) ticksPerStep_ = 1;
  // Without the table there are no kicks, and `load` reports why.
  if (KickTable table; readConfig(scene_.resolve(scene_.config) + "/kicks.cfg", table))
    kicks_ = std::move(table.kicks);
  addActions();
  if (observations() != ObservationKind::image) addObservations();
}

void BallGame::addActions() {
  Space& space = actionSpace_;
  if (actions() == ActionKind::joints) return addJoints(space, headAndLegJoints());
  if (actions() == ActionKind::motion) {
    space.add("walk.ahead", "", -1, 1, "1: 0.25 m/s");
    space.add("walk.left", "", -1, 1, "1: 0.2 m/s");
    space.add("walk.turn", "", -1, 1, "1: 2 rad/s counterclockwise");
    if (abilities_.kicks)
      for (const KickDescription& kick : kicks_)
        space.add("kick." + kick.motion, "", -1, 1,
                  described(kick) + ", if this is the greatest of the kicks and at least 0.5");
    return;
  }
  for (const AgentSkill& skill : abilities_.skills)
    space.add("skill." + std::string{skill.name}, "", -1, 1,
              std::string{skill.what} + ", if this is the greatest of the skills");
  if (uses(abilities_.skills, AgentSkill::Target::point)) {
    space.add("point.x", "", -1, 1, "on the field; 1: the opponent's ground line");
    space.add("point.y", "", -1, 1, "on the field; 1: the left side line");
  }
  if (uses(abilities_.skills, AgentSkill::Target::direction))
    space.add("direction", "", -1, 1, "on the field; 0: to the opponent's side, 1: pi rad");
}

void BallGame::addObservations() {
  Space& space = observationSpace_;
  const auto addPlace = [&](const std::string& name, const char* what) {
    for (const char* axis : {".ahead", ".left"}) space.add(name + axis, "m", -10, 10, what);
  };
  addPlace("ball", "relative to the robot");
  for (const char* axis : {"ahead", "left"})
    space.add(std::string{"ballSpeed."} + axis, "m/s", -20, 20, "in the robot's heading");
  space.add("ballAge", "s", 0, 10, "since the robot saw the ball");
  addPlace("goal", "the middle of the opponent's goal, relative to the robot");
  for (const char* axis : {"x", "y"})
    space.add(std::string{"pose."} + axis, "m", -10, 10, "of the robot on the field");
  space.add("heading", "rad", -pi, pi, "of the robot on the field");
  if (!others(0, true).empty())
    for (int number = 1; number <= 4; ++number)
      space.add("number." + std::to_string(number), "", 0, 1, "1: the robot has this number");
  const auto addPlayers = [&](const std::string& name, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) {
      addPlace(name + std::to_string(i), "relative to the robot; 0 if it is not known");
      space.add(name + std::to_string(i) + ".validity", "", 0, 1, "0: not known, 1: certain");
    }
  };
  addPlayers("teammate", others(0, true).size());
  addPlayers("opponent", others(0, false).size());
  if (actions() != ActionKind::joints) return;
  for (const char* axis : {"x", "y", "z"})
    space.add(std::string{"acceleration."} + axis, "m/s^2", -1000, 1000, "as measured");
  addJoints(space, headAndLegJoints(), "angle", "rad", pi);
  addJoints(space, headAndLegJoints(), "requested", "rad", pi);
}

std::vector<const char*> BallGame::disabledTasks(bool agent) const {
  std::vector<const char*> tasks;
  if (observations() == ObservationKind::state) tasks.assign(seeing.begin(), seeing.end());
  if (agent && actions() != ActionKind::skills) tasks.push_back("BehaviorControl");
  if (agent && actions() == ActionKind::joints) tasks.push_back("MotionControl");
  return tasks;
}

void BallGame::restart() {
  requested_.assign(agents_.size(), standingAngles());
}

void BallGame::request(std::size_t agent, std::span<const float> actions) {
  if (this->actions() == ActionKind::joints) return requestJoints(agent, actions);
  if (this->actions() == ActionKind::motion) return requestMotion(agent, actions);
  requestSkill(agent, actions);
}

void BallGame::requestJoints(std::size_t agent, std::span<const float> actions) {
  requested_[agent] = anglesOf(actions, headAndLegJoints());
  program(agent).robot().layIfDisabled(JointData{requested_[agent]});
}

void BallGame::requestMotion(std::size_t agent, std::span<const float> actions) {
  constexpr std::size_t walk = 3;  // numbers
  MotionRequest request;
  request.type = MotionType::walk;
  request.walk = {mostTurn * actions[2], mostAhead * actions[0], mostLeft * actions[1]};
  if (const auto choices = actions.subspan(walk); !choices.empty()) {
    const auto greatest = std::ranges::max_element(choices);
    if (*greatest >= kickFrom) {
      request.type = MotionType::specialAction;
      request.specialAction = kicks_[static_cast<std::size_t>(greatest - choices.begin())].motion;
    }
  }
  request.time = simulation().time();
  program(agent).robot().layIfDisabled(request);
  program(agent).robot().layIfDisabled(HeadControlMode{HeadMode::searchAuto, Vector3d::Zero()});
}

void BallGame::requestSkill(std::size_t agent, std::span<const float> actions) {
  const std::vector<AgentSkill>& skills = abilities_.skills;
  const auto choices = actions.first(skills.size());
  const AgentSkill& skill =
      skills[static_cast<std::size_t>(std::ranges::max_element(choices) - choices.begin())];
  const auto targets = actions.subspan(skills.size());
  const std::string direction =
      targets.empty() ? std::string{} : numberText(180.0 * targets.back());
  BehaviorControlRequest request;
  if (skill.name != skill::playSoccer.name) request.root = std::string{skill.name};
  request.basicBehavior = skill.basicBehavior;
  if (skill.target == AgentSkill::Target::direction)
    request.parameters = {direction, numberText(ballDistance), "0"};
  if (skill.target == AgentSkill::Target::point)
    request.parameters = {numberText(field().xGroundline * targets[0]),
                          numberText(field().ySideline * targets[1]), direction, "0"};
  if (skill.basicBehavior) request.outputs = {{"head_control_mode", "search_auto"}};
  Robot& robot = program(agent).robot();
  robot.fromTools().write(simulation().time(), request);
  robot.answer();
}

std::vector<std::size_t> BallGame::others(std::size_t robot, bool teammates) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene_.robots.size(); ++i)
    if (i != robot && (team(i) == team(robot)) == teammates) found.push_back(i);
  return found;
}

void BallGame::observe(std::size_t agent, std::span<float> numbers) {
  const Time now = simulation().time();
  Pose2D self;
  BallModel ball;
  if (observations() == ObservationKind::state) {
    self = forTeam(agent, pose(agent));
    ball.position = relative(pose(agent), this->ball().position);
    ball.speed = rotated(this->ball().speed, -pose(agent).rotation);
    ball.lastSeen = now;
  } else {
    if (const RobotPose* believed = program(agent).belief().pose) self = believed->pose;
    if (const BallModel* believed = program(agent).belief().ball) ball = *believed;
  }
  std::vector<double> all;
  const auto add = [&](const Vector2d& v) { all.insert(all.end(), {v.x() / 1000, v.y() / 1000}); };
  add(ball.position);
  add(ball.speed);
  all.push_back(ball.lastSeen == never() ? 10.0 : static_cast<double>(now - ball.lastSeen) / 1000);
  add(relative(self, goalOf(TeamColor::red)));
  add(self.translation);
  all.push_back(self.rotation);
  if (!others(agent, true).empty())
    for (int number = 1; number <= 4; ++number)
      all.push_back(scene_.robots[agent].player().number() == number ? 1 : 0);
  observePlayers(agent, self, all);
  if (actions() == ActionKind::joints) {
    const SensorData& measured = simulation().input(agent).sensors.newest();
    for (int k = 0; k < 3; ++k) all.push_back(measured.acceleration[k] / 1000);
    for (const Joint joint : headAndLegJoints()) all.push_back(measured.joints[joint]);
    for (const Joint joint : headAndLegJoints()) all.push_back(requested_[agent][joint]);
  }
  std::ranges::transform(all, numbers.begin(), [](double n) { return static_cast<float>(n); });
}

void BallGame::observePlayers(std::size_t robot, const Pose2D& self,
                              std::vector<double>& numbers) const {
  const auto* believed = observations() == ObservationKind::state
                             ? nullptr
                             : program(robot).robot().provided<PlayersCollection>();
  for (const bool teammates : {true, false}) {
    const std::vector<std::size_t> all = others(robot, teammates);
    for (std::size_t i = 0; i < all.size(); ++i) {
      LocatedPlayer player;
      if (observations() == ObservationKind::state) {
        player.position = forTeam(robot, pose(all[i])).translation;
        player.validity = 1;
      } else if (believed) {
        const auto& known = teammates ? believed->ownTeam : believed->opponents;
        if (i < known.size()) player = known[i];
      }
      const bool known = player.validity > 0;
      const Vector2d place =
          known ? Vector2d{relative(self, player.position) / 1000} : Vector2d::Zero();
      numbers.insert(numbers.end(), {place.x(), place.y(), player.validity});
    }
  }
}

std::optional<TeamColor> BallGame::scorer() const {
  const Vector2d& at = ball().position;
  if (std::abs(at.y()) >= field().yGoal ||
      std::abs(at.x()) <= field().xGroundline + field().ballRadius)
    return {};
  return at.x() > 0 ? TeamColor::red : TeamColor::blue;
}

Vector2d BallGame::anywhere(Random& random, double margin) const {
  return {(field().xGroundline - margin) * random.symmetric(),
          (field().ySideline - margin) * random.symmetric()};
}

}  // namespace gt
