#pragma once
#include <array>

#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Fused* of TeamBallLocator: fuses the balls of all robots of the team, weighted by the
/// uncertainty that results from the pose of the robot that saw it, from its distance and its age.
/// Balls that do not agree with most of the others do not count, so that a lost robot does no harm
/// (report 6.2.3).
class FusedTeamBallLocator {
 public:
  struct Parameters {
    std::int64_t ownBallTime = 500;
    std::int64_t oldestBall = 5000;
    std::int64_t silence = 3000;
    double leastNoise = 30, distanceShare = 0.08;
    double poseNoise = 60, doubtNoise = 400, directionNoise = 0.06;
    double drift = 500;
    double deceleration = 250;
    double gate = 2.5;

    static constexpr auto fields() {
      using P = Parameters;
      constexpr Range any{0, 1e6};
      return Fields{
          field<&P::ownBallTime>(
              Unit::ms,
              "time since the robot saw the ball during which balls that contradict it do not "
              "count",
              any),
          field<&P::oldestBall>(Unit::ms, "greatest age of a ball that counts", any),
          field<&P::silence>(Unit::ms, "time without a message after which a teammate is ignored",
                             any),
          field<&P::leastNoise>(Unit::mm, "least standard deviation of a seen ball", any),
          field<&P::distanceShare>(
              "standard deviation of a ball as a share of the distance, if the ball locator "
              "provides none",
              any),
          field<&P::poseNoise>(
              Unit::mm, "standard deviation of the position of a robot whose pose has validity 1",
              any),
          field<&P::doubtNoise>(
              Unit::mm, "standard deviation that is added to poseNoise for a pose of validity 0",
              any),
          field<&P::directionNoise>(
              Unit::rad, "standard deviation of a robot's rotation, which moves distant balls",
              any),
          field<&P::drift>(Unit::mmPerS, "growth of a ball's standard deviation with age", any),
          field<&P::deceleration>(Unit::mmPerS2, "deceleration of a rolling ball", any),
          field<&P::gate>("number of standard deviations within which two balls agree", any)};
    }
  };
  Parameters parameters;

  /// Provides the team's ball on the field; one that nobody has seen has the time never() and is
  /// seen by player 0. Messages older than `silence` do not count.
  void update(const BallModel& ball, const RobotPose& robotPose, const TeamMessages& messages,
              const FrameInfo& frame, const Player& player, TeamBallModel& teamBall, Debug& debug);

 private:
  /// The present position of the ball according to one robot.
  struct Opinion {
    Vector2d position = Vector2d::Zero();  ///< mm, on the field
    double variance = 0;                   ///< mm^2, of each coordinate
    std::int64_t age = 0;                  ///< ms
    int player = 0;
  };

  Vector2d wayOf(const Vector2d& speed, std::int64_t ms) const;
  /// Variance of a ball relative to the robot that saw it (mm^2).
  double ballVariance(double standardDeviation, double distance, std::int64_t age) const;
  /// Variance of a ball on the field caused by the error of the robot's pose (mm^2).
  double poseVariance(double validity, double distance) const;
  bool agree(const Opinion& a, const Opinion& b) const;
  void collect(const BallModel& ball, const RobotPose& robotPose, const TeamMessages& messages,
               Time now, int self);
  const Opinion& mostSupported(int self) const;

  std::array<Opinion, 5> opinions_;  ///< The robot's own opinion comes first, if it has one.
  std::size_t count_ = 0;
};

}  // namespace gt
