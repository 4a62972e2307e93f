#include "modules/perception/specialists/TiltCorrection.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr double edgeError = 0.5;    // Pixels, of an edge of a landmark,
constexpr double footError = 1.5;    // and of a goal's foot, which robots hide in part.
constexpr double radiusError = 0.3;  // Pixels, of a ball.
constexpr double sizeError = 0.03;   // Of all sizes, as a share: blur and colors.
constexpr double mostOff = 3;        // Standard deviations: what is off by more is something else.
constexpr double memory = 0.95;      // The share of the variance that a percept leaves.
constexpr double leastVariance = fromDegrees(0.1) * fromDegrees(0.1);
constexpr double mostVariance = fromDegrees(2) * fromDegrees(2);

}  // namespace

const CameraMatrix& TiltCorrection::correct(const CameraMatrix& matrix, const BallPercept& ball,
                                            const LandmarksPercept& landmarks,
                                            const FieldDimensions& field) {
  corrected_ = matrix;
  information_ = Eigen::Matrix2d::Identity() / variance_;
  weighted_ = Vector2d::Zero();
  addBall(ball, field.ballRadius);
  for (int i = 0; i < landmarks.numberOfFlags; ++i)
    addFlag(landmarks.flags[static_cast<std::size_t>(i)], field);
  for (int i = 0; i < landmarks.numberOfGoals; ++i)
    addGoal(landmarks.goals[static_cast<std::size_t>(i)], field);
  // A rotation about x and y that lowers what is seen too high.
  const Vector2d turn = information_.inverse() * weighted_;
  const Matrix3d rotation = rotationY(turn.y()) * rotationX(turn.x());
  corrected_.pose.rotation = rotation * corrected_.pose.rotation;
  return corrected_;
}

void TiltCorrection::add(double azimuth, double tooHigh, double deviation) {
  const double variance = deviation * deviation;
  if (std::abs(tooHigh) > mostOff * std::sqrt(variance_ + variance)) return;
  const Vector2d lowers{-std::sin(azimuth), std::cos(azimuth)};
  information_ += lowers * lowers.transpose() / variance;
  weighted_ += lowers * (tooHigh / variance);
  variance_ = std::clamp(memory * variance_ + (1 - memory) * (tooHigh * tooHigh - variance),
                         leastVariance, mostVariance);
}

void TiltCorrection::addBall(const BallPercept& ball, double ballRadius) {
  if (!ball.seen || ball.distanceBySize == 0 || ball.distanceByProjection == 0) return;
  const double lower = corrected_.pose.translation.z() - ballRadius;
  const CameraInfo& info = corrected_.info;
  const Vector2d& center = ball.centerInImage;
  const double radius = ball.radiusInImage;
  const bool whole = center.x() > radius && center.x() < info.width - radius &&
                     center.y() > radius && center.y() < info.height - radius;
  if (!whole || lower <= 0 || lower >= ball.distanceBySize) return;
  const double down = std::asin(lower / ball.distanceBySize);
  add(ball.angle.x(), down - std::asin(lower / ball.distanceByProjection),
      std::tan(down) * std::hypot(sizeError, radiusError / radius));
}

void TiltCorrection::addFlag(const FlagPercept& flag, const FieldDimensions& field) {
  addStanding(flag.boundary, field.flagBottom, field.flagTop, edgeError);
}

void TiltCorrection::addGoal(const GoalPercept& goal, const FieldDimensions& field) {
  addStanding(goal.boundary, 0, field.goalHeight, footError);
}

void TiltCorrection::addStanding(const ConditionalBoundary& b, double low, double high,
                                 double error) {
  if (b.topOnBorder || b.bottomOnBorder) return;
  const double pixel = 1 / corrected_.info.focalX;
  const double height = std::tan(b.top) - std::tan(b.bottom), distance = (high - low) / height;
  const double above = (low + high) / 2 - corrected_.pose.translation.z();
  const double middle = (std::tan(b.top) + std::tan(b.bottom)) / 2;
  const double bySize = above / distance * std::hypot(sizeError, edgeError * pixel / height);
  add((b.left + b.right) / 2, std::atan(middle) - std::atan2(above, distance),
      std::hypot(error * pixel, bySize));
}

}  // namespace gt
