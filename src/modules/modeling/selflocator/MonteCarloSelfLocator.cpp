#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"

#include "modules/modeling/selflocator/SampleDrawing.h"

namespace gt {

void MonteCarloSelfLocator::update(const LandmarksPercept& percept, const OdometryData& odometry,
                                   const FieldDimensions& field, const Player& player,
                                   RobotPose& robotPose, Random& random, Debug& debug) {
  locate(percept, odometry, field, player, nullptr, robotPose, random, debug);
}

void MonteCarloSelfLocator::locate(const LandmarksPercept& percept, const OdometryData& odometry,
                                   const FieldDimensions& field, const Player& player,
                                   const RobotPose* candidate, RobotPose& robotPose, Random& random,
                                   Debug& debug) {
  if (samples_.size() == 0) lastOdometry_ = odometry;
  samples_.resize(static_cast<std::size_t>(parameters.samples), field,
                  parameters.templates.newProbability, random);
  const Pose2D step = odometry.pose.relativeTo(lastOdometry_.pose);
  lastOdometry_ = odometry;
  samples_.move(step, parameters.motion, search_, field, random);
  search_ = false;
  templates_.move(step);

  if (percept.time != lastPicture_) {
    lastPicture_ = percept.time;
    const Bearings bearings = bearingsIn(percept, player.teamColor, field);
    if (bearings.count > 0) {
      landmarks_.observe(parameters.landmarks, bearings, percept.cameraOffset.head<2>(), samples_);
      samples_.multiplyEvidence();
      templates_.update(percept, player.teamColor, field);
      samples_.resample(random);
      replaceByTemplates(parameters.templates, templates_, candidate, field, samples_, random);
      search_ = true;
    }
  }
  const Cluster cluster = samples_.largestCluster(field);
  robotPose.pose = cluster.pose;
  robotPose.validity = cluster.validity;
  draw(samples_, robotPose, debug);
}

}  // namespace gt
