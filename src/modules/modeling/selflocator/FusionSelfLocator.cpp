#include "modules/modeling/selflocator/FusionSelfLocator.h"

namespace gt {

void FusionSelfLocator::update(const LandmarksPercept& percept, const OdometryData& odometry,
                               const FieldDimensions& field, const Player& player,
                               RobotPose& robotPose, Random& random, Debug& debug) {
  monteCarlo_.parameters = parameters.monteCarlo;
  singleLandmark_.parameters = parameters.singleLandmark;
  singleLandmark_.update(percept, odometry, field, player, candidate_, debug);
  monteCarlo_.locate(percept, odometry, field, player, &candidate_, robotPose, random, debug);
}

}  // namespace gt
