#pragma once
#include "modules/modeling/selflocator/ParticleLocalization.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *GT2003* of SelfLocator: estimates the robot's pose from all percepts, bearings on
/// flags and goals as in MonteCarlo, points on edges as in Lines (report 3.3). The probability of a
/// particle is the product of four likelihoods: of landmarks, field lines, border and goals.
class GT2003SelfLocator {
 public:
  struct Parameters {
    int particles = 100;
    MotionModel motion{};
    LandmarkModel::Parameters landmarks{};
    TemplateReplacement templates{};
    EdgeModel::Parameters edges{};

    ParticleLocalization::Models models() const {
      return {particles, motion, templates.newProbability, &landmarks, &templates, &edges};
    }
    static constexpr auto fields() {
      using P = Parameters;
      return Fields{field<&P::particles>("number of particles", {1, 10000}), field<&P::motion>(),
                    field<&P::landmarks>(), field<&P::templates>(), field<&P::edges>()};
    }
  };
  Parameters parameters;
  static constexpr std::initializer_list<Likelihood> kinds{Likelihood::landmarks, Likelihood::lines,
                                                           Likelihood::border, Likelihood::goals};

  /// Provides the robot's pose on the field. Without a new percept the pose is moved by the
  /// odometry; see ParticleLocalization.
  void update(const LandmarksPercept& landmarks, const LinesPercept& lines,
              const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug) {
    localization_.update(parameters.models(), {&landmarks, &lines, &camera}, odometry, field,
                         player, nullptr, robotPose, random, debug);
  }

  const ParticleSet& particles() const { return localization_.particles(); }

 private:
  ParticleLocalization localization_{kinds};
};

}  // namespace gt
