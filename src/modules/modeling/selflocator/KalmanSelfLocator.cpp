#include "modules/modeling/selflocator/KalmanSelfLocator.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/ParticleDrawing.h"
#include "modules/modeling/selflocator/PoseMeasurements.h"

namespace gt {
namespace {

const DebugKey drawHypotheses{"SelfLocator/hypotheses"};

constexpr double newStandardDeviation = 250, newAngleStandardDeviation = 0.25;  // mm, rad
constexpr double badFit = 0.3, goodFit = 0.5;
constexpr double sameDistance = 120, sameAngle = 0.2;  // mm, rad

double squared(double x) {
  return x * x;
}

}  // namespace

void KalmanSelfLocator::update(const LandmarksPercept& landmarks, const LinesPercept& lines,
                               const CameraMatrix& camera, const OdometryData& odometry,
                               const FieldDimensions& field, const Player& player,
                               RobotPose& robotPose, Random& random, Debug& debug) {
  edges_.prepare(field, player.teamColor);
  hypotheses_.reserve(static_cast<std::size_t>(parameters.hypotheses) + 1);
  move(odometry, std::max(landmarks.time, lines.time));
  const Vector3d& cameraOffset = camera.pose.translation;
  const bool newImage = landmarks.time != lastLandmarks_ || lines.time != lastLines_;
  if (newImage) turnCamera(camera);
  if (landmarks.time != lastLandmarks_) {
    lastLandmarks_ = landmarks.time;
    observeLandmarks(landmarks, field, player.teamColor);
    templates_.update(landmarks, player.teamColor, field);
    addFromLandmarks(random);
  }
  if (lines.time != lastLines_) {
    lastLines_ = lines.time;
    edges_.choose(lines, parameters.points, parameters.farthest, random);
    observeEdges(cameraOffset);
    if (isElsewhere()) view_.clear();
    view_.add(edges_.chosen(), random);
    addFromView(field, random);
  }
  sortOut(field);
  if (newImage) learnCameraErrors();
  if (!hypotheses_.empty()) {
    const Hypothesis& best = hypotheses_.front();
    double sum = 0;
    for (const Hypothesis& h : hypotheses_) sum += std::exp(h.weight);
    robotPose.pose = best.filter.pose();
    robotPose.validity = best.fit / sum / (1 + squared(best.filter.standardDeviation() / 500));
  }
  draw(robotPose, debug);
  gt::draw(edges_, field, robotPose.pose, debug);
}

/// The longer a step, the larger its error. Errors of consecutive steps are correlated over some
/// distance, so their sum has a larger variance than that of independent errors.
void KalmanSelfLocator::move(const OdometryData& odometry, Time now) {
  constexpr double likeWay = 150, likeTurn = 0.5;  // mm, rad
  if (!started_) {
    lastOdometry_ = odometry;
    tiltError_ = parameters.tiltError;
    panError_ = parameters.commonAngle;
  }
  const double seconds = !started_ || last_ == never()
                             ? 0
                             : std::clamp(static_cast<double>(now - last_), 0., 1000.) / 1000;
  started_ = true;
  last_ = now;
  const Pose2D step = odometry.pose.relativeTo(lastOdometry_.pose);
  lastOdometry_ = odometry;
  const Parameters& p = parameters;
  const double way = step.translation.norm();
  const double slipping = squared(p.slip) * likeWay * way + squared(p.drift) * seconds;
  const double turning = squared(p.turnSlip) * likeTurn * (std::abs(step.rotation) + way / 1000) +
                         squared(p.turnDrift) * seconds;
  for (Hypothesis& h : hypotheses_) h.filter.move(step, {slipping, slipping, turning});
  templates_.move(step);
  view_.move(step);
}

/// Predicts the errors of the camera in the next image, which differ from those in the last one.
void KalmanSelfLocator::turnCamera(const CameraMatrix& camera) {
  panSpeed_ = camera.turning.z();
  const CameraErrors errors = cameraErrors();
  for (Hypothesis& h : hypotheses_) h.filter.turnCamera(errors);
}

CameraErrors KalmanSelfLocator::cameraErrors() const {
  const Parameters& p = parameters;
  const double tilt = squared(tiltError_);
  return {{0, 0, imageDelay_ * panSpeed_},
          {tilt, tilt, squared(panError_)},
          p.swayMemory,
          squared(p.leanError),
          p.leanMemory};
}

/// Adapts the variances of the camera's errors to those that the best hypothesis has estimated in
/// this image.
void KalmanSelfLocator::learnCameraErrors() {
  if (hypotheses_.empty() || hypotheses_.front().fit < goodFit) return;
  const Parameters& p = parameters;
  const PoseHypothesis& best = hypotheses_.front().filter;
  const Vector3d off = best.camera() - cameraErrors().mean;
  const Vector3d unsure = best.covariance().diagonal().segment<3>(3);
  const auto learn = [&](double& error, double square) {
    const double variance = squared(error) + p.learning * (square - squared(error));
    error = std::sqrt(std::clamp(variance, squared(p.leastError), squared(p.mostError)));
  };
  learn(tiltError_, (squared(off.x()) + unsure.x() + squared(off.y()) + unsure.y()) / 2);
  learn(panError_, squared(off.z()) + unsure.z());
  imageDelay_ += p.learning * off.z() * panSpeed_ / (1 + squared(panSpeed_));
  constexpr double mostDelay = 0.05;  // s
  imageDelay_ = std::clamp(imageDelay_, -mostDelay, mostDelay);
}

void KalmanSelfLocator::observeLandmarks(const LandmarksPercept& percept,
                                         const FieldDimensions& field, TeamColor team) {
  const Bearings bearings = bearingsIn(percept, team, field);
  if (bearings.count == 0) return;
  const Parameters& p = parameters;
  const Vector2d offset = percept.cameraOffset.head<2>();
  addMirrored();
  view_.add(bearings, offset);
  // A landmark that stands beside its place is seen beside its bearing, the more the nearer it is.
  const auto variance = [&](const Bearing& bearing, const Pose2D& pose) {
    constexpr double nearest = 300;
    const double distance = (bearing.landmark - pose.translation).norm();
    const double error = bearing.radius == 0 ? p.postError : p.flagError;
    return squared(p.bearingError) + squared(error / std::max(distance, nearest));
  };
  const double pan = squared(panError_);
  for (Hypothesis& h : hypotheses_) {
    double sum = 0;
    for (const Bearing& bearing : bearings)
      sum += std::log(p.landmarkSurprise +
                      h.filter.correct(measurementOf(bearing, offset, h.filter,
                                                     variance(bearing, h.filter.pose()), pan),
                                       p.gate));
    for (int i = 0; i < percept.numberOfFlags; ++i) {
      const FlagPercept& flag = percept.flags[static_cast<std::size_t>(i)];
      if (flag.distance > 0)
        h.filter.correct(measurementOf(flag, positionOf(flag.type, team, field), h.filter.pose(),
                                       p.flagDistanceError),
                         p.gate);
    }
    const double fits = judge(h, sum, bearings.count, 1.5);
    h.trust = std::clamp(h.trust + (fits > badFit ? 1 : -2), 0., p.mostTrust);
  }
}

void KalmanSelfLocator::observeEdges(const Vector3d& camera) {
  const std::vector<ChosenPoint>& points = edges_.chosen();
  if (points.empty()) return;
  const Parameters& p = parameters;
  const EdgeErrors errors{p.edgeError, p.pointError, tiltError_, panError_};
  for (Hypothesis& h : hypotheses_) {
    double sum = 0;
    for (const ChosenPoint& chosen : points)
      sum += std::log(p.surprise + h.filter.correct(measurementOf(chosen, edges_.tables(), camera,
                                                                  h.filter, errors),
                                                    p.gate));
    judge(h, sum, static_cast<int>(points.size()), 1);
  }
}

/// Updates the weight of a hypothesis by the average fit of an image's measurements. Many
/// measurements count as a few, because they are not independent.
double KalmanSelfLocator::judge(Hypothesis& hypothesis, double likelihoods, int count,
                                double importance) const {
  constexpr double follow = 0.15;
  const double average = likelihoods / count;
  hypothesis.weight += importance * average * std::min(std::sqrt(count), 3.);
  hypothesis.surprises = std::exp(average) < badFit ? hypothesis.surprises + 1 : 0;
  hypothesis.fit += follow * (std::min(std::exp(average), 1.) - hypothesis.fit);
  return std::exp(average);
}

void KalmanSelfLocator::addFromLandmarks(Random& random) {
  constexpr int most = 3;
  for (int i = 0; i < most; ++i)
    if (const auto pose = templates_.take(random)) add(*pose, parameters.newWeight);
}

/// Returns whether a hypothesis that fitted before does not fit any more: the robot was put
/// somewhere else.
bool KalmanSelfLocator::isElsewhere() const {
  return !hypotheses_.empty() && hypotheses_.front().fit > badFit &&
         hypotheses_.front().surprises >= 2;
}

/// A single measurement could have been seen from nearly everywhere. Of many poses drawn from it,
/// the one that fits the recent measurements best is added, and only while no hypothesis fits. If
/// the best hypothesis fits badly, the weight of the new pose relative to it depends on the
/// difference of their scores in the recent view.
void KalmanSelfLocator::addFromView(const FieldDimensions& field, Random& random) {
  constexpr double lostFit = 0.4;
  constexpr int tried = 60;
  if (!hypotheses_.empty() && hypotheses_.front().fit > goodFit && random.chance(0.9)) return;
  std::optional<Pose2D> best;
  double most = 0.5;
  for (int i = 0; i < tried; ++i) {
    const auto pose = view_.drawPose(edges_.tables(), field, random);
    if (!pose || std::abs(pose->translation.x()) > field.xGroundline ||
        std::abs(pose->translation.y()) > field.ySideline)
      continue;
    const double fits = view_.score(*pose, edges_.tables(), most);
    if (fits <= most) continue;
    most = fits;
    best = pose;
  }
  if (!best) return;
  double behind = parameters.newWeight + 1;
  if (!hypotheses_.empty() && hypotheses_.front().fit < lostFit) {
    constexpr double trust = 40, mostAhead = 6;
    const double known = view_.score(hypotheses_.front().filter.pose(), edges_.tables());
    behind = std::max(-mostAhead, parameters.newWeight - trust * (most - known));
  }
  add(*best, behind);
}

/// Without its landmarks the field is symmetric. Before landmarks are observed, the mirror image of
/// the best hypothesis is added as a hypothesis.
void KalmanSelfLocator::addMirrored() {
  if (hypotheses_.empty()) return;
  Hypothesis mirrored = hypotheses_.front();
  mirrored.filter.mirror();
  mirrored.weight -= parameters.newWeight + mirrored.trust;
  mirrored.trust = 0;
  add(mirrored);
}

/// Adds a pose as a hypothesis. `behind` is the log weight of the best hypothesis relative to it.
void KalmanSelfLocator::add(const Pose2D& pose, double behind) {
  double best = hypotheses_.empty() ? behind : -1e9;
  for (const Hypothesis& h : hypotheses_) best = std::max(best, h.weight - h.trust);
  Hypothesis fresh{{pose, newStandardDeviation, newAngleStandardDeviation}, best - behind, 0.3};
  if (hypotheses_.empty())
    fresh.filter.setLean(Vector2d::Zero(),
                         squared(parameters.leanError) * Eigen::Matrix2d::Identity());
  else
    fresh.filter.setLean(hypotheses_.front().filter.lean(),
                         hypotheses_.front().filter.leanCovariance());
  fresh.filter.turnCamera(cameraErrors());
  add(fresh);
}

/// Adds a hypothesis unless a similar one exists; replaces the worst if there is no room.
void KalmanSelfLocator::add(const Hypothesis& fresh) {
  auto worst = hypotheses_.begin();
  for (auto h = hypotheses_.begin(); h != hypotheses_.end(); ++h) {
    if (h->filter.isNear(fresh.filter.pose(), 2 * sameDistance, 2 * sameAngle)) return;
    if (h->weight < worst->weight) worst = h;
  }
  if (hypotheses_.size() < static_cast<std::size_t>(parameters.hypotheses))
    hypotheses_.push_back(fresh);
  else if (worst->weight < fresh.weight)
    *worst = fresh;
}

/// Sorts the hypotheses, best first, and removes those that are similar to a better one or too
/// improbable.
void KalmanSelfLocator::sortOut(const FieldDimensions& field) {
  if (hypotheses_.empty()) return;
  std::sort(hypotheses_.begin(), hypotheses_.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.weight > b.weight; });
  const double best = hypotheses_.front().weight;
  std::size_t kept = 0;
  for (Hypothesis& h : hypotheses_) {
    h.weight -= best;
    h.filter.clamp(std::max(field.xGoalBack, field.xGroundline), field.ySideline);
    const bool same =
        std::any_of(hypotheses_.begin(), hypotheses_.begin() + static_cast<std::ptrdiff_t>(kept),
                    [&](const Hypothesis& o) {
                      return o.filter.isNear(h.filter.pose(), sameDistance, sameAngle);
                    });
    if (!same && h.weight > -parameters.memory) hypotheses_[kept++] = h;
  }
  hypotheses_.resize(std::min(kept, static_cast<std::size_t>(parameters.hypotheses)));
}

void KalmanSelfLocator::draw(const RobotPose& robotPose, Debug& debug) const {
  if (auto canvas = debug.onField(drawHypotheses))
    for (const Hypothesis& h : hypotheses_) {
      const auto shade = static_cast<std::uint8_t>(255 * std::exp(h.weight / 4));
      const Color color{colors::blue.r, colors::blue.g, colors::blue.b, shade};
      canvas.pose(h.filter.pose(), color, 150);
      // The ellipse of one standard deviation of the position.
      const PoseHypothesis::Covariance& c = h.filter.covariance();
      const double mean = (c(0, 0) + c(1, 1)) / 2, half = (c(0, 0) - c(1, 1)) / 2;
      const double root = std::hypot(half, c(0, 1));
      canvas.ellipse(h.filter.pose().translation, std::sqrt(mean + root),
                     std::sqrt(std::max(mean - root, 0.)), std::atan2(c(0, 1), half) / 2, color);
    }
  drawPose(robotPose.pose, debug);
}

}  // namespace gt
