#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/Statistics.h"
#include "modules/modeling/testing/SyntheticRobot.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Counts the images until an estimate is near the truth and stays there for a second.
class ImagesUntilLocalized {
 public:
  /// Reports one image; the error in mm.
  void add(double error) {
    ++pictures_;
    good_ = error < near ? good_ + 1 : 0;
  }
  /// The first image from which on the estimate was near; empty if it never stayed near.
  std::optional<int> result() const {
    return done() ? std::optional{pictures_ - good_ + 1} : std::nullopt;
  }
  bool done() const { return good_ >= 25; }

  static constexpr double near = 200;  ///< mm

 private:
  int pictures_ = 0, good_ = 0;
};

/// The errors of a self-locator compared with the truth.
struct LocalizationTrial {
  std::vector<double> errors;  ///< mm, of each image
  std::vector<double> angles;  ///< rad, of each image
  double longestLost = 0;      ///< s, longest time for which the error was above 600 mm
};

/// Lets a locator follow a robot for some images. `locate(robot)` returns the RobotPose.
template <typename Robot, typename Locate>
LocalizationTrial follow(Robot& robot, int pictures, Locate&& locate) {
  LocalizationTrial trial;
  double lost = 0;
  for (int i = 0; i < pictures; ++i) {
    robot.step();
    const RobotPose estimate = locate(robot);
    const double error = (estimate.pose.translation - robot.pose.translation).norm();
    trial.errors.push_back(error);
    trial.angles.push_back(std::abs(normalize(estimate.pose.rotation - robot.pose.rotation)));
    lost = error > 600 ? lost + SyntheticRobot::imagePeriod / 1000.0 : 0;
    trial.longestLost = std::max(trial.longestLost, lost);
  }
  return trial;
}

/// The number of images until a locator has found the robot, at most `most`.
template <typename Robot, typename Locate>
int imagesUntilLocalized(Robot& robot, int most, Locate&& locate) {
  ImagesUntilLocalized counter;
  for (int i = 0; i < most && !counter.done(); ++i) {
    robot.step();
    counter.add((locate(robot).pose.translation - robot.pose.translation).norm());
  }
  return counter.result().value_or(most);
}

}  // namespace gt
