#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallModel.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/BallPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Smooths the ball percepts by a controller that follows them: its proportional part moves the
/// position, its integral part is the speed (report 3.4.1). A solution of BallLocator.
class PidSmoothedBallLocator {
 public:
  struct Parameters {
    double proportional = 0.35;
    double integral = 0.06;
    double trustedDistance = 800;
    double outlierDistance = 200;
    double outlierShare = 0.25;
    int outliersBelieved = 3;
    std::int64_t forgetPosition = 1000;
    double believedAtOnce = 1500;
    double slowDown = 0.8;
    double slowDownUnseen = 3;
    double fastestBall = 3000;
    std::int64_t longestGap = 240;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field("proportional", &P::proportional, "", "of a deviation that moves the position",
                {0, 1}),
          field("integral", &P::integral, "", "of a deviation per picture that becomes speed",
                {0, 1}),
          field("trustedDistance", &P::trustedDistance, "mm",
                "where a percept's distance counts half, since its noise grows with it", {1, 1e5}),
          field("outlierDistance", &P::outlierDistance, "mm",
                "deviation from which on a percept is doubted", {0, 1e4}),
          field("outlierShare", &P::outlierShare, "", "of the distance, added to outlierDistance",
                {0, 2}),
          field("outliersBelieved", &P::outliersBelieved, "",
                "so many doubted percepts in a row are believed", {1, 100}),
          field("forgetPosition", &P::forgetPosition, "ms",
                "after which the next percept is believed if it is near", {0, 100000}),
          field("believedAtOnce", &P::believedAtOnce, "mm",
                "nearer than that: what is farther away is small in the picture and often wrong",
                {0, 1e5}),
          field("slowDown", &P::slowDown, "1/s", "of a rolling ball", {0, 10}),
          field("slowDownUnseen", &P::slowDownUnseen, "1/s", "of a ball that is not seen",
                {0, 100}),
          field("fastestBall", &P::fastestBall, "mm/s", "that is believed", {1, 1e5}),
          field("longestGap", &P::longestGap, "ms",
                "without the ball that does not end the consecutive time seen", {0, 10000})};
    }
  };
  Parameters parameters;

  void update(const BallPercept& percept, const OdometryData& odometry, const FrameInfo& frame,
              BallModel& model, Debug& debug);

 private:
  void predict(const Pose2D& step, double seconds, bool seen);
  bool isFar(const Vector2d& offset, const Vector2d& expected) const;
  void doubt(const BallPercept& percept);
  void follow(const Vector2d& offset, double seconds);
  void restart(const Vector2d& offset);

  Vector2d position_ = Vector2d::Zero();  ///< mm, relative to the robot.
  Vector2d speed_ = Vector2d::Zero();     ///< mm/s over ground, in the robot's axes.
  Vector2d doubted_ = Vector2d::Zero();   ///< mm, the last percept that was not believed.
  int outliers_ = 0;
  Time lastPercept_ = never(), lastSeen_ = never(), seenSince_ = never(), lastUpdate_ = never();
  Time lastDoubted_ = never();
  OdometryData lastOdometry_;
};

}  // namespace gt
