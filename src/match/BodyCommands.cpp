#include "match/BodyCommands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gt {
namespace {

bool isWithin(double value, double most) {
  return std::abs(value) <= most;  // not so for NaN
}

constexpr double farAway = 1e6;  // mm

bool isSane(const Pose2D& pose) {
  return isWithin(pose.rotation, farAway) && isWithin(pose.translation.x(), farAway) &&
         isWithin(pose.translation.y(), farAway);
}

}  // namespace

bool isSane(const JointData& joints) {
  return std::ranges::all_of(joints.angles.values,
                             [](double angle) { return isWithin(angle, std::numbers::pi); });
}

bool isSane(const JointGains& joints) {
  const auto word = [](int value) { return value >= 0 && value <= 255; };
  return std::ranges::all_of(joints.gains.values, [&](const PidGains& gains) {
    return word(gains.p) && word(gains.i) && word(gains.d);
  });
}

bool isSane(const OdometryData& odometry) {
  return isSane(odometry.pose);
}

bool isSane(const TeamMessage& message) {
  const bool opponents = std::ranges::all_of(message.opponents, [](const SeenOpponent& seen) {
    return isSane({0, seen.position}) && isWithin(seen.validity, 1) &&
           isWithin(seen.standardDeviation, farAway);
  });
  return opponents && isSane(message.robotPose) && isSane({0, message.ballPosition}) &&
         isWithin(message.robotPoseValidity, 1) &&
         !std::isnan(message.behavior.estimatedTimeToReachBall);
}

template <typename T>
void BodyCommands::give(T& command, bool) const {
  if (const T* given = place<T>()) command = *given;
}

void BodyCommands::give(std::optional<TeamMessage>& message, bool withImage) const {
  if (const auto* given = place<TeamMessage>();
      given && withImage && images_ % imagesPerTeamMessage == 0)
    message = *given;
}

void BodyCommands::give(std::optional<CameraSettings>& settings, bool) {
  if (const auto* given = place<CameraSettings>(); given && *given != camera)
    settings = camera = *given;
}

void BodyCommands::give(RobotOutput& output, const Belief& belief, bool withImage) {
  images_ += withImage;
  output.forEach([&](auto& command) { give(command, withImage); });
  if (belief.motion) output.specialAction = belief.motion->executed.specialAction;
}

}  // namespace gt
