#include "modules/modeling/FusedTeamBallLocator.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

const DebugKey drawTeamBall{"TeamBallLocator/ball"};
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
      teamBall = {robotPose.pose * ball.position, ball.lastSeen, player.number(), ball.deviation};
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

  if (auto canvas = debug.onField(drawTeamBall)) {
    canvas.circle(teamBall.position, 43, colors::orange);
    canvas.circle(teamBall.position, teamBall.deviation, colors::orange);
  }
  if (auto canvas = debug.onField(drawOpinions))
    for (std::size_t i = 0; i < count_; ++i) {
      const Opinion& o = opinions_[i];
      canvas.circle(o.position, std::sqrt(o.variance),
                    agree(o, center) ? colors::orange : colors::gray);
      canvas.text(o.position, std::to_string(o.player));
    }
}

// One's own ball moves with oneself: the error of the own pose does not count for it, but for those
// of all others.
void FusedTeamBallLocator::collect(const BallModel& ball, const RobotPose& robotPose,
                                   const TeamMessages& messages, Time now, int self) {
  count_ = 0;
  if (const auto age = now - ball.lastSeen; age <= parameters.oldestBall)
    opinions_[count_++] =
        opinion(robotPose.pose * ball.position, rotated(ball.speed, robotPose.pose.rotation),
                ball.deviation, ball.position.norm(), 0, self);
  if (count_ > 0) {
    // It was moved on to now by its locator.
    const auto age = now - ball.lastSeen;
    opinions_[0].age = age;
    opinions_[0].variance += squared(parameters.drift * static_cast<double>(age) / 1000);
  }
  for (const TeamMessages::Received& received : messages.byPlayer) {
    const TeamMessage& m = received.message;
    if (m.playerNumber == 0 || m.playerNumber == self || count_ == opinions_.size()) continue;
    const auto silence = now - received.timeReceived;
    // Ages are differences within one clock each: the robots' clocks do not agree.
    const auto age = silence + (m.timeSent - m.ballLastSeen);
    if (silence > parameters.silence || age > parameters.oldestBall || age < 0) continue;
    const double distance = (m.ballPosition - m.robotPose.translation).norm();
    Opinion& o = opinions_[count_];
    o = opinion(m.ballPosition, m.ballSpeed, m.ballDeviation, distance, silence, m.playerNumber);
    o.age = age;
    const double away = (m.ballPosition - robotPose.pose.translation).norm();
    o.variance += squared(parameters.drift * static_cast<double>(age) / 1000) +
                  poseVariance(m.robotPoseValidity, distance) +
                  poseVariance(robotPose.validity, away);
    if (std::isfinite(o.variance) && o.position.allFinite()) ++count_;
  }
}

/// Moves a ball on for as long as its message took, and tells how well it was seen.
FusedTeamBallLocator::Opinion FusedTeamBallLocator::opinion(const Vector2d& position,
                                                            const Vector2d& speed, double deviation,
                                                            double distance, std::int64_t age,
                                                            int player) const {
  const double v = speed.norm();
  const double rolls = parameters.deceleration > 0 ? v / parameters.deceleration : 1;
  const double seconds = std::min(static_cast<double>(age) / 1000, rolls);
  const double seen = deviation > 0 ? deviation : parameters.distanceShare * distance;
  Opinion o;
  o.position =
      position + speed * seconds * (v > 0 ? 1 - parameters.deceleration * seconds / v / 2 : 1);
  o.variance = squared(parameters.leastNoise) + squared(seen);
  o.player = player;
  return o;
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

/// The opinion that agrees with most of what is known; one's own while it is fresh.
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
