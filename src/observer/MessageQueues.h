#pragma once
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// The main message queues between tools and robots (report 5.2, figure 5.3). A tool is connected
/// to one robot of each kind at a time: to the first one of a list. Console, log recorder and views
/// name queues when they state which robots they mean.
enum class QueueName {
  toPhysicalRobot,  ///< Messages for the connected one.
  toAllPhysicalRobots,
  toSimulatedRobot,
  toAllSimulatedRobots,
  fromPhysicalRobot,  ///< All that the connected one sends: what a log recorder records.
  fromSimulatedRobot,
  toGUI  ///< What the connected robots of both kinds send: what views show.
};

/// The robots at the other end of a queue, of all those that a tool knows, in their order.
std::vector<ObservedRobot*> robotsOf(QueueName queue, const std::vector<ObservedRobot*>& robots);

/// Whether messages can be put into a queue; the others are filled by robots.
constexpr bool leadsToRobots(QueueName queue) {
  return queue <= QueueName::toAllSimulatedRobots;
}

/// Puts a message into a queue that leads to robots. Returns an error if it leads to none, or the
/// first refusal; the others have it all the same.
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
