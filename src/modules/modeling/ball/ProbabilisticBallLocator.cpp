#include "modules/modeling/ball/ProbabilisticBallLocator.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "modules/modeling/ball/BallDrawing.h"

namespace gt {
namespace {

const DebugKey drawHypotheses{"BallLocator/hypotheses"};

}  // namespace

void ProbabilisticBallLocator::update(const BallPercept& percept, const CameraMatrix& camera,
                                      const OdometryData& odometry, const FrameInfo& frame,
                                      BallModel& model, Debug& debug) {
  const bool first = lastUpdate_ == never();
  const double seconds = first ? 0 : static_cast<double>(frame.time - lastUpdate_) / 1000;
  predict(first ? Pose2D{} : odometry.pose.relativeTo(lastOdometry_.pose), seconds);
  lastOdometry_ = odometry;
  lastUpdate_ = frame.time;
  if (percept.time != lastPicture_) {
    if (percept.seen)
      observe(percept, seconds);
    else
      miss(camera);
    tidy();
  }
  lastPicture_ = percept.time;

  model = {};
  if (count_ == 0) return;
  const Hypothesis& ball = best();
  model = BallEstimate{ball.position(), ball.state.tail<2>(), ball.lastSeen, ball.seenSince}.model(
      frame.time, parameters.longestGap);
  model.standardDeviation = std::sqrt(ball.covariance.topLeftCorner<2, 2>().trace() / 2);
  draw(model, debug);
  if (auto canvas = debug.onRobot(drawHypotheses))
    for (int i = 0; i < count_; ++i) {
      const Hypothesis& h = hypotheses_[static_cast<std::size_t>(i)];
      const double standardDeviation = std::sqrt(h.covariance.topLeftCorner<2, 2>().trace() / 2);
      canvas.circle(h.position(), standardDeviation, colors::orange, 1 + 2 * h.weight);
    }
}

// Errors of the odometry move the ball, the more the farther away it is.
void ProbabilisticBallLocator::predict(const Pose2D& step, double seconds) {
  const double c = std::cos(step.rotation), s = std::sin(step.rotation);
  Eigen::Matrix2d turn;
  turn << c, s, -s, c;
  const double walked = parameters.stepNoise * step.translation.norm();
  const double turned = parameters.turnNoise * std::abs(step.rotation);
  const RollingBall rolling{parameters.deceleration};
  for (int i = 0; i < count_; ++i) {
    Hypothesis& h = hypotheses_[static_cast<std::size_t>(i)];
    RollingBall::Derivative transition = rolling.derivative(seconds, h.state);
    const State rolled = rolling.after(seconds, h.state);
    if (meetsBody(h.position(), rolled.head<2>()))
      h.state.tail<2>().setZero();
    else
      h.state = rolled;
    h.state.head<2>() = turn * (h.position() - step.translation);
    h.state.tail<2>() = turn * h.state.tail<2>();
    transition.topRows<2>() = (turn * transition.topRows<2>()).eval();
    transition.bottomRows<2>() = (turn * transition.bottomRows<2>()).eval();
    h.covariance = transition * h.covariance * transition.transpose();
    const double drift = walked + turned * h.position().norm();
    h.covariance.diagonal().head<2>().array() += drift * drift;
    // However long a ball is not seen: it rolls no faster than a ball that was just kicked.
    if (h.covariance.diagonal().tail<2>().maxCoeff() < parameters.newSpeed * parameters.newSpeed)
      h.covariance.diagonal().tail<2>().array() += parameters.push * parameters.push * seconds;
  }
}

Eigen::Matrix2d ProbabilisticBallLocator::noiseOf(const Vector2d& seen) const {
  const double distance = std::max(seen.norm(), 1.);
  const double across = parameters.acrossNoise + parameters.acrossShare * distance;
  const double along = parameters.alongNoise + parameters.alongShare * distance +
                       parameters.alongTilt * distance * distance;
  const Vector2d away = seen / distance;
  return across * across * Eigen::Matrix2d::Identity() +
         (along * along - across * across) * away * away.transpose();
}

// A kick changes the speed, but not the position: adds a copy of the best hypothesis with unknown
// speed.
void ProbabilisticBallLocator::addKicked(double seconds) {
  if (count_ == 0 || parameters.kicked <= 0) return;
  const double variance = parameters.newSpeed * parameters.newSpeed;
  Hypothesis& kicked = hypotheses_[static_cast<std::size_t>(count_++)];
  kicked = best();
  kicked.weight *= parameters.kicked;
  for (int k = 0; k < 2; ++k) {
    kicked.covariance(k, k) += variance * seconds * seconds;
    kicked.covariance(k, k + 2) += variance * seconds;
    kicked.covariance(k + 2, k) += variance * seconds;
    kicked.covariance(k + 2, k + 2) += variance;
  }
}

// The weight of a hypothesis is multiplied by the likelihood of the percept. A wrong percept, which
// carries no information, is one explanation; that the ball was moved to the percept is another.
void ProbabilisticBallLocator::observe(const BallPercept& percept, double seconds) {
  if (count_ > 0 && percept.time - best().lastSeen > parameters.forgetAfter) count_ = 0;
  addKicked(seconds);
  const Eigen::Matrix2d noise = noiseOf(percept.offset);
  for (int i = 0; i < count_; ++i) {
    Hypothesis& h = hypotheses_[static_cast<std::size_t>(i)];
    Hypothesis corrected = h;
    const double likelihood = correct(corrected, percept.offset, noise);
    if (likelihood > parameters.falseDensity) {
      if (percept.time - h.lastSeen > parameters.longestGap) corrected.seenSince = percept.time;
      corrected.lastSeen = percept.time;
      h = corrected;
    }
    h.weight *= likelihood + parameters.falseDensity;
  }
  Hypothesis& fresh = hypotheses_[static_cast<std::size_t>(count_++)];
  fresh = {};
  fresh.state.head<2>() = percept.offset;
  fresh.covariance.topLeftCorner<2, 2>() = noise;
  fresh.covariance.diagonal().tail<2>().setConstant(parameters.newSpeed * parameters.newSpeed);
  fresh.weight = parameters.newDensity;
  fresh.lastSeen = fresh.seenSince = percept.time;
}

/// Corrects a hypothesis by a percept. Returns the probability density of the percept, in 1/mm^2.
double ProbabilisticBallLocator::correct(Hypothesis& h, const Vector2d& seen,
                                         const Eigen::Matrix2d& noise) const {
  const Eigen::Matrix2d spread = h.covariance.topLeftCorner<2, 2>() + noise;
  const Eigen::Matrix2d inverse = spread.inverse();
  const Vector2d innovation = seen - h.position();
  const Eigen::Matrix<double, 4, 2> gain = h.covariance.leftCols<2>() * inverse;
  const Eigen::Matrix<double, 2, 4> rows = h.covariance.topRows<2>();
  h.state += gain * innovation;
  h.covariance -= gain * rows;
  h.covariance = (h.covariance + h.covariance.transpose()).eval() / 2;
  return std::exp(-0.5 * innovation.dot(inverse * innovation)) /
         (2 * pi * std::sqrt(spread.determinant()));
}

// A near ball in the middle of the image is rarely overlooked. If it is not seen, it is probably
// elsewhere or hidden.
void ProbabilisticBallLocator::miss(const CameraMatrix& camera) {
  if (!camera.valid) return;
  constexpr double ballHeight = 43, border = 15;  // mm, pixels
  const Matrix3d toCamera = camera.pose.rotation.transpose();
  for (int i = 0; i < count_; ++i) {
    Hypothesis& h = hypotheses_[static_cast<std::size_t>(i)];
    const Vector3d place{h.state.x(), h.state.y(), ballHeight};
    const Vector3d seen = toCamera * (place - camera.pose.translation);
    if (seen.x() < 1 || h.position().norm() > parameters.missedRange) continue;
    const Vector2d pixel = camera.info.project(seen);
    if (pixel.x() > border && pixel.y() > border && pixel.x() < camera.info.width - border &&
        pixel.y() < camera.info.height - border)
      h.weight *= parameters.missed;
  }
}

// Removes the less probable of two similar hypotheses, and very improbable ones.
void ProbabilisticBallLocator::tidy() {
  const auto begin = hypotheses_.begin();
  std::sort(begin, begin + count_,
            [](const Hypothesis& a, const Hypothesis& b) { return a.weight > b.weight; });
  // One that could be anywhere does not swallow one that knows its place.
  const auto isSame = [](const Hypothesis& a, const Hypothesis& b) {
    const Hypothesis& surer =
        a.covariance(0, 0) + a.covariance(1, 1) < b.covariance(0, 0) + b.covariance(1, 1) ? a : b;
    const Eigen::Matrix2d place = surer.covariance.topLeftCorner<2, 2>();
    const Eigen::Matrix2d speeds = (a.covariance + b.covariance).bottomRightCorner<2, 2>();
    const Vector2d apart = a.position() - b.position();
    const Vector2d faster = a.state.tail<2>() - b.state.tail<2>();
    return apart.dot(place.inverse() * apart) < 1 && faster.dot(speeds.inverse() * faster) < 1;
  };
  constexpr double least = 1e-6;
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    const Hypothesis h = hypotheses_[static_cast<std::size_t>(i)];
    const auto same = std::find_if(begin, begin + kept,
                                   [&](const Hypothesis& other) { return isSame(h, other); });
    if (same != begin + kept)
      same->weight += h.weight;
    else if (kept < mostHypotheses && (kept == 0 || h.weight > least * best().weight))
      hypotheses_[static_cast<std::size_t>(kept++)] = h;
  }
  count_ = kept;
  double sum = 0;
  if (count_ > 0 && best().weight < 1e-300) count_ = 0;
  for (int i = 0; i < count_; ++i) sum += hypotheses_[static_cast<std::size_t>(i)].weight;
  for (int i = 0; i < count_; ++i) hypotheses_[static_cast<std::size_t>(i)].weight /= sum;
}

}  // namespace gt
