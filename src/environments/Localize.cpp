#include <algorithm>
#include <array>
#include <cmath>

#include "environments/JointSpace.h"
#include "environments/Players.h"
#include "environments/Table.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {
namespace {

constexpr std::array modes{HeadMode::searchForLandmarks, HeadMode::searchAuto,
                           HeadMode::lookStraightAhead, HeadMode::lookLeft, HeadMode::lookRight};
constexpr std::array headJoints{Joint::headTilt, Joint::headPan, Joint::headRoll};

/// Look around so that the robot can localize itself.
class Localize : public Players {
 public:
  Localize(EnvironmentOptions options, SceneDescription scene)
      : Players{std::move(options), std::move(scene), {.robots = {sceneStriker}, .ball = false}} {
    terms_ = {
        {"place", "-1 for each m by which the believed place is wrong, for each second"},
        {"heading", "-0.3 for each rad by which the believed heading is wrong, for each second"}};
    if (actions() == ActionKind::joints)
      addJoints(actionSpace_, headJoints);
    else
      for (const HeadMode mode : modes)
        actionSpace_.add("mode." + std::string{enumName(mode)}, "", -1, 1,
                         "the head control mode of this name, if this is the greatest");
    if (observations() != ObservationKind::image) addObservations();
  }

 protected:
  void place(Random& random) override {
    way_ = random.fork("way");
    target_ = somewhere(way_);
    const Vector2d at = somewhere(random);
    world().placeRobot(0, {pi * random.symmetric(), at});
  }

  /// Perception and localization run with all observations, since the task is about them.
  std::vector<const char*> disabledTasks(bool) const override {
    if (actions() == ActionKind::joints) return {"BehaviorControl", "HeadControl"};
    return {"BehaviorControl"};
  }

  void request(std::size_t, std::span<const float> actions) override {
    Robot& robot = program(0).robot();
    walk_ = nextWalk();
    MotionRequest walk;
    walk.type = MotionType::walk;
    walk.walk = walk_;
    walk.time = simulation().time();
    robot.layIfDisabled(walk);
    if (this->actions() == ActionKind::joints) {
      const JointAngles angles = anglesOf(actions, headJoints);
      robot.layIfDisabled(HeadMotionRequest{angles[Joint::headTilt], angles[Joint::headPan],
                                            angles[Joint::headRoll], angles[Joint::mouth]});
      return;
    }
    const auto greatest = std::ranges::max_element(actions);
    const auto chosen = static_cast<std::size_t>(greatest - actions.begin());
    robot.layIfDisabled(HeadControlMode{modes[chosen], Vector3d::Zero()});
  }

  void observe(std::size_t, std::span<float> numbers) override {
    auto next = numbers.begin();
    const auto add = [&](double number) { *next++ = static_cast<float>(number); };
    const auto addPose = [&](const Pose2D& pose) {
      add(pose.translation.x() / 1000);
      add(pose.translation.y() / 1000);
      add(pose.rotation);
    };
    if (observations() == ObservationKind::state) addPose(pose(0));
    addPose(believed().pose);
    add(believed().validity);
    for (const Joint joint : headJoints) add(simulation().input(0).sensors.newest().joints[joint]);
    add(walk_.translation.x() / 1000);
    add(walk_.rotation);
  }

  bool judge(std::span<double> terms) override {
    const Pose2D is = pose(0), thought = believed().pose;
    terms[0] = -(thought.translation - is.translation).norm() / 1000 * secondsPerStep();
    terms[1] = -0.3 * std::abs(normalize(thought.rotation - is.rotation)) * secondsPerStep();
    return false;
  }

 private:
  void addObservations() {
    Space& space = observationSpace_;
    const auto addPose = [&](const std::string& name, const char* what) {
      for (const char* axis : {".x", ".y"}) space.add(name + axis, "m", -10, 10, what);
      space.add(name + ".heading", "rad", -pi, pi, what);
    };
    if (observations() == ObservationKind::state) addPose("pose", "of the robot on the field");
    addPose("believed", "the robot's pose, as it believes");
    space.add("validity", "", 0, 1, "how certain it believes to be");
    addJoints(space, headJoints, "angle", "rad", pi);
    space.add("walk.ahead", "m/s", -1, 1, "as requested");
    space.add("walk.turn", "rad/s", -10, 10, "as requested");
  }

  RobotPose believed() const {
    const RobotPose* pose = program(0).belief().pose;
    return pose ? *pose : RobotPose{};
  }

  Vector2d somewhere(Random& random) const {
    constexpr double fromBorder = 450;  // mm
    return {(field().xGroundline - fromBorder) * random.symmetric(),
            (field().ySideline - fromBorder) * random.symmetric()};
  }

  /// Walks from one random place to the next: turns to it, then walks ahead.
  Pose2D nextWalk() {
    constexpr double arrived = 150, speed = 150, fastestTurn = 1;  // mm, mm/s, rad/s
    if ((target_ - pose(0).translation).norm() < arrived) target_ = somewhere(way_);
    const double turn = angleOf(relative(pose(0), target_));
    const bool ahead = std::abs(turn) < fromDegrees(30);
    return {std::clamp(2 * turn, -fastestTurn, fastestTurn), ahead ? speed : 0, 0};
  }

  Random way_{0};
  Vector2d target_ = Vector2d::Zero();  ///< mm: to which the robot walks.
  Pose2D walk_;                         ///< mm/s, rad/s: as requested last.
};

}  // namespace

EnvironmentDescription localizeDescription() {
  return {"Localize",
          "A robot walks from one random place to the next. The agent turns its head so that it "
          "knows where it is: by angles or by the robots' own head control modes. Perception and "
          "self-localization run, whatever is observed.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::joints, ActionKind::skills},
          {AgentKind::red},
          {Fidelity::kinematic, Fidelity::dynamic},
          30,
          "never",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<Localize>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
