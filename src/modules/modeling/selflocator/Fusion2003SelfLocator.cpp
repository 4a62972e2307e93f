#include "modules/modeling/selflocator/Fusion2003SelfLocator.h"

namespace gt {

void Fusion2003SelfLocator::update(const LandmarksPercept& landmarks, const LinesPercept& lines,
                                   const CameraMatrix& camera, const OdometryData& odometry,
                                   const FieldDimensions& field, const Player& player,
                                   RobotPose& robotPose, Random& random, Debug& debug) {
  gt2003_.parameters = parameters.gt2003;
  singleLandmark_.parameters = parameters.singleLandmark;
  singleLandmark_.update(landmarks, odometry, field, player, candidate_, debug);
  gt2003_.locate(landmarks, lines, camera, odometry, field, player, &candidate_, robotPose, random,
                 debug);
}

}  // namespace gt
