#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/ParticleDrawing.h"

namespace gt {
namespace {

/// The share of a correction that is applied: all of it if nothing is known yet, and less the more
/// reliable the estimate is compared with the measurement.
double correctionFactor(double quality, double reliability) {
  return quality / (quality + reliability);
}

/// The reliability after a correction. It approaches the quality of measurements that agree with
/// the estimate, and decreases while measurements contradict it.
double reliabilityAfter(double reliability, double factor, double quality, double difference) {
  return reliability + factor * (quality * std::max(1 - difference, 0.0) - reliability);
}

}  // namespace

void SingleLandmarkSelfLocator::update(const LandmarksPercept& percept,
                                       const OdometryData& odometry, const FieldDimensions& field,
                                       const Player& player, RobotPose& robotPose, Debug& debug) {
  if (!started_) lastOdometry_ = odometry;
  started_ = true;
  move(odometry, percept.time);
  if (percept.time != lastPicture_) {
    lastPicture_ = percept.time;
    useBestFlags(percept, player.teamColor, field);
    useGoals(percept, player.teamColor, field);
    Vector2d& position = pose_.translation;
    position.x() = std::clamp(position.x(), -field.xGoalBack, field.xGoalBack);
    position.y() = std::clamp(position.y(), -field.ySideline, field.ySideline);
  }
  robotPose.pose = pose_;
  robotPose.validity = positionReliability_ * orientationReliability_;
  drawPose(pose_, debug);
}

/// The estimate becomes less reliable with time, and more so by walking.
void SingleLandmarkSelfLocator::move(const OdometryData& odometry, Time now) {
  const Pose2D step = odometry.pose.relativeTo(lastOdometry_.pose);
  lastOdometry_ = odometry;
  pose_ = pose_ * step;
  const Parameters& p = parameters;
  const double seconds = lastPicture_ == never()
                             ? 0
                             : std::clamp(static_cast<double>(now - lastPicture_), 0.0, 1e6) / 1000;
  const double distance = step.translation.norm();
  const double byTime = p.lossByTime * seconds;
  positionReliability_ *= std::max(1 - byTime - p.lossByDistance * distance, 0.0);
  orientationReliability_ *= std::max(1 - byTime - p.lossByAngle * std::abs(step.rotation), 0.0);
}

SingleLandmarkSelfLocator::Measurement SingleLandmarkSelfLocator::flagIn(
    const FlagPercept& flag, TeamColor team, const FieldDimensions& field) const {
  const bool whole = !flag.boundary.leftOnBorder && !flag.boundary.rightOnBorder;
  Measurement m{positionOf(flag.type, team, field), flag.distance, 0, flag.angle,
                whole ? parameters.flagAngleQuality : parameters.flagAngleQuality / 2};
  const double far = flag.distance / parameters.distanceRange;
  if (whole && flag.distance > 0) m.distanceQuality = 1 / (1 + far * far);
  return m;
}

/// Uses the flags whose distance has the best quality.
void SingleLandmarkSelfLocator::useBestFlags(const LandmarksPercept& percept, TeamColor team,
                                             const FieldDimensions& field) {
  std::array<Measurement, 2> best;
  for (int i = 0; i < percept.numberOfFlags; ++i) {
    const Measurement m = flagIn(percept.flags[static_cast<std::size_t>(i)], team, field);
    const auto worse = [&](const Measurement& other) {
      return m.distanceQuality + m.angleQuality > other.distanceQuality + other.angleQuality;
    };
    if (worse(best[0]))
      best = {m, best[0]};
    else if (worse(best[1]))
      best[1] = m;
  }
  for (const Measurement& m : best) correct(m);
}

/// Goals are used last, because their direction is the most important one (report 3.3.1.1). The
/// middle of a goal that is cut by the image's border is unknown.
void SingleLandmarkSelfLocator::useGoals(const LandmarksPercept& percept, TeamColor team,
                                         const FieldDimensions& field) {
  for (int i = 0; i < percept.numberOfGoals; ++i) {
    const GoalPercept& goal = percept.goals[static_cast<std::size_t>(i)];
    if (goal.boundary.leftOnBorder || goal.boundary.rightOnBorder) continue;
    const double side = goal.color == ownGoal(team) ? -1 : 1;
    correct({{side * field.xGroundline, 0},
             goal.distance,
             goal.distance > 0 ? parameters.goalDistanceQuality : 0,
             goal.angle,
             parameters.goalAngleQuality});
  }
}

void SingleLandmarkSelfLocator::correct(const Measurement& measurement) {
  if (measurement.distanceQuality + measurement.angleQuality < parameters.minimumQuality) return;
  if (measurement.distanceQuality > 0) correctPosition(measurement);
  if (measurement.angleQuality > 0) correctOrientation(measurement);
}

/// Moves the position towards the virtual position, which is on the line from the landmark to the
/// old position, at the measured distance (report, figure 3.5a).
void SingleLandmarkSelfLocator::correctPosition(const Measurement& measurement) {
  const Vector2d fromLandmark = pose_.translation - measurement.landmark;
  const double distance = fromLandmark.norm();
  if (distance < 1) return;
  const Vector2d correction = fromLandmark * (measurement.distance / distance - 1);
  const double quality = measurement.distanceQuality;
  const double factor =
      parameters.progressiveness * correctionFactor(quality, positionReliability_);
  pose_.translation += factor * correction;
  positionReliability_ = reliabilityAfter(positionReliability_, factor, quality,
                                          correction.norm() / parameters.positionTolerance);
}

/// Turns towards the orientation in which the landmark has the measured angle (report, figure
/// 3.5b).
void SingleLandmarkSelfLocator::correctOrientation(const Measurement& measurement) {
  const Vector2d toLandmark = measurement.landmark - pose_.translation;
  const double correction = normalize(angleOf(toLandmark) - measurement.angle - pose_.rotation);
  const double quality = measurement.angleQuality;
  const double factor =
      parameters.progressiveness * correctionFactor(quality, orientationReliability_);
  pose_.rotation = normalize(pose_.rotation + factor * correction);
  orientationReliability_ = reliabilityAfter(orientationReliability_, factor, quality,
                                             std::abs(correction) / parameters.angleTolerance);
}

}  // namespace gt
