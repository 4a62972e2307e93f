#pragma once
#include "base/Random.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "modules/modeling/selflocator/EdgeModel.h"
#include "modules/modeling/selflocator/LandmarkModel.h"
#include "modules/modeling/selflocator/PoseTemplates.h"
#include "modules/modeling/selflocator/SampleSet.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Reflection.h"

namespace gt {

/// Finds the robot's pose by Monte-Carlo localization with all that is seen: bearings on flags and
/// goals as the Monte-Carlo self-locator, points on edges as the lines self-locator (report 3.3). A
/// solution of SelfLocator. The probability of a sample is the product of four: of landmarks, field
/// lines, border and goals.
class GT2003SelfLocator {
 public:
  struct Parameters {
    int samples = 100;
    MotionModel motion{};
    LandmarkModel::Parameters landmarks{};
    TemplateReplacement templates{};
    EdgeModel::Parameters edges{};

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{field("samples", &P::samples, "", "number of hypotheses", {1, 10000}),
                    field("motion", &P::motion), field("landmarks", &P::landmarks),
                    field("templates", &P::templates), field("edges", &P::edges)};
    }
  };
  Parameters parameters;

  /// `samples` is the only parameter whose change allocates.
  void update(const LandmarksPercept& landmarks, const LinesPercept& lines,
              const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug);

  /// The same with a pose that another method has found: improbable samples make room for it, as
  /// often as it is valid.
  void locate(const LandmarksPercept& landmarks, const LinesPercept& lines,
              const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, const RobotPose* candidate,
              RobotPose& robotPose, Random& random, Debug& debug);

  const SampleSet& samples() const { return samples_; }

 private:
  bool observeLandmarks(const LandmarksPercept& percept, const FieldDimensions& field,
                        TeamColor team);
  bool observeEdges(const LinesPercept& percept, const CameraMatrix& camera,
                    const OdometryData& odometry, Random& random);

  SampleSet samples_{Evidence::landmarks, Evidence::lines, Evidence::border, Evidence::goals};
  LandmarkModel landmarks_;
  PoseTemplates templates_;
  EdgeModel edges_;
  SpeedBetweenPictures speed_;
  OdometryData lastOdometry_;
  Time lastLandmarks_ = never(), lastLines_ = never();
  bool search_ = false;
};

}  // namespace gt
