#pragma once
#include "base/Random.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "modules/modeling/selflocator/EdgeModel.h"
#include "modules/modeling/selflocator/SampleSet.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Reflection.h"

namespace gt {

/// Finds the robot's pose by Monte-Carlo localization with points on field lines, the border and
/// goals, without any beacon (report 3.3.3). A solution of SelfLocator.
class LinesSelfLocator {
 public:
  struct Parameters {
    int samples = 100;
    MotionModel motion{};
    EdgeModel::Parameters edges{};
    double newEvidence = 0.5;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field("samples", &P::samples, "", "number of hypotheses", {1, 10000}),
          field("motion", &P::motion), field("edges", &P::edges),
          field("newEvidence", &P::newEvidence, "", "of each kind, at the start", {0, 1})};
    }
  };
  Parameters parameters;

  /// `samples` is the only parameter whose change allocates.
  void update(const LinesPercept& percept, const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug);

  const SampleSet& samples() const { return samples_; }

 private:
  SampleSet samples_{Evidence::lines, Evidence::border, Evidence::goals};
  EdgeModel edges_;
  SpeedBetweenPictures speed_;
  OdometryData lastOdometry_;
  Time lastPicture_ = never();
  bool search_ = false;
};

}  // namespace gt
