#pragma once
#include "modules/modeling/selflocator/GT2003SelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

namespace gt {

/// Finds the robot's pose by the GT2003 self-locator with few samples, which the single landmark
/// self-locator keeps where the robot is: its pose replaces improbable samples, as often as it is
/// valid (report 3.3). A solution of SelfLocator.
class Fusion2003SelfLocator {
 public:
  struct Parameters {
    GT2003SelfLocator::Parameters gt2003{.samples = 30};
    SingleLandmarkSelfLocator::Parameters singleLandmark;

    static constexpr auto fields() {
      return Fields{field("gt2003", &Parameters::gt2003),
                    field("singleLandmark", &Parameters::singleLandmark)};
    }
  };
  Parameters parameters;

  void update(const LandmarksPercept& landmarks, const LinesPercept& lines,
              const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug);

 private:
  GT2003SelfLocator gt2003_;
  SingleLandmarkSelfLocator singleLandmark_;
  RobotPose candidate_;
};

}  // namespace gt
