#pragma once
#include <vector>

#include "base/Random.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "modules/modeling/Bearings.h"
#include "modules/modeling/PoseTemplates.h"
#include "modules/modeling/SampleSet.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/OdometryData.h"
#include "streams/Reflection.h"

namespace gt {

/// Finds the robot's pose by Monte-Carlo localization with bearings on the edges of flags and goals
/// (report 3.3.2). A solution of SelfLocator. The constants are the report's but for two on which
/// its text is silent or which the truth corrects: a template starts with the probability 0.9, for
/// at less it loses against the samples that are wrong but old; and where no template is left, only
/// 2 % of the improbable samples become random ones, for all of them would thin out the cluster in
/// each picture that shows a single landmark.
class MonteCarloSelfLocator {
 public:
  struct Parameters {
    int samples = 100;
    double forwardError = 0.1;
    double sidewardError = 0.02;
    double turnErrorByDistance = 0.002;
    double turnErrorByAngle = 0.2;
    double steepness = 50;
    double rise = 0.1;
    double fall = 0.05;
    double replacement = 1;
    double randomReplacement = 0.02;
    double newProbability = 0.9;
    double searchDistance = 100;
    double searchAngle = 0.5;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field("samples", &P::samples, "", "number of hypotheses", {1, 10000}),
          field("forwardError", &P::forwardError, "", "of the distance walked, (3.8)", {0, 1}),
          field("sidewardError", &P::sidewardError, "", "of the distance walked, (3.8)", {0, 1}),
          field("turnErrorByDistance", &P::turnErrorByDistance, "rad/mm", "(3.8)", {0, 0.1}),
          field("turnErrorByAngle", &P::turnErrorByAngle, "", "of the angle turned, (3.8)", {0, 1}),
          field("steepness", &P::steepness, "", "of the similarity of bearings, (3.11)", {0, 1e5}),
          field("rise", &P::rise, "", "of a probability in one picture at most, (3.13)", {0, 1}),
          field("fall", &P::fall, "", "of a probability in one picture at most, (3.13)", {0, 1}),
          field("replacement", &P::replacement, "",
                "how often an improbable sample makes room for a template", {0, 1}),
          field("randomReplacement", &P::randomReplacement, "",
                "how often a sample that no template replaces becomes a random one", {0, 1}),
          field("newProbability", &P::newProbability, "", "of a template or random sample", {0, 1}),
          field("searchDistance", &P::searchDistance, "mm", "of the random search, (3.14)",
                {0, 1000}),
          field("searchAngle", &P::searchAngle, "rad", "of the random search, (3.14)", {0, 3})};
    }
  };
  Parameters parameters;

  /// `samples` is the only parameter whose change allocates.
  void update(const LandmarksPercept& percept, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug);

  /// The same with a pose that another method has found: improbable samples make room for it, as
  /// often as it is valid.
  void locate(const LandmarksPercept& percept, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, const RobotPose* candidate,
              RobotPose& robotPose, Random& random, Debug& debug);

  const std::vector<Sample>& samples() const { return samples_; }

 private:
  void moveSamples(const Pose2D& step, const FieldDimensions& field, Random& random);
  void observe(const Bearings& bearings, const Vector2d& cameraOffset);
  void draw(const RobotPose& robotPose, Debug& debug) const;
  void replaceSamples(const FieldDimensions& field, const RobotPose* candidate, Random& random);

  std::vector<Sample> samples_, buffer_;
  PoseTemplates templates_;
  OdometryData lastOdometry_;
  Time lastPicture_ = never();
  bool search_ = false;
};
static_assert(complete<MonteCarloSelfLocator::Parameters>);

}  // namespace gt
