#pragma once
#include "base/Random.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "modules/modeling/selflocator/LandmarkModel.h"
#include "modules/modeling/selflocator/PoseTemplates.h"
#include "modules/modeling/selflocator/SampleSet.h"
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
    MotionModel motion{};
    LandmarkModel::Parameters landmarks{};
    TemplateReplacement templates{};

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{field("samples", &P::samples, "", "number of hypotheses", {1, 10000}),
                    field("motion", &P::motion), field("landmarks", &P::landmarks),
                    field("templates", &P::templates)};
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

  const SampleSet& samples() const { return samples_; }

 private:
  SampleSet samples_{Evidence::landmarks};
  LandmarkModel landmarks_;
  PoseTemplates templates_;
  OdometryData lastOdometry_;
  Time lastPicture_ = never();
  bool search_ = false;
};

}  // namespace gt
