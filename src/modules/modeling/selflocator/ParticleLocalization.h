#pragma once
#include "base/Random.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "modules/modeling/selflocator/EdgeModel.h"
#include "modules/modeling/selflocator/LandmarkModel.h"
#include "modules/modeling/selflocator/ParticleSet.h"
#include "modules/modeling/selflocator/PoseTemplates.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Monte-Carlo localization (report 3.3.2, 3.3.3), of which the self-locators with particles are
/// made: they differ in what they see. Particles move by the odometry, the likelihoods of what
/// is seen judge them, improbable ones make room for poses from which it might have been seen, and
/// the fullest place is where the robot is.
class ParticleLocalization {
 public:
  /// The parameters of the solution; null for what it does not see.
  struct Models {
    int particles;
    const MotionModel& motion;
    double newProbability;  ///< Of particles at the start.
    const LandmarkModel::Parameters* landmarks = nullptr;
    const TemplateReplacement* templates = nullptr;  ///< If landmarks are seen.
    const EdgeModel::Parameters* edges = nullptr;
  };
  /// What is seen; null where the models are.
  struct Percepts {
    const LandmarksPercept* landmarks = nullptr;
    const LinesPercept* lines = nullptr;
    const CameraMatrix* camera = nullptr;  ///< If lines are seen.
  };

  /// Particles with a filtered probability for each of these.
  explicit ParticleLocalization(std::initializer_list<Likelihood> kinds) : particles_{kinds} {}

  /// Provides the pose after an image, or after a step without one: a percept counts once, by its
  /// time, and without a new one the pose follows the odometry. Percepts count whether or not their
  /// camera matrix was valid, since a wrong one is outweighed soon. A candidate is a pose that
  /// another method has found: improbable particles make room for it, as often as it is valid. A
  /// change of `Models::particles` is all that allocates.
  void update(const Models& models, const Percepts& percepts, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, const RobotPose* candidate,
              RobotPose& robotPose, Random& random, Debug& debug);

  const ParticleSet& particles() const { return particles_; }

 private:
  bool observe(const LandmarkModel::Parameters& parameters, const LandmarksPercept& percept,
               const FieldDimensions& field, TeamColor team);
  bool observe(const EdgeModel::Parameters& parameters, const LinesPercept& percept,
               const CameraMatrix& camera, const OdometryData& odometry, Random& random);

  ParticleSet particles_;
  LandmarkModel landmarks_;
  PoseTemplates templates_;
  EdgeModel edges_;
  SpeedBetweenImages speed_;
  OdometryData lastOdometry_;
  Time lastLandmarks_ = never(), lastLines_ = never();
  bool search_ = false;
};

}  // namespace gt
