#pragma once
#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Reflection.h"

namespace gt {

/// Tells where the team knows the ball to be: the robot's own ball while it sees it or has seen it
/// a short time ago, otherwise the best of the team mates' balls (report 3.4.2). A solution of
/// TeamBallLocator.
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
          field("ownBallTime", &P::ownBallTime, "ms",
                "since the ball was seen, for which the own one counts alone", {0, 1000000}),
          field("oldestBall", &P::oldestBall, "ms", "age of a team mate's ball that still counts",
                {0, 1000000}),
          field("silence", &P::silence, "ms", "after which a team mate is taken to be gone",
                {0, 1000000}),
          field("costOfDoubt", &P::costOfDoubt, "ms",
                "by which the ball of a team mate that does not know its pose seems older",
                {0, 1000000})};
    }
  };
  Parameters parameters;

  void update(const BallModel& ball, const RobotPose& robotPose, const TeamMessages& messages,
              const FrameInfo& frame, const Player& player, TeamBallModel& teamBall, Debug& debug);

 private:
  /// How bad a ball is: its age, and what its seer's doubt about the own pose costs, in ms.
  double badness(double age, double validity) const {
    return age + parameters.costOfDoubt * (1 - validity);
  }
};

}  // namespace gt
