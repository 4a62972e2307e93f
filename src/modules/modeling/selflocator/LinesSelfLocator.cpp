#include "modules/modeling/selflocator/LinesSelfLocator.h"

#include "modules/modeling/selflocator/SampleDrawing.h"

namespace gt {

void LinesSelfLocator::update(const LinesPercept& percept, const CameraMatrix& camera,
                              const OdometryData& odometry, const FieldDimensions& field,
                              const Player& player, RobotPose& robotPose, Random& random,
                              Debug& debug) {
  if (samples_.size() == 0) lastOdometry_ = odometry;
  edges_.prepare(field, player.teamColor);
  samples_.resize(static_cast<std::size_t>(parameters.samples), field, parameters.newEvidence,
                  random);
  samples_.move(odometry.pose.relativeTo(lastOdometry_.pose), parameters.motion, search_, field,
                random);
  lastOdometry_ = odometry;
  search_ = false;

  if (percept.time != lastPicture_) {
    lastPicture_ = percept.time;
    const double speed = speed_(odometry, percept.time);
    edges_.choose(percept, parameters.edges.points, parameters.edges.farthest, random);
    if (!edges_.chosen().empty()) {
      edges_.observe(parameters.edges, camera.pose.translation, speed, samples_);
      samples_.multiplyEvidence();
      samples_.resample(random);
      edges_.replaceImprobable(parameters.edges, samples_, random);
      search_ = true;
    }
  }
  const Cluster cluster = samples_.largestCluster(field);
  robotPose.pose = cluster.pose;
  robotPose.validity = cluster.validity;
  draw(samples_, robotPose, debug);
  draw(edges_, field, robotPose.pose, debug);
}

}  // namespace gt
