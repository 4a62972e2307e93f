#pragma once
#include <array>

#include "debug/Debug.h"
#include "modules/modeling/ball/BallEstimate.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/BallPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *BallChallenge* of BallLocator: models the ball as described in report 3.4.1. The
/// position is measured by the percepts, the speed is computed from the last two of them, and both
/// are floating averages.
class BallChallengeBallLocator {
 public:
  static constexpr int mostPercepts = 32;

  struct Parameters {
    int positions = 3;
    int speeds = 10;
    std::int64_t longestGap = 240;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::positions>("number of percepts over which the position is averaged",
                               {1, mostPercepts}),
          field<&P::speeds>("number of speeds over which the speed is averaged", {1, mostPercepts}),
          field<&P::longestGap>(
              Unit::ms,
              "longest time without the ball that does not end the averages and the consecutive "
              "time seen",
              {0, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the ball relative to the robot. Without a new percept it is moved by the odometry
  /// only. A ball never seen has the time never(). The camera matrix is not checked here: the
  /// ImageProcessor handles an invalid one.
  void update(const BallPercept& percept, const OdometryData& odometry, const FrameInfo& frame,
              BallModel& model, Debug& debug);

 private:
  /// The newest values, in mm or mm/s relative to the robot, and their mean.
  class Average {
   public:
    void clear() { count_ = 0; }
    void add(const Vector2d& value);
    int count() const { return count_; }
    const Vector2d& newest() const { return values_[0]; }
    Vector2d mean(int most) const;
    void move(const Pose2D& step);
    void rotate(double angle);

   private:
    std::array<Vector2d, mostPercepts> values_;  ///< Newest first.
    int count_ = 0;
  };

  Average positions_, speeds_;
  BallEstimate ball_;
  OdometryData lastOdometry_;
  bool first_ = true;
};

}  // namespace gt
