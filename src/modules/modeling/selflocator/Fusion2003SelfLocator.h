#pragma once
#include "modules/modeling/selflocator/GT2003SelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

namespace gt {

/// Solution *Fusion2003* of SelfLocator: does for GT2003 what Fusion does for MonteCarlo (report
/// 3.3).
class Fusion2003SelfLocator {
 public:
  struct Parameters {
    GT2003SelfLocator::Parameters gt2003{.particles = 30};
    SingleLandmarkSelfLocator::Parameters singleLandmark;

    static constexpr auto fields() {
      return Fields{field("gt2003", &Parameters::gt2003),
                    field("singleLandmark", &Parameters::singleLandmark)};
    }
  };
  Parameters parameters;

  /// Provides the pose. Without a new percept it follows the odometry; see ParticleLocalization.
  void update(const LandmarksPercept& landmarks, const LinesPercept& lines,
              const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug) {
    singleLandmark_.parameters = parameters.singleLandmark;
    singleLandmark_.update(landmarks, odometry, field, player, candidate_, debug);
    localization_.update(parameters.gt2003.models(), {&landmarks, &lines, &camera}, odometry, field,
                         player, &candidate_, robotPose, random, debug);
  }

 private:
  SingleLandmarkSelfLocator singleLandmark_;
  ParticleLocalization localization_{Likelihood::landmarks, Likelihood::lines, Likelihood::border,
                                     Likelihood::goals};
  RobotPose candidate_;
};

}  // namespace gt
