#pragma once
#include "modules/modeling/selflocator/GT2003SelfLocator.h"
#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

namespace gt {

/// A self-locator with few particles that is supported by the single landmark self-locator: its
/// pose replaces improbable particles, with its validity as the probability (report 3.3.1.2).
/// `Seen` are the percepts other than landmarks by which particles are weighted.
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

  /// Provides the robot's pose on the field. Without a new percept the pose is moved by the
  /// odometry; see ParticleLocalization.
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

/// Solution *Fusion* of SelfLocator: uses landmarks only.
using FusionSelfLocator = FusionOf<MonteCarloSelfLocator>;
/// Solution *Fusion2003* of SelfLocator (report 3.3).
using Fusion2003SelfLocator = FusionOf<GT2003SelfLocator, LinesPercept, CameraMatrix>;

}  // namespace gt
