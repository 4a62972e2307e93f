#pragma once
#include <vector>

#include "base/Random.h"
#include "base/Time.h"
#include "debug/Debug.h"
#include "modules/modeling/selflocator/EdgeModel.h"
#include "modules/modeling/selflocator/PoseHypothesis.h"
#include "modules/modeling/selflocator/PoseTemplates.h"
#include "modules/modeling/selflocator/RecentView.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Kalman* of SelfLocator, which is not in the report: estimates the robot's pose by a
/// few hypotheses. Each is a Kalman filter that uses all measurements: bearings, distances of
/// flags, points on edges, each with its own error. Measurements that fit no hypothesis create new
/// ones. The robot's pose is the hypothesis that fits the recent measurements best.
class KalmanSelfLocator {
 public:
  struct Parameters {
    int hypotheses = 12;
    int points = 8;
    double farthest = 3000;
    double slip = 0.28;
    double turnSlip = 0.3;
    double drift = 6;
    double turnDrift = 0.08;
    double commonAngle = 0.02;
    double swayMemory = 0.65;
    double leanError = 0;
    double leanMemory = 0.9995;
    double learning = 0.01;
    double leastError = 0.003;
    double mostError = 0.06;
    double mostTrust = 8;
    double bearingError = 0.008;
    double flagDistanceError = 0.05;
    double flagError = 100;
    double postError = 30;
    double tiltError = 0.012;
    double pointError = 0.008;
    double edgeError = 8;
    double gate = 3;
    double surprise = 0.1;
    double landmarkSurprise = 0.1;
    double memory = 10;
    double newWeight = 3;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::hypotheses>("greatest number of hypotheses", {1, 100}),
          field<&P::points>("number of points of each type of edge used in an image", {1, 100}),
          field<&P::farthest>(Unit::mm, "greatest distance of points that are used", {1, 1e5}),
          field<&P::slip>("standard deviation of a step, as a share of its length", {0, 10}),
          field<&P::turnSlip>("standard deviation of a turn, as a share of its angle", {0, 10}),
          field<&P::drift>(Unit::mm, "standard deviation that is added to the position in a second",
                           {0, 1e4}),
          field<&P::turnDrift>(
              Unit::rad, "standard deviation that is added to the rotation in a second", {0, 3}),
          field<&P::commonAngle>(
              Unit::rad,
              "initial standard deviation of the camera's pan error, which all measurements of an "
              "image share",
              {1e-6, 1}),
          field<&P::swayMemory>(
              "correlation of the camera's tilt and roll errors with those of the next image",
              {0, 1}),
          field<&P::leanError>(
              Unit::rad,
              "standard deviation of the constant part of the camera's tilt and roll errors; 0: "
              "there is none",
              {0, 1}),
          field<&P::leanMemory>(
              "share of the constant part of the camera's tilt and roll errors that is left an "
              "image later",
              {0, 1}),
          field<&P::learning>(
              "share by which an image changes the estimated variances of the camera's errors",
              {0, 1}),
          field<&P::leastError>(Unit::rad,
                                "least standard deviation of the camera's angles that is learned",
                                {1e-6, 1}),
          field<&P::mostError>(Unit::rad,
                               "greatest standard deviation of the camera's angles that is learned",
                               {1e-6, 1}),
          field<&P::mostTrust>(
              "upper bound of the log weight that a hypothesis gains over its mirror image by "
              "fitting landmarks",
              {0, 1000}),
          field<&P::bearingError>(Unit::rad, "standard deviation of each bearing", {1e-6, 1}),
          field<&P::flagDistanceError>(
              "standard deviation of a flag's distance, as a share of the distance", {1e-6, 1}),
          field<&P::flagError>(Unit::mm, "standard deviation of where flags stand", {0, 1e4}),
          field<&P::postError>(Unit::mm, "standard deviation of where goal posts stand", {0, 1e4}),
          field<&P::tiltError>(
              Unit::rad,
              "initial standard deviation of the camera's tilt and roll errors, which all "
              "measurements of an image share",
              {1e-6, 1}),
          field<&P::pointError>(Unit::rad, "standard deviation of the elevation of each point",
                                {1e-6, 1}),
          field<&P::edgeError>(Unit::mm, "standard deviation of edges from the model", {1e-3, 1e3}),
          field<&P::gate>(
              "measurements farther from the prediction, in standard deviations, are rejected",
              {0.1, 100}),
          field<&P::surprise>("probability that a point or a bearing is seen wrongly", {1e-6, 1}),
          field<&P::landmarkSurprise>("probability that a landmark is seen wrongly", {1e-6, 1}),
          field<&P::memory>(
              "greatest log weight of the best hypothesis relative to another one that is kept",
              {0.1, 1000}),
          field<&P::newWeight>("log weight of the best hypothesis relative to a new one",
                               {0, 1000})};
    }
  };
  Parameters parameters;

  /// Provides the pose of the best hypothesis on the field. Without a new percept all hypotheses
  /// are moved by the odometry. Percepts count whether or not the camera matrix is valid;
  /// measurements that contradict a hypothesis are rejected by the gate. `hypotheses` is the only
  /// parameter whose change allocates.
  void update(const LandmarksPercept& landmarks, const LinesPercept& lines,
              const CameraMatrix& camera, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Random& random, Debug& debug);

  /// A possible pose, and how well it fits the measurements compared with others.
  struct Hypothesis {
    PoseHypothesis filter;
    double weight = 0;  ///< Logarithm of the probability relative to the best one, which has 0.
    double fit = 0.5;   ///< Average fit of the last images, in [0, 1].
    int surprises = 0;  ///< Number of consecutive images that did not fit at all.
    double trust = 0;   ///< Log weight gained over its mirror image by fitting landmarks.
  };
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }

 private:
  void move(const OdometryData& odometry, Time now);
  void observeLandmarks(const LandmarksPercept& percept, const FieldDimensions& field,
                        TeamColor team);
  void observeEdges(const Vector3d& camera);
  void turnCamera(const CameraMatrix& camera);
  CameraErrors cameraErrors() const;
  void learnCameraErrors();
  double judge(Hypothesis& hypothesis, double likelihoods, int count, double importance) const;
  void addFromLandmarks(Random& random);
  bool isElsewhere() const;
  void addMirrored();
  void addFromView(const FieldDimensions& field, Random& random);
  void add(const Pose2D& pose, double behind);
  void add(const Hypothesis& fresh);
  void sortOut(const FieldDimensions& field);
  void draw(const RobotPose& robotPose, Debug& debug) const;

  std::vector<Hypothesis> hypotheses_;  ///< The best one comes first after each image.
  EdgeModel edges_;
  PoseTemplates templates_;
  RecentView view_;
  OdometryData lastOdometry_;
  Time last_ = never(), lastLandmarks_ = never(), lastLines_ = never();
  bool started_ = false;
  // Estimated errors of the camera.
  double tiltError_ = 0, panError_ = 0;  ///< Standard deviations, rad.
  double imageDelay_ = 0;                ///< By which images are older than their time stamps, s.
  double panSpeed_ = 0;                  ///< Of the camera during the image, rad/s.
};

}  // namespace gt
