#include "observer/MessageQueues.h"

namespace gt {

std::vector<ObservedRobot*> robotsOf(QueueName queue, const std::vector<ObservedRobot*>& robots) {
  using enum QueueName;
  const bool all = queue == toAllPhysicalRobots || queue == toAllSimulatedRobots;
  const auto joins = [queue](RobotKind kind) {
    const bool physical =
        queue == toPhysicalRobot || queue == toAllPhysicalRobots || queue == fromPhysicalRobot;
    return queue == toGUI || physical == (kind == RobotKind::physical);
  };
  std::vector<ObservedRobot*> ends;
  for (const RobotKind kind : {RobotKind::physical, RobotKind::simulated}) {
    if (!joins(kind)) continue;
    bool connected = false;
    for (ObservedRobot* robot : robots) {
      if (robot->kind() != kind || (connected && !all)) continue;
      ends.push_back(robot);
      connected = true;
    }
  }
  return ends;
}

}  // namespace gt
