#pragma once
#include "debug/Debug.h"
#include "modules/modeling/ball/BallEstimate.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/BallPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *PIDSmoothed* of BallLocator: smooths the ball percepts by a controller that follows
/// them. Its proportional part moves the position, its integral part is the speed (report 3.4.1).
class PIDSmoothedBallLocator {
 public:
  struct Parameters {
    double proportional = 0.6;
    double integral = 0.25;
    double trustedDistance = 1300;
    double outlierDistance = 200;
    double outlierShare = 0.25;
    int outliersBelieved = 3;
    std::int64_t forgetPosition = 1000;
    double believedAtOnce = 1500;
    double slowDown = 0.3;
    double slowDownUnseen = 0.8;
    double fastestBall = 3000;
    std::int64_t longestGap = 240;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::proportional>(
              "share of the difference to a percept by which the position moves", {0, 1}),
          field<&P::integral>(
              "share of the difference to a percept, per time since the last one, that is added to "
              "the speed",
              {0, 1}),
          field<&P::trustedDistance>(
              Unit::mm,
              "distance of the ball at which a percept's distance, whose noise grows with it, has "
              "half of the weight",
              {1, 1e5}),
          field<&P::outlierDistance>(Unit::mm, "difference beyond which a percept is doubted",
                                     {0, 1e4}),
          field<&P::outlierShare>("share of the ball's distance that is added to outlierDistance",
                                  {0, 2}),
          field<&P::outliersBelieved>(
              "number of consecutive doubted percepts after which they are accepted", {1, 100}),
          field<&P::forgetPosition>(
              Unit::ms,
              "time without the ball after which the next percept is accepted if it is near",
              {0, 100000}),
          field<&P::believedAtOnce>(
              Unit::mm,
              "greatest distance of a percept that is accepted at once after forgetPosition; "
              "farther ones are small in the image and often wrong",
              {0, 1e5}),
          field<&P::slowDown>(Unit::perS,
                              "share of the speed that a rolling ball loses in a second", {0, 10}),
          field<&P::slowDownUnseen>(
              Unit::perS, "share of the speed that a ball loses in a second while it is not seen",
              {0, 100}),
          field<&P::fastestBall>(Unit::mmPerS, "greatest speed of a ball", {1, 1e5}),
          field<&P::longestGap>(
              Unit::ms, "longest time without the ball that does not end the consecutive time seen",
              {0, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the ball relative to the robot. Without a new percept it is moved by the odometry and
  /// by its speed. A ball never seen has the time never(). The camera matrix is not checked here:
  /// the ImageProcessor handles an invalid one.
  void update(const BallPercept& percept, const OdometryData& odometry, const FrameInfo& frame,
              BallModel& model, Debug& debug);

 private:
  void predict(const Pose2D& step, double seconds, bool seen);
  bool isFar(const Vector2d& offset, const Vector2d& expected) const;
  void doubt(const BallPercept& percept);
  void follow(const Vector2d& offset, double seconds);
  void restart(const Vector2d& offset);

  BallEstimate ball_;
  Vector2d doubted_ = Vector2d::Zero();  ///< The last doubted percept, mm, relative to the robot.
  int outliers_ = 0;
  Time lastPercept_ = never(), lastUpdate_ = never(), lastDoubted_ = never();
  OdometryData lastOdometry_;
};

}  // namespace gt
