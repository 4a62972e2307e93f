#pragma once
#include <Eigen/Core>
#include <array>

#include "debug/Debug.h"
#include "modules/modeling/ball/BallEstimate.h"
#include "modules/modeling/ball/RollingBall.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Probabilistic* of BallLocator: several hypotheses about the ball's position and speed,
/// each a Kalman filter in the robot's system with a model of a rolling ball. Percepts that fit no
/// hypothesis create a new one: sensor resetting (report 6.2.3).
class ProbabilisticBallLocator {
 public:
  static constexpr int mostHypotheses = 6;

  struct Parameters {
    double deceleration = 250;
    double push = 120;
    double acrossNoise = 5, acrossShare = 0.008;
    double alongNoise = 6, alongShare = 0.015, alongTilt = 1e-5;
    double stepNoise = 0.1;
    double turnNoise = 0.05;
    double newSpeed = 700;
    double kicked = 0.03;
    double falseDensity = 1e-8;
    double newDensity = 4e-9;
    double missed = 0.85;
    double missedRange = 1500;
    std::int64_t forgetAfter = 5000;
    std::int64_t longestGap = 240;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::deceleration>(Unit::mmPerS2, "deceleration of a rolling ball", {0, 10000}),
          field<&P::push>(Unit::mmPerSPerRootS,
                          "standard deviation of a ball's random change of speed in a second",
                          {0, 10000}),
          field<&P::acrossNoise>(
              Unit::mm, "standard deviation of a percept across the line of sight", {1, 1000}),
          field<&P::acrossShare>(
              "standard deviation of a percept across the line of sight that is added, as a share "
              "of the distance",
              {0, 1}),
          field<&P::alongNoise>(Unit::mm, "standard deviation of a percept along the line of sight",
                                {1, 1000}),
          field<&P::alongShare>(
              "standard deviation of a percept along the line of sight that is added, as a share "
              "of the distance",
              {0, 1}),
          field<&P::alongTilt>(
              Unit::perMm,
              "standard deviation along the line of sight that is added for each mm^2 of the "
              "squared distance, by the camera's tilt",
              {0, 1}),
          field<&P::stepNoise>("standard deviation of a step, as a share of its length", {0, 1}),
          field<&P::turnNoise>("standard deviation of a turn, as a share of its angle", {0, 1}),
          field<&P::newSpeed>(
              Unit::mmPerS,
              "standard deviation of the speed of a ball that is new or was just kicked",
              {1, 10000}),
          field<&P::kicked>("probability that a ball is kicked from one image to the next", {0, 1}),
          field<&P::falseDensity>(Unit::perMm2, "density of wrong percepts", {0, 1}),
          field<&P::newDensity>(Unit::perMm2, "density of balls that were moved or kicked",
                                {1e-15, 1}),
          field<&P::missed>(
              "factor to a hypothesis's weight for each image in which the ball should be seen and "
              "is not",
              {0, 1}),
          field<&P::missedRange>(Unit::mm, "distance within which a ball should be seen",
                                 {0, 10000}),
          field<&P::forgetAfter>(
              Unit::ms, "time without the ball after which the next percept is accepted at once",
              {0, 1000000}),
          field<&P::longestGap>(
              Unit::ms, "longest time without the ball that does not end the consecutive time seen",
              {0, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the ball relative to the robot. Without a new percept it is moved by the odometry and
  /// by its speed. Hypotheses of a ball that should be in the image and is not seen lose weight,
  /// but only with a valid camera matrix.
  void update(const BallPercept& percept, const CameraMatrix& camera, const OdometryData& odometry,
              const FrameInfo& frame, BallModel& model, Debug& debug);

 private:
  using State = RollingBall::State;
  using Covariance = Eigen::Matrix4d;
  struct Hypothesis {
    State state = State::Zero();
    Covariance covariance = Covariance::Identity();
    double weight = 0;
    Time lastSeen = never(), seenSince = never();

    Vector2d position() const { return state.head<2>(); }
  };

  void predict(const Pose2D& step, double seconds);
  void addKicked(double seconds);
  void observe(const BallPercept& percept, double seconds);
  double correct(Hypothesis& hypothesis, const Vector2d& seen, const Eigen::Matrix2d& noise) const;
  void miss(const CameraMatrix& camera);
  void tidy();
  Eigen::Matrix2d noiseOf(const Vector2d& seen) const;
  const Hypothesis& best() const { return hypotheses_[0]; }

  std::array<Hypothesis, mostHypotheses + 2> hypotheses_;  ///< The most probable first.
  int count_ = 0;
  Time lastUpdate_ = never(), lastPicture_ = never();
  OdometryData lastOdometry_;
};

}  // namespace gt
