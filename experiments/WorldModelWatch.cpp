#include "WorldModelWatch.h"

#include <algorithm>
#include <cmath>

#include "measure/Pairs.h"
#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {
namespace {

const FieldDimensions dimensions;

bool isOnField(const Vector2d& p) {
  return std::abs(p.x()) < dimensions.xGoalBack && std::abs(p.y()) < dimensions.ySideline + 50;
}

/// 0 to 70 cm, in which the ball is handled; to 150 cm; beyond that.
const char* distanceBand(double distance) {
  return distance < 700 ? "near" : distance < 1500 ? "middle" : "far";
}

}  // namespace

void BallWatch::update(const SimulatedRobot& robot, const OracledWorldState& truth, Tally& tally) {
  const auto* percept = robot.robot().provided<BallPercept>();
  const auto* odometry = robot.robot().provided<OdometryData>();
  const auto* camera = robot.robot().provided<CameraMatrix>();
  if (!percept || !odometry || !camera) return;
  const FrameInfo frame{truth.time};
  pidSmoothed_.update(*percept, *odometry, frame, models_[0], debug_);
  challenge_.update(*percept, *odometry, frame, models_[1], debug_);
  probabilistic_.update(*percept, *camera, *odometry, frame, models_[2], debug_);
  debug_.out().clear();

  const Vector2d ball = relative(truth.robotPose, truth.ballPosition);
  const Vector2d speed = rotated(truth.ballSpeed, -truth.robotPose.rotation);
  if (speed.norm() > lastSpeed_ + 300) kicked_ = truth.time;
  lastSpeed_ = speed.norm();
  if (percept->seen) perceived_ = percept->time;
  const auto unseen = truth.time - perceived_;
  const BallSituation situation = unseen > 3000                 ? BallSituation::lost
                                  : unseen > 300                ? BallSituation::hidden
                                  : truth.time - kicked_ < 1000 ? BallSituation::kicked
                                  : speed.norm() > 50           ? BallSituation::rolling
                                                                : BallSituation::resting;
  if (situation == BallSituation::lost || perceived_ == never()) return;
  constexpr const char* names[] = {"pidsmoothed", "ballchallenge", "probabilistic"};
  for (int i = 0; i < 3; ++i) {
    const BallModel& model = models_[i];
    const std::string name =
        std::string{"ball."} + names[i] + '.' + std::string{enumName(situation)};
    const double error = (model.position - ball).norm();
    tally.measure(name + ".position", "mm", error);
    tally.measure(name + '.' + distanceBand(ball.norm()) + ".position", "mm", error);
    const double wrongSpeed = (model.speed - speed).norm();
    tally.measure(name + ".speed", "mm/s", wrongSpeed);
    tally.measure(name + '.' + distanceBand(ball.norm()) + ".speed", "mm/s", wrongSpeed);
  }
}

void TeamBallWatch::send(std::size_t robot, TeamMessage message, Time now) {
  if (oneIsLost_ && message.playerNumber == 2) {
    // The second player believes, and is sure, that it stands turned by a right angle, a meter
    // aside.
    const Pose2D wrong{pi / 2, 0, 1000};
    const Pose2D believed = message.robotPose * wrong;
    message.ballPosition = believed * relative(message.robotPose, message.ballPosition);
    message.ballSpeed = rotated(message.ballSpeed, wrong.rotation);
    message.robotPose = believed;
  }
  radio_.send(robot, message, now);
}

void TeamBallWatch::update(std::size_t robot, const BallModel& ball, const RobotPose& pose,
                           const OracledWorldState& truth, Tally& tally) {
  Receiver& receiver = robots_[robot];
  radio_.receive(robot, truth.time, receiver.messages);
  const FrameInfo frame{truth.time};
  const Player& player = players_[robot];
  TeamBallModel chosen, fused;
  receiver.chooses.update(ball, pose, receiver.messages, frame, player, chosen, debug_);
  receiver.fuses.update(ball, pose, receiver.messages, frame, player, fused, debug_);
  debug_.out().clear();
  const auto measure = [&](const char* of, const Vector2d& position) {
    tally.measure("teamball." + name_ + '.' + of, "mm", (position - truth.ballPosition).norm());
  };
  if (chosen.seenBy == 0 || fused.seenBy == 0 || ball.lastSeen == never()) return;
  measure("single", pose.pose * ball.position);
  measure("default", chosen.position);
  measure("fused", fused.position);
}

void compareObstacles(const SimulatedRobot& robot, const OracledWorldState& truth, Tally& tally) {
  const auto* obstacles = robot.robot().provided<ObstaclesModel>();
  if (!obstacles || !robot.belief().motion) return;
  if (robot.belief().motion->executed.type != MotionType::walk ||
      robot.belief().motion->executed.walk.translation.x() < 50)
    return;
  ObstaclesModel real;
  OracledObstaclesLocator{}.update(truth, dimensions, {truth.time}, real);
  // What matters is what is near; the model's obstacles end at 2 m.
  constexpr double width = 250, nearBy = 1500;
  const double expected = std::min(corridor(real, 0, width), nearBy);
  const double modeled = std::min(corridor(*obstacles, 0, width), nearBy);
  tally.measure("obstacles.corridor", "mm", modeled - expected);
  if (expected < 600) {
    tally.measure("obstacles.corridor.blocked", "mm", modeled - expected);
    tally.count("obstacles.corridor.blockedSeen", modeled < expected + 300);
  } else {
    tally.count("obstacles.corridor.freeSeen", modeled > 450);
  }
}

void comparePlayers(const PlayersCollection& players, TeamColor own, const OracledWorldState& truth,
                    Tally& tally) {
  constexpr double known = 300, same = 500;  // mm
  for (const bool mates : {true, false}) {
    std::vector<Vector2d> places, located;
    for (const OracledRobot& other : truth.others)
      if ((other.teamColor == own) == mates) places.push_back(other.pose.translation);
    for (const LocatedPlayer& p : mates ? players.ownTeam : players.opponents)
      located.push_back(p.position);

    const auto assigned = pairNearest(places, located, known);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!isOnField(places[i])) continue;
      const bool isKnown = assigned[i].has_value();
      tally.count("players.known", isKnown);
      tally.count(mates ? "players.mates.known" : "players.opponents.known", isKnown);
      const double distance = (places[i] - truth.robotPose.translation).norm();
      if (!mates)
        tally.count(std::string{"players.opponents."} + distanceBand(distance) + ".known", isKnown);
    }

    const auto real = pairNearest(located, places, same);
    for (std::size_t i = 0; i < located.size(); ++i) {
      if (!mates) tally.count("players.opponents.true", real[i].has_value());
      if (real[i]) tally.measure("players.position", "mm", (places[*real[i]] - located[i]).norm());
    }
  }
}

}  // namespace gt
