#include "modules/modeling/selflocator/GT2003SelfLocator.h"

#include "modules/modeling/selflocator/SampleDrawing.h"

namespace gt {

void GT2003SelfLocator::update(const LandmarksPercept& landmarks, const LinesPercept& lines,
                               const CameraMatrix& camera, const OdometryData& odometry,
                               const FieldDimensions& field, const Player& player,
                               RobotPose& robotPose, Random& random, Debug& debug) {
  locate(landmarks, lines, camera, odometry, field, player, nullptr, robotPose, random, debug);
}

void GT2003SelfLocator::locate(const LandmarksPercept& landmarks, const LinesPercept& lines,
                               const CameraMatrix& camera, const OdometryData& odometry,
                               const FieldDimensions& field, const Player& player,
                               const RobotPose* candidate, RobotPose& robotPose, Random& random,
                               Debug& debug) {
  if (samples_.size() == 0) lastOdometry_ = odometry;
  edges_.prepare(field, player.teamColor);
  samples_.resize(static_cast<std::size_t>(parameters.samples), field,
                  parameters.templates.newProbability, random);
  const Pose2D step = odometry.pose.relativeTo(lastOdometry_.pose);
  lastOdometry_ = odometry;
  samples_.move(step, parameters.motion, search_, field, random);
  search_ = false;
  templates_.move(step);

  const bool landmarksSeen = observeLandmarks(landmarks, field, player.teamColor);
  const bool edgesSeen = observeEdges(lines, camera, odometry, random);
  if (landmarksSeen || edgesSeen) {
    samples_.multiplyEvidence();
    samples_.resample(random);
    if (landmarksSeen)
      replaceByTemplates(parameters.templates, templates_, candidate, field, samples_, random);
    if (edgesSeen) edges_.replaceImprobable(parameters.edges, samples_, random);
    search_ = true;
  }
  const Cluster cluster = samples_.largestCluster(field);
  robotPose.pose = cluster.pose;
  robotPose.validity = cluster.validity;
  draw(samples_, robotPose, debug);
  draw(edges_, field, robotPose.pose, debug);
}

bool GT2003SelfLocator::observeLandmarks(const LandmarksPercept& percept,
                                         const FieldDimensions& field, TeamColor team) {
  if (percept.time == lastLandmarks_) return false;
  lastLandmarks_ = percept.time;
  const Bearings bearings = bearingsIn(percept, team, field);
  if (bearings.count == 0) return false;
  landmarks_.observe(parameters.landmarks, bearings, percept.cameraOffset.head<2>(), samples_);
  templates_.update(percept, team, field);
  return true;
}

bool GT2003SelfLocator::observeEdges(const LinesPercept& percept, const CameraMatrix& camera,
                                     const OdometryData& odometry, Random& random) {
  if (percept.time == lastLines_) return false;
  lastLines_ = percept.time;
  const double speed = speed_(odometry, percept.time);
  edges_.choose(percept, parameters.edges.points, parameters.edges.farthest, random);
  if (edges_.chosen().empty()) return false;
  edges_.observe(parameters.edges, camera.pose.translation, speed, samples_);
  return true;
}

}  // namespace gt
