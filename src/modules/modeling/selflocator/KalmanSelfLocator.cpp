#include "modules/modeling/selflocator/KalmanSelfLocator.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/ParticleDrawing.h"

namespace gt {
namespace {

const DebugKey drawHypotheses{"SelfLocator/hypotheses"};
const DebugKey drawPose{"SelfLocator/pose"};

constexpr double newStandardDeviation = 250, newAngleStandardDeviation = 0.25;  // mm, rad
constexpr double badFit = 0.3;
constexpr double sameDistance = 120, sameAngle = 0.2;  // mm, rad

double squared(double x) {
  return x * x;
}

/// A bearing on the edge of a flag or a goal, as seen by a hypothesis (report (3.10)).
ScalarMeasurement measurementOf(const Bearing& bearing, const Vector2d& cameraOffset,
                                const Pose2D& pose, double variance) {
  const Vector2d offset = rotated(cameraOffset, pose.rotation);
  const Vector2d way = bearing.landmark - pose.translation - offset;
  const double distance = std::max(way.norm(), 1.01 * std::abs(bearing.radius) + 1);
  const double expected = angleOf(way) - pose.rotation + std::asin(bearing.radius / distance);
  const Vector2d byPosition = Vector2d{way.y(), -way.x()} / squared(distance);
  const double byRotation = byPosition.dot(Vector2d{-offset.y(), offset.x()}) - 1;
  return {normalize(angleOf(bearing.direction) - expected),
          {byPosition.x(), byPosition.y(), byRotation},
          variance};
}

/// The distance of a flag, as seen by a hypothesis.
ScalarMeasurement distanceOf(const FlagPercept& flag, const Vector2d& position, const Pose2D& pose,
                             double relativeError) {
  const Vector2d way = position - pose.translation;
  const double distance = std::max(way.norm(), 1.);
  return {flag.distance - distance,
          {-way.x() / distance, -way.y() / distance, 0},
          squared(relativeError * flag.distance)};
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

/// The longer a step, the less it is known: errors of steps that follow each other are alike over
/// some way, which makes their variances larger than those of each step.
void KalmanSelfLocator::move(const OdometryData& odometry, Time now) {
  constexpr double likeWay = 150, likeTurn = 0.5;  // mm, rad
  if (!started_) lastOdometry_ = odometry;
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

void KalmanSelfLocator::observeLandmarks(const LandmarksPercept& percept,
                                         const FieldDimensions& field, TeamColor team) {
  const Bearings bearings = bearingsIn(percept, team, field);
  if (bearings.count == 0) return;
  const Parameters& p = parameters;
  const Vector2d offset = percept.cameraOffset.head<2>();
  addMirrored();
  view_.add(bearings, offset);
  // What errs alike does not become better known by being measured often.
  const double ofCamera = squared(p.commonAngle) * bearings.count + squared(p.bearingError);
  // A landmark that stands beside its place is seen beside its bearing, the more the nearer it is.
  const auto variance = [&](const Bearing& bearing, const Pose2D& pose) {
    constexpr double nearest = 300;
    const double distance = (bearing.landmark - pose.translation).norm();
    const double error = bearing.radius == 0 ? p.postError : p.flagError;
    return ofCamera + squared(error / std::max(distance, nearest));
  };
  for (Hypothesis& h : hypotheses_) {
    double sum = 0;
    for (const Bearing& bearing : bearings) {
      const Pose2D& pose = h.filter.pose();
      sum += std::log(
          p.landmarkSurprise +
          h.filter.correct(measurementOf(bearing, offset, pose, variance(bearing, pose)), p.gate));
    }
    for (int i = 0; i < percept.numberOfFlags; ++i) {
      const FlagPercept& flag = percept.flags[static_cast<std::size_t>(i)];
      if (flag.distance > 0)
        h.filter.correct(distanceOf(flag, positionOf(flag.type, team, field), h.filter.pose(),
                                    p.flagDistanceError),
                         p.gate);
    }
    judge(h, sum, bearings.count, 1.5);
  }
}

void KalmanSelfLocator::observeEdges(const Vector3d& camera) {
  const std::vector<ChosenPoint>& points = edges_.chosen();
  if (points.empty()) return;
  const Parameters& p = parameters;
  const auto count = static_cast<double>(points.size());
  const double pan = squared(p.commonAngle) * count + squared(p.pointError);
  const double tilt = squared(p.tiltError) * count + squared(p.pointError);
  for (Hypothesis& h : hypotheses_) {
    double sum = 0;
    for (const ChosenPoint& chosen : points) {
      const Pose2D& pose = h.filter.pose();
      const Vector2d place = pose * chosen.point;
      const EdgeTables::Edge& edge = edges_.tables().nearest(
          chosen.type, static_cast<float>(place.x()), static_cast<float>(place.y()));
      const Vector2d normal{edge.normal.x, edge.normal.y};
      const Vector2d view = chosen.point - camera.head<2>();
      const double distance = std::max(view.norm(), 1.);
      // An error of the tilt lengthens the view, one of the pan turns it.
      const double along = rotated(view, pose.rotation).dot(normal) / distance;
      const double lengthening =
          (squared(distance) + squared(camera.z())) / std::max(camera.z(), 50.);
      const double variance = squared(along * lengthening) * tilt +
                              (1 - squared(along)) * squared(distance) * pan + squared(p.edgeError);
      const Vector2d lever = place - pose.translation;
      sum += std::log(
          p.surprise +
          h.filter.correct({normal.dot(Vector2d{edge.point.x, edge.point.y} - place),
                            {normal.x(), normal.y(), normal.dot(Vector2d{-lever.y(), lever.x()})},
                            variance},
                           p.gate));
    }
    judge(h, sum, static_cast<int>(points.size()), 1);
  }
}

/// The more of an image fits, the better the hypothesis; many measurements count as a few, since
/// they are not independent.
void KalmanSelfLocator::judge(Hypothesis& hypothesis, double likelihoods, int count,
                              double importance) const {
  constexpr double follow = 0.15;
  const double average = likelihoods / count;
  hypothesis.weight += importance * average * std::min(std::sqrt(count), 3.);
  hypothesis.surprises = std::exp(average) < badFit ? hypothesis.surprises + 1 : 0;
  hypothesis.fit += follow * (std::min(std::exp(average), 1.) - hypothesis.fit);
}

void KalmanSelfLocator::addFromLandmarks(Random& random) {
  constexpr int most = 3;
  for (int i = 0; i < most; ++i)
    if (const auto pose = templates_.take(random)) add(*pose, parameters.newWeight);
}

/// Whether what fitted up to now does not fit any more: the robot was put somewhere else.
bool KalmanSelfLocator::isElsewhere() const {
  return !hypotheses_.empty() && hypotheses_.front().fit > badFit &&
         hypotheses_.front().surprises >= 2;
}

/// Where one thing could have been seen from is nearly everywhere: of many such poses the one is
/// taken that fits best to all that was seen of late, and only while nothing else fits. If the best
/// hypothesis fits badly, the pose need not prove itself: it begins as far before or behind it as
/// it agrees better or worse with what was seen.
void KalmanSelfLocator::addFromView(const FieldDimensions& field, Random& random) {
  constexpr double goodFit = 0.5, lostFit = 0.4;
  constexpr int tried = 60;
  if (!hypotheses_.empty() && hypotheses_.front().fit > goodFit && random.chance(0.9)) return;
  std::optional<Pose2D> best;
  double most = 0.5;
  for (int i = 0; i < tried; ++i) {
    const auto pose = view_.drawPose(edges_.tables(), field, random);
    if (!pose || std::abs(pose->translation.x()) > field.xGroundline ||
        std::abs(pose->translation.y()) > field.ySideline)
      continue;
    const double fits = view_.score(*pose, edges_.tables());
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

/// The field looks the same from the other side but for its landmarks: before these are looked at,
/// the mirror image of the best hypothesis becomes one, too.
void KalmanSelfLocator::addMirrored() {
  if (hypotheses_.empty()) return;
  Hypothesis mirrored = hypotheses_.front();
  mirrored.filter.mirror();
  mirrored.weight -= parameters.newWeight;
  add(mirrored);
}

/// Adds a pose as a hypothesis behind the best one.
void KalmanSelfLocator::add(const Pose2D& pose, double behind) {
  double best = hypotheses_.empty() ? behind : -1e9;
  for (const Hypothesis& h : hypotheses_) best = std::max(best, h.weight);
  add({{pose, newStandardDeviation, newAngleStandardDeviation}, best - behind, 0.3});
}

/// Adds a hypothesis unless there is one like it; the worst makes room.
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

/// The best one first; those that have become like a better one, or hopeless, go.
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
      const Matrix3d& c = h.filter.covariance();
      const double mean = (c(0, 0) + c(1, 1)) / 2, half = (c(0, 0) - c(1, 1)) / 2;
      const double root = std::hypot(half, c(0, 1));
      canvas.ellipse(h.filter.pose().translation, std::sqrt(mean + root),
                     std::sqrt(std::max(mean - root, 0.)), std::atan2(c(0, 1), half) / 2, color);
    }
  if (auto canvas = debug.onField(drawPose)) canvas.pose(robotPose.pose, colors::red);
}

}  // namespace gt
