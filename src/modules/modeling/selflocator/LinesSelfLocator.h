#pragma once
#include "modules/modeling/selflocator/ParticleLocalization.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Lines* of SelfLocator: estimates the robot's pose from points on field lines, the
/// field border and goals, without any beacon (report 3.3.3).
class LinesSelfLocator {
 public:
  struct Parameters {
    int particles = 100;
    MotionModel motion{};
    EdgeModel::Parameters edges{};
    double newLikelihood = 0.5;

    ParticleLocalization::Models models() const {
      return {particles, motion, newLikelihood, nullptr, nullptr, &edges};
    }
    static constexpr auto fields() {
      using P = Parameters;
      return Fields{field<&P::particles>("number of particles", {1, 10000}), field<&P::motion>(),
                    field<&P::edges>(),
                    field<&P::newLikelihood>(
                        "likelihood of each kind of edge of a particle at the start", {0, 1})};
    }
  };
  Parameters parameters;

  /// Provides the robot's pose on the field. Without a new percept the pose is moved by the
  /// odometry; see ParticleLocalization.
  void update(const LinesPercept& lines, const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug) {
    localization_.update(parameters.models(), {nullptr, &lines, &camera}, odometry, field, player,
                         nullptr, robotPose, random, debug);
  }

  const ParticleSet& particles() const { return localization_.particles(); }

 private:
  ParticleLocalization localization_{Likelihood::lines, Likelihood::border, Likelihood::goals};
};

}  // namespace gt
