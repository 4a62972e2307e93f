#include "modules/modeling/MonteCarloSelfLocator.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

const DebugKey drawSamples{"SelfLocator/samples"};
const DebugKey drawPose{"SelfLocator/pose"};

}  // namespace

void MonteCarloSelfLocator::update(const LandmarksPercept& percept, const OdometryData& odometry,
                                   const FieldDimensions& field, const Player& player,
                                   RobotPose& robotPose, Random& random, Debug& debug) {
  locate(percept, odometry, field, player, nullptr, robotPose, random, debug);
}

void MonteCarloSelfLocator::locate(const LandmarksPercept& percept, const OdometryData& odometry,
                                   const FieldDimensions& field, const Player& player,
                                   const RobotPose* candidate, RobotPose& robotPose, Random& random,
                                   Debug& debug) {
  const auto wanted = static_cast<std::size_t>(std::max(parameters.samples, 1));
  if (samples_.empty()) lastOdometry_ = odometry;
  while (samples_.size() < wanted)
    samples_.push_back(Sample::at(randomPose(field, random), parameters.newProbability));
  samples_.resize(wanted);

  const Pose2D step = odometry.pose.relativeTo(lastOdometry_.pose);
  lastOdometry_ = odometry;
  moveSamples(step, field, random);
  templates_.move(step);

  if (percept.time != lastPicture_) {
    lastPicture_ = percept.time;
    const Bearings bearings = bearingsIn(percept, player.teamColor, field);
    if (bearings.count > 0) {
      observe(bearings, percept.cameraOffset.head<2>());
      templates_.update(percept, player.teamColor, field);
      resample(samples_, buffer_, random);
      replaceSamples(field, candidate, random);
      search_ = true;
    }
  }
  const Cluster cluster = largestCluster(samples_, field);
  robotPose.pose = cluster.pose;
  robotPose.validity = cluster.validity;
  draw(robotPose, debug);
}

void MonteCarloSelfLocator::moveSamples(const Pose2D& step, const FieldDimensions& field,
                                        Random& random) {
  const Parameters& p = parameters;
  const double distance = step.translation.norm();
  const double errorX = p.forwardError * distance, errorY = p.sidewardError * distance;
  const double errorAngle =
      p.turnErrorByDistance * distance + p.turnErrorByAngle * std::abs(step.rotation);
  for (Sample& sample : samples_) {
    const double dx = errorX * random.symmetric(), dy = errorY * random.symmetric();
    sample.position = sample * (step.translation + Vector2d{dx, dy});
    double angle = step.rotation + errorAngle * random.symmetric();
    if (search_) {  // (3.14)
      const double far = p.searchDistance * (1 - sample.probability);
      sample.position.x() += far * random.symmetric();
      sample.position.y() += far * random.symmetric();
      angle += p.searchAngle * (1 - sample.probability) * random.symmetric();
    }
    sample.turn(angle);
    // Walls stop samples as they stop robots.
    sample.position.x() = std::clamp(sample.position.x(), -field.xGoalBack, field.xGoalBack);
    sample.position.y() = std::clamp(sample.position.y(), -field.ySideline, field.ySideline);
  }
  search_ = false;
}

void MonteCarloSelfLocator::observe(const Bearings& bearings, const Vector2d& cameraOffset) {
  const double factor = -parameters.steepness / (pi * pi);
  for (Sample& sample : samples_) {
    const Vector2d camera = sample * cameraOffset;
    double sum = 0;  // The product (3.12) of exponentials is the exponential of a sum.
    for (const Bearing& bearing : bearings) {
      const double d = deviation(bearing, camera, sample.heading);
      sum += d * d;
    }
    const double old = sample.probability;
    sample.probability =
        std::clamp(std::exp(factor * sum), old - parameters.fall, old + parameters.rise);
  }
}

void MonteCarloSelfLocator::replaceSamples(const FieldDimensions& field, const RobotPose* candidate,
                                           Random& random) {
  for (Sample& sample : samples_) {
    if (!random.chance(parameters.replacement * (1 - sample.probability))) continue;
    if (candidate && random.chance(candidate->validity))
      sample = Sample::at(candidate->pose, parameters.newProbability);
    else if (const auto pose = templates_.take(random))
      sample = Sample::at(*pose, parameters.newProbability);
    else if (random.chance(parameters.randomReplacement))
      sample = Sample::at(randomPose(field, random), parameters.newProbability);
  }
}

void MonteCarloSelfLocator::draw(const RobotPose& robotPose, Debug& debug) const {
  if (auto canvas = debug.onField(drawSamples))
    for (const Sample& sample : samples_)
      canvas.line(sample.position, sample * Vector2d{60, 0}, colors::gray);
  if (auto canvas = debug.onField(drawPose)) canvas.pose(robotPose.pose, colors::red);
}

}  // namespace gt
