#pragma once
#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Default* of TeamBallLocator: selects the team's ball: the robot's own ball while it
/// sees it or has seen it a short time ago, otherwise the best of the teammates' balls (report
/// 3.4.2).
class DefaultTeamBallLocator {
 public:
  struct Parameters {
    std::int64_t ownBallTime = 3000;
    std::int64_t oldestBall = 5000;
    std::int64_t silence = 3000;
    double costOfDoubt = 4000;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::ownBallTime>(
              Unit::ms, "time since the robot saw the ball during which only its own ball counts",
              {0, 1000000}),
          field<&P::oldestBall>(Unit::ms, "greatest age of a teammate's ball that counts",
                                {0, 1000000}),
          field<&P::silence>(Unit::ms, "time without a message after which a teammate is ignored",
                             {0, 1000000}),
          field<&P::costOfDoubt>(Unit::ms,
                                 "age added to the ball of a teammate that does not know its pose",
                                 {0, 1000000})};
    }
  };
  Parameters parameters;

  /// Provides the team's ball on the field; one that nobody has seen has the time never() and is
  /// seen by player 0. Messages older than `silence` do not count.
  void update(const BallModel& ball, const RobotPose& robotPose, const TeamMessages& messages,
              const FrameInfo& frame, const Player& player, TeamBallModel& teamBall, Debug& debug);

 private:
  /// The cost of a ball in ms: its age, plus a penalty for the uncertain pose of the robot that saw
  /// it.
  double badness(double age, double validity) const {
    return age + parameters.costOfDoubt * (1 - validity);
  }
};

}  // namespace gt
