#include "modules/modeling/team/FusedTeamBallLocator.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/ball/BallDrawing.h"

namespace gt {
namespace {

const DebugKey drawOpinions{"TeamBallLocator/opinions"};

double squared(double x) {
  return x * x;
}

}  // namespace

void FusedTeamBallLocator::update(const BallModel& ball, const RobotPose& robotPose,
                                  const TeamMessages& messages, const FrameInfo& frame,
                                  const Player& player, TeamBallModel& teamBall, Debug& debug) {
  collect(ball, robotPose, messages, frame.time, player.number());
  teamBall = {};
  if (count_ == 0) {  // An old own ball is better than none.
    if (ball.lastSeen != never())
      teamBall = {robotPose.pose * ball.position, ball.lastSeen, player.number(),
                  ball.standardDeviation};
    return;
  }
  const Opinion& center = mostSupported(player.number());
  Vector2d sum = Vector2d::Zero();
  double weights = 0;
  const Opinion* surest = &center;
  std::int64_t age = center.age;
  for (std::size_t i = 0; i < count_; ++i) {
    const Opinion& o = opinions_[i];
    if (!agree(o, center)) continue;
    sum += o.position / o.variance;
    weights += 1 / o.variance;
    if (o.variance < surest->variance) surest = &o;
    age = std::min(age, o.age);
  }
  teamBall = {sum / weights, frame.time - age, surest->player, std::sqrt(1 / weights)};

  draw(teamBall, debug);
  if (auto canvas = debug.onField(drawOpinions))
    for (std::size_t i = 0; i < count_; ++i) {
      const Opinion& o = opinions_[i];
      canvas.circle(o.position, std::sqrt(o.variance),
                    agree(o, center) ? colors::orange : colors::gray);
      canvas.text(o.position, std::to_string(o.player));
    }
}

// The robot's own ball is relative to the robot: the error of its own pose does not count for it,
// but for the balls of all others.
void FusedTeamBallLocator::collect(const BallModel& ball, const RobotPose& robotPose,
                                   const TeamMessages& messages, Time now, int self) {
  count_ = 0;
  if (const auto age = now - ball.lastSeen; age <= parameters.oldestBall)
    opinions_[count_++] = {robotPose.pose * ball.position,
                           ballVariance(ball.standardDeviation, ball.position.norm(), age), age,
                           self};
  for (const TeamMessages::Received& received : messages.byPlayer) {
    const TeamMessage& m = received.message;
    if (m.playerNumber == 0 || m.playerNumber == self || count_ == opinions_.size()) continue;
    const auto silence = now - received.timeReceived;
    // Ages are differences within one clock each: the robots' clocks do not agree.
    const auto age = silence + (m.timeSent - m.ballLastSeen);
    if (silence > parameters.silence || age > parameters.oldestBall || age < 0) continue;
    const double distance = (m.ballPosition - m.robotPose.translation).norm();
    const double away = (m.ballPosition - robotPose.pose.translation).norm();
    const double variance = ballVariance(m.ballStandardDeviation, distance, age) +
                            poseVariance(m.robotPoseValidity, distance) +
                            poseVariance(robotPose.validity, away);
    const Opinion o{m.ballPosition + wayOf(m.ballSpeed, silence), variance, age, m.playerNumber};
    if (std::isfinite(o.variance) && o.position.allFinite()) opinions_[count_++] = o;
  }
}

/// The displacement (mm) of a ball that rolls for a time (ms) with a speed (mm/s) at first.
Vector2d FusedTeamBallLocator::wayOf(const Vector2d& speed, std::int64_t ms) const {
  const double v = speed.norm(), a = parameters.deceleration;
  if (v < 1) return Vector2d::Zero();
  const double seconds = std::min(static_cast<double>(ms) / 1000, a > 0 ? v / a : 1);
  return speed * seconds * (1 - a * seconds / v / 2);
}

double FusedTeamBallLocator::ballVariance(double standardDeviation, double distance,
                                          std::int64_t age) const {
  const double seen =
      standardDeviation > 0 ? standardDeviation : parameters.distanceShare * distance;
  return squared(parameters.leastNoise) + squared(seen) +
         squared(parameters.drift * static_cast<double>(age) / 1000);
}

double FusedTeamBallLocator::poseVariance(double validity, double distance) const {
  const double doubt = 1 - std::clamp(validity, 0., 1.);
  return squared(parameters.poseNoise + parameters.doubtNoise * doubt) +
         squared(parameters.directionNoise * distance * (1 + 4 * doubt));
}

bool FusedTeamBallLocator::agree(const Opinion& a, const Opinion& b) const {
  return (a.position - b.position).squaredNorm() <=
         squared(parameters.gate) * (a.variance + b.variance);
}

/// The opinion that agrees with most others; the robot's own while it is fresh.
const FusedTeamBallLocator::Opinion& FusedTeamBallLocator::mostSupported(int self) const {
  if (opinions_[0].player == self && opinions_[0].age <= parameters.ownBallTime)
    return opinions_[0];
  std::size_t best = 0;
  double most = -1;
  for (std::size_t i = 0; i < count_; ++i) {
    double support = 0;
    for (std::size_t j = 0; j < count_; ++j)
      if (agree(opinions_[i], opinions_[j])) support += 1 / opinions_[j].variance;
    if (support <= most) continue;
    most = support;
    best = i;
  }
  return opinions_[best];
}

}  // namespace gt
