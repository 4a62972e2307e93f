#include "environments/JointSpace.h"

#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

std::vector<Joint> legJoints() {
  std::vector<Joint> joints;
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    for (int number = 1; number <= 3; ++number) joints.push_back(legJoint(leg, number));
  return joints;
}

std::vector<Joint> headAndLegJoints() {
  std::vector<Joint> joints{Joint::headTilt, Joint::headPan, Joint::headRoll};
  for (const Joint joint : legJoints()) joints.push_back(joint);
  return joints;
}

JointAngles standingAngles() {
  InvKinWalkingEngine engine;
  WalkingEngineOutput output;
  engine.update({}, {}, RobotDimensions{}, {}, {MotionInfo{}}, output);
  JointAngles angles = output.joints.angles;
  angles[Joint::mouth] = limitsOf(Joint::mouth).high;
  return angles;
}

JointAngles anglesOf(std::span<const float> actions, std::span<const Joint> joints) {
  static const JointAngles stand = standingAngles();
  JointAngles angles = stand;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointLimits limits = limitsOf(joints[i]);
    const double action = actions[i], middle = stand[joints[i]];
    angles[joints[i]] =
        middle + (action > 0 ? action * (limits.high - middle) : action * (middle - limits.low));
  }
  return angles;
}

void addJoints(Space& actions, std::span<const Joint> joints) {
  for (const Joint joint : joints)
    actions.add(std::string{enumName(joint)}, "", -1, 1,
                "-1 its lower limit, 0 as it stands, 1 its upper limit");
}

void addJoints(Space& observations, std::span<const Joint> joints, const std::string& what,
               const char* unit, double most) {
  for (const Joint joint : joints)
    observations.add(what + "." + std::string{enumName(joint)}, unit, -most, most);
}

}  // namespace gt
