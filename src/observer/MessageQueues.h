#pragma once
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// The main message queues between tools and robots (report 5.2, figure 5.3). A tool is connected
/// to one robot of each kind at a time, the first one of a list. Console, log recorder and views
/// use names of queues to state which robots they refer to.
enum class QueueName {
  toPhysicalRobot,  ///< Messages for the connected physical robot.
  toAllPhysicalRobots,
  toSimulatedRobot,
  toAllSimulatedRobots,
  fromPhysicalRobot,  ///< All messages of the connected physical robot, as recorded by a log
                      ///< recorder.
  fromSimulatedRobot,
  toGUI  ///< Messages of the connected robots of both kinds, as shown by views.
};

/// The robots at the other end of a queue, among all robots that a tool knows, in their order.
std::vector<ObservedRobot*> robotsOf(QueueName queue, const std::vector<ObservedRobot*>& robots);

/// Whether messages can be put into a queue; the other queues are filled by robots.
constexpr bool leadsToRobots(QueueName queue) {
  return queue <= QueueName::toAllSimulatedRobots;
}

/// Sends a message by a queue that leads to robots. Returns an error if it leads to none, or the
/// first refusal; the other robots receive the message nevertheless.
template <typename T>
Result<void> send(QueueName queue, const std::vector<ObservedRobot*>& robots, const T& message) {
  const auto ends = leadsToRobots(queue) ? robotsOf(queue, robots) : std::vector<ObservedRobot*>{};
  if (ends.empty())
    return Error{.field = std::string{enumName(queue)}, .what = "this queue leads to no robot"};
  Result<void> done;
  for (ObservedRobot* robot : ends)
    if (auto sent = robot->send(message); !sent && done) done = sent;
  return done;
}

}  // namespace gt
