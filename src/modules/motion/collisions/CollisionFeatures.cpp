#include "modules/motion/collisions/CollisionFeatures.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

// Units of the features, chosen so that their values are about 1.
constexpr double usualAngle = 0.01;                      // rad
constexpr double usualShaking = 2000, usualSpeed = 200;  // mm/s^2, mm/s
constexpr std::array<std::size_t, 2> changes{25, 50};    // frames

/// The logarithm of a root mean square relative to its usual value, which limits the effect of the
/// sensors' noise.
double deviation(double meanSquare, double usual) {
  constexpr double noise = 0.2;
  return std::log(std::sqrt(std::max(0., meanSquare)) / usual + noise);
}

}  // namespace

void CollisionFeatures::add(const SensorData& measured, const JointData& commanded,
                            const MotionInfo& motion, const LegMotors& motors) {
  const MotionRequest& executed = motion.executed;
  const bool walks = executed.type == MotionType::walk || executed.type == MotionType::stand;
  if (!walks || motion.arriving || executed.walkType != walkType_) frames_ = 0;
  walkType_ = executed.walkType;
  ++frames_;
  newest_ = (newest_ + 1) % last_.size();
  Frame& frame = last_[newest_];
  for (std::size_t j = 0; j < legJoints; ++j)
    frame.commands[j] = commanded.angles.values[firstLegJoint + j];
  std::array<double, legJoints> off;
  for (std::size_t j = 0; j < legJoints; ++j)
    off[j] = measured.joints.values[firstLegJoint + j] - motors[j][motorLag];
  for (std::size_t k = 0; k < motorLag; ++k) {
    const auto& commands = before(k).commands;
    for (std::size_t j = 0; j < legJoints; ++j) off[j] -= motors[j][k] * commands[j];
  }
  for (std::size_t j = 0; j < legJoints; ++j) frame.squares[j] = off[j] * off[j];
  frame.acceleration = measured.acceleration;
  const Pose2D& walk = executed.walk;
  frame.speed = {walk.translation.x() / usualSpeed, walk.translation.y() / usualSpeed,
                 walk.rotation};
}

CollisionFeatures::Values CollisionFeatures::values() const {
  Values values{};
  auto value = values.begin();
  std::array<double, states> all{};
  auto state = all.begin();
  std::array<double, legJoints> squares{};
  Vector3d sum = Vector3d::Zero(), sumOfSquares = Vector3d::Zero();
  std::size_t ago = 0;
  for (const std::size_t window : windows) {
    for (; ago < window; ++ago) {
      const Frame& frame = before(ago);
      for (std::size_t j = 0; j < legJoints; ++j) squares[j] += frame.squares[j];
      sum += frame.acceleration;
      sumOfSquares += frame.acceleration.cwiseAbs2();
    }
    const double n = static_cast<double>(window);
    for (const double square : squares) *value++ = deviation(square / n, usualAngle);
    for (std::size_t number = 0; number < 3; ++number) {
      double ofLegs = 0;
      for (std::size_t j = number; j < legJoints; j += 3) ofLegs += squares[j];
      *state++ = deviation(ofLegs / n / 4, usualAngle);
    }
    const Vector3d variance = sumOfSquares / n - (sum / n).cwiseAbs2();
    for (const double axis : variance) *state++ = deviation(axis, usualShaking);
  }
  const Vector3d& speed = before(0).speed;
  for (const double axis : speed) *state++ = std::abs(axis);
  for (const std::size_t frame : changes) *state++ = (speed - before(frame).speed).norm();
  value = std::ranges::copy(all, value).out;
  for (std::size_t a = 0; a < states; ++a)
    for (std::size_t b = a; b < states; ++b) *value++ = all[a] * all[b];
  return values;
}

std::array<double, motorLag> CollisionFeatures::commandsOf(std::size_t joint) const {
  std::array<double, motorLag> commands;
  for (std::size_t k = 0; k < commands.size(); ++k) commands[k] = before(k).commands[joint];
  return commands;
}

Leg CollisionFeatures::mostOff() const {
  EnumArray<Leg, double> squares{};
  for (std::size_t ago = 0; ago < windows.back(); ++ago)
    for (std::size_t j = 0; j < legJoints; ++j) squares.values[j / 3] += before(ago).squares[j];
  return static_cast<Leg>(std::ranges::max_element(squares.values) - squares.values.begin());
}

}  // namespace gt
