#pragma once
#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

namespace gt {

/// Solution *Fusion* of SelfLocator: Monte-Carlo localization with few particles, which the single
/// landmark self-locator keeps where the robot is: its pose replaces improbable particles, as often
/// as it is valid (report 3.3.1.2).
class FusionSelfLocator {
 public:
  struct Parameters {
    MonteCarloSelfLocator::Parameters monteCarlo{.particles = 30};
    SingleLandmarkSelfLocator::Parameters singleLandmark;

    static constexpr auto fields() {
      return Fields{field("monteCarlo", &Parameters::monteCarlo),
                    field("singleLandmark", &Parameters::singleLandmark)};
    }
  };
  Parameters parameters;

  /// Provides the pose. Without a new percept it follows the odometry; see ParticleLocalization.
  void update(const LandmarksPercept& landmarks, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug) {
    singleLandmark_.parameters = parameters.singleLandmark;
    singleLandmark_.update(landmarks, odometry, field, player, candidate_, debug);
    localization_.update(parameters.monteCarlo.models(), {&landmarks}, odometry, field, player,
                         &candidate_, robotPose, random, debug);
  }

 private:
  SingleLandmarkSelfLocator singleLandmark_;
  ParticleLocalization localization_{Likelihood::landmarks};
  RobotPose candidate_;
};

}  // namespace gt
