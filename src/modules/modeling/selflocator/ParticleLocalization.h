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

/// Monte-Carlo localization (report 3.3.2, 3.3.3), shared by the self-locators with particles,
/// which differ in the percepts that they use. Particles are moved by the odometry and weighted by
/// the likelihoods of the percepts. Improbable particles are replaced by poses consistent with the
/// percepts. The robot's pose is the mean of the largest cluster of particles.
class ParticleLocalization {
 public:
  /// The parameters of the solution; null for percepts that it does not use.
  struct Models {
    int particles;
    const MotionModel& motion;
    double newProbability;  ///< Likelihood of particles at the start.
    const LandmarkModel::Parameters* landmarks = nullptr;
    const TemplateReplacement* templates = nullptr;  ///< Required if landmarks are used.
    const EdgeModel::Parameters* edges = nullptr;
  };
  /// The percepts; null where the models are null.
  struct Percepts {
    const LandmarksPercept* landmarks = nullptr;
    const LinesPercept* lines = nullptr;
    const CameraMatrix* camera = nullptr;  ///< Required if lines are used.
  };

  /// Creates particles with a filtered likelihood of each of these kinds.
  explicit ParticleLocalization(std::initializer_list<Likelihood> kinds) : particles_{kinds} {}

  /// Provides the pose on the field after an image, or after a step without one. A percept counts
  /// once, identified by its time; without a new one the pose is moved by the odometry. Percepts
  /// count whether or not their camera matrix was valid, since a wrong one is soon outweighed.
  /// `candidate` is a pose found by another method, or null: it replaces improbable particles, with
  /// its validity as the probability. Only a change of `Models::particles` allocates.
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
