#pragma once
#include <array>
#include <optional>

#include "base/Geometry.h"
#include "base/Random.h"
#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/ParticleSet.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A point on the field (mm) and the direction in which it is seen, in the observer's system.
struct Sighting {
  Vector2d landmark;
  Vector2d direction;  ///< Need not be normalized.
};

/// The pose from which three landmarks are seen in three directions; nothing if the three and the
/// observer lie on one circle, or if a landmark would lie behind (report 3.3.2.3).
std::optional<Pose2D> triangulate(const Sighting& a, const Sighting& b, const Sighting& c);

/// Computes the one or two poses from which one landmark is seen in a direction and at a distance
/// (the length of `located.direction` in mm), and another one in a direction (report 3.3.2.3).
/// Returns the number of poses.
int posesFrom(const Sighting& located, const Sighting& second, std::array<Pose2D, 2>& poses);

/// Candidate poses for sensor resetting, calculated from the landmarks of this image and the last
/// three flags seen (report 3.3.2.3). Each is returned once.
class PoseTemplates {
 public:
  /// Moves the memorized flags by a step of the robot (mm, rad).
  void move(const Pose2D& odometry);
  /// Memorizes the image's flags, and recomputes all poses.
  void update(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field);
  /// Returns and removes a random pose; nothing if none is left.
  std::optional<Pose2D> take(Random& random);
  int size() const { return count_; }

 private:
  struct MemorizedFlag {
    FlagType type = FlagType::pinkAboveYellow;
    Vector2d position = Vector2d::Zero();  ///< mm, relative to the robot.
  };

  void memorize(const FlagPercept& flag);
  void triangulateAll(const LandmarksPercept& percept, TeamColor team);
  void locateByFlags(const LandmarksPercept& percept, TeamColor team);
  void add(const Pose2D& camera);

  FieldDimensions field_;
  Vector2d cameraOffset_ = Vector2d::Zero();
  std::array<MemorizedFlag, 3> flags_;  ///< The one seen last comes first.
  int numberOfFlags_ = 0;
  std::array<Pose2D, 96> poses_;
  int count_ = 0;
};

/// How templates replace improbable particles (report 3.3.2.3).
struct TemplateReplacement {
  double replacement = 1;
  double randomReplacement = 0.02;
  double newProbability = 0.9;

  static constexpr auto fields() {
    using T = TemplateReplacement;
    return Fields{
        field<&T::replacement>("probability that an improbable particle is replaced by a template",
                               {0, 1}),
        field<&T::randomReplacement>(
            "probability that an improbable particle becomes a random one if no template is left",
            {0, 1}),
        field<&T::newProbability>("likelihood of landmarks of a template or random particle",
                                  {0, 1})};
  }
};

/// Replaces each particle with a probability of 1 minus its likelihood of landmarks: by the
/// candidate, if there is one, with its validity as the probability; otherwise by a template;
/// otherwise by a random pose. The likelihoods of other kinds become the averages.
void replaceByTemplates(const TemplateReplacement& parameters, PoseTemplates& templates,
                        const RobotPose* candidate, const FieldDimensions& field,
                        ParticleSet& particles, Random& random);

}  // namespace gt
