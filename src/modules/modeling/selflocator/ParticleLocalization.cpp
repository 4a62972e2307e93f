#include "modules/modeling/selflocator/ParticleLocalization.h"

#include "modules/modeling/selflocator/ParticleDrawing.h"

namespace gt {

void ParticleLocalization::update(const Models& models, const Percepts& percepts,
                                  const OdometryData& odometry, const FieldDimensions& field,
                                  const Player& player, const RobotPose* candidate,
                                  RobotPose& robotPose, Random& random, Debug& debug) {
  if (particles_.size() == 0) lastOdometry_ = odometry;
  if (models.edges) edges_.prepare(field, player.teamColor);
  particles_.resize(static_cast<std::size_t>(models.particles), field, models.newProbability,
                    random);
  const Pose2D step = odometry.pose.relativeTo(lastOdometry_.pose);
  lastOdometry_ = odometry;
  particles_.move(step, models.motion, search_, field, random);
  templates_.move(step);

  const bool landmarksSeen =
      models.landmarks && observe(*models.landmarks, *percepts.landmarks, field, player.teamColor);
  const bool edgesSeen =
      models.edges && observe(*models.edges, *percepts.lines, *percepts.camera, odometry, random);
  search_ = landmarksSeen || edgesSeen;
  if (search_) {
    particles_.multiplyLikelihoods();
    particles_.resample(random);
    if (landmarksSeen)
      replaceByTemplates(*models.templates, templates_, candidate, field, particles_, random);
    if (edgesSeen) edges_.replaceImprobable(*models.edges, particles_, random);
  }
  const Cluster cluster = particles_.largestCluster(field);
  robotPose.pose = cluster.pose;
  robotPose.validity = cluster.validity;
  draw(particles_, robotPose, debug);
  if (models.edges) draw(edges_, field, robotPose.pose, debug);
}

bool ParticleLocalization::observe(const LandmarkModel::Parameters& parameters,
                                   const LandmarksPercept& percept, const FieldDimensions& field,
                                   TeamColor team) {
  if (percept.time == lastLandmarks_) return false;
  lastLandmarks_ = percept.time;
  const Bearings bearings = bearingsIn(percept, team, field);
  if (bearings.count == 0) return false;
  landmarks_.observe(parameters, bearings, percept.cameraOffset.head<2>(), particles_);
  templates_.update(percept, team, field);
  return true;
}

bool ParticleLocalization::observe(const EdgeModel::Parameters& parameters,
                                   const LinesPercept& percept, const CameraMatrix& camera,
                                   const OdometryData& odometry, Random& random) {
  if (percept.time == lastLines_) return false;
  lastLines_ = percept.time;
  const double speed = speed_(odometry, percept.time);
  edges_.choose(percept, parameters.points, parameters.farthest, random);
  if (edges_.chosen().empty()) return false;
  edges_.observe(parameters, camera.pose.translation, speed, particles_);
  return true;
}

}  // namespace gt
