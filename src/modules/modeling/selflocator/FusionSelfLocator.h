#pragma once
#include "modules/modeling/selflocator/GT2003SelfLocator.h"
#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

namespace gt {

/// A self-locator with few particles, which the single landmark self-locator keeps where the robot
/// is: its pose replaces improbable particles, as often as it is valid (report 3.3.1.2). `Seen` is
/// what the particles are judged by besides landmarks.
template <typename Particles, typename... Seen>
class FusionOf {
 public:
  struct Parameters {
    typename Particles::Parameters localization{.particles = 30};
    SingleLandmarkSelfLocator::Parameters singleLandmark;

    static constexpr auto fields() {
      return Fields{field<&Parameters::localization>(), field<&Parameters::singleLandmark>()};
    }
  };
  Parameters parameters;

  /// Provides the pose. Without a new percept it follows the odometry; see ParticleLocalization.
  void update(const LandmarksPercept& landmarks, const Seen&... seen, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug) {
    singleLandmark_.parameters = parameters.singleLandmark;
    singleLandmark_.update(landmarks, odometry, field, player, candidate_, debug);
    localization_.update(parameters.localization.models(), {&landmarks, &seen...}, odometry, field,
                         player, &candidate_, robotPose, random, debug);
  }

 private:
  SingleLandmarkSelfLocator singleLandmark_;
  ParticleLocalization localization_{Particles::kinds};
  RobotPose candidate_;
};

/// Solution *Fusion* of SelfLocator.
using FusionSelfLocator = FusionOf<MonteCarloSelfLocator>;
/// Solution *Fusion2003* of SelfLocator (report 3.3).
using Fusion2003SelfLocator = FusionOf<GT2003SelfLocator, LinesPercept, CameraMatrix>;

}  // namespace gt
