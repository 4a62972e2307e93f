#pragma once
#include "modules/modeling/selflocator/ParticleLocalization.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *MonteCarlo* of SelfLocator: estimates the robot's pose from bearings on the edges of
/// flags and goals (report 3.3.2). The constants are the report's except two, which its text does
/// not state or which comparisons with the true pose have corrected. A template starts with the
/// probability 0.9, because with less it loses against wrong, but old particles. If no template is
/// left, only 2 % of the improbable particles become random ones, because replacing all of them
/// would thin out the cluster in each image that shows a single landmark.
class MonteCarloSelfLocator {
 public:
  struct Parameters {
    int particles = 100;
    MotionModel motion{};
    LandmarkModel::Parameters landmarks{};
    TemplateReplacement templates{};

    ParticleLocalization::Models models() const {
      return {particles, motion, templates.newProbability, &landmarks, &templates, nullptr};
    }
    static constexpr auto fields() {
      using P = Parameters;
      return Fields{field<&P::particles>("number of particles", {1, 10000}), field<&P::motion>(),
                    field<&P::landmarks>(), field<&P::templates>()};
    }
  };
  Parameters parameters;
  static constexpr std::initializer_list<Likelihood> kinds{Likelihood::landmarks};

  /// Provides the robot's pose on the field. Without a new percept the pose is moved by the
  /// odometry; see ParticleLocalization.
  void update(const LandmarksPercept& landmarks, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug) {
    localization_.update(parameters.models(), {&landmarks}, odometry, field, player, nullptr,
                         robotPose, random, debug);
  }

  const ParticleSet& particles() const { return localization_.particles(); }

 private:
  ParticleLocalization localization_{kinds};
};

}  // namespace gt
