#pragma once
#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

namespace gt {

/// Finds the robot's pose by Monte-Carlo localization with few samples, which the single landmark
/// self-locator keeps where the robot is: its pose replaces improbable samples, as often as it is
/// valid (report 3.3.1.2). A solution of SelfLocator.
class FusionSelfLocator {
 public:
  struct Parameters {
    MonteCarloSelfLocator::Parameters monteCarlo{.samples = 30};
    SingleLandmarkSelfLocator::Parameters singleLandmark;

    static constexpr auto fields() {
      return Fields{field("monteCarlo", &Parameters::monteCarlo),
                    field("singleLandmark", &Parameters::singleLandmark)};
    }
  };
  Parameters parameters;

  void update(const LandmarksPercept& percept, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug);

 private:
  MonteCarloSelfLocator monteCarlo_;
  SingleLandmarkSelfLocator singleLandmark_;
  RobotPose candidate_;
};

}  // namespace gt
