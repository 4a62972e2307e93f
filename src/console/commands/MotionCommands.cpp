#include <algorithm>

#include "base/Suggestion.h"
#include "console/Commands.h"
#include "console/Values.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {
namespace {

/// The report's names of kicks that have other names here.
constexpr std::pair<std::string_view, std::string_view> reportActions[] = {
    {"leftHeadKick", "hookLeft"},
    {"rightHeadKick", "hookRight"},
    {"unswBashOptimized", "pushStrong"}};

std::vector<std::string> motionNames(const MotionNet& motions) {
  std::vector<std::string> names{"stand", "getup"};
  for (const auto& type : namesOf<WalkType>()) names.push_back(type);
  for (const auto& [name, kick] : motions.motions)
    if (!name.empty() && name != standAction) names.push_back(name);
  return names;
}

/// The motion request for a motion's name; for a walk, without its speeds.
std::optional<MotionRequest> motionOf(std::string_view name, const MotionNet& motions) {
  for (const auto& [report, here] : reportActions)
    if (report == name) name = here;
  MotionRequest request;
  if (const auto type = enumValue<WalkType>(name)) {
    request.type = MotionType::walk;
    request.walkType = *type;
  } else if (name == "stand" || name == "getup") {
    request.type = *enumValue<MotionType>(name);
  } else if (motions.find(name) > 0) {
    request.type = MotionType::specialAction;
    request.specialAction = name;
  } else {
    return std::nullopt;
  }
  return request;
}

/// Warns if BehaviorControl is enabled, since its requests then replace a person's commands.
void warnIfDecided(Console& console, ConsoleRobot& robot) {
  const auto task = robot.observed().task("BehaviorControl");
  if (!task || (*task)->active == SolutionTable::disabled) return;
  console.print(robot.name() + ": BehaviorControl decides; sr BehaviorControl disabled lets you");
}

Result<void> sendMotion(Console& console, const std::function<void(MotionRequest&)>& change) {
  return console.forEachRobot([&](ConsoleRobot& robot) {
    warnIfDecided(console, robot);
    change(robot.motion);
    return robot.observed().send(robot.motion);
  });
}

Result<void> mr(Console& console, const Words& words) {
  const auto motions = console.motions();
  if (!motions) return motions.error();
  if (words[1] == "?") {
    list(console, motionNames(**motions));
    return {};
  }
  auto request = motionOf(words[1], **motions);
  if (!request)
    return Error{
        .field = words[1],
        .what = "there is no such motion; try mr ?" + suggestion(words[1], motionNames(**motions))};
  const bool walk = request->type == MotionType::walk;
  if (words.size() != (walk ? 5u : 2u)) return wrongArguments(words);
  if (walk) {
    double speeds[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = numberOf(words[2 + i], -1000, 1000);
      if (!number) return number.error();
      speeds[i] = *number;
    }
    request->walk = {fromDegrees(speeds[2]), speeds[0], speeds[1]};
  }
  return sendMotion(console, [&](MotionRequest& motion) {
    const TailRequest tail = motion.tail;
    motion = *request;
    motion.tail = tail;
  });
}

Result<void> tr(Console& console, const Words& words) {
  if (words[1] == "?") {
    list(console, namesOf<TailRequest>());
    return {};
  }
  const auto tail = enumValue<TailRequest>(words[1]);
  if (!tail) return Error{.field = words[1], .what = "there is no such tail request; try tr ?"};
  return sendMotion(console, [&](MotionRequest& motion) { motion.tail = *tail; });
}

Result<void> hcm(Console& console, const Words& words) {
  if (words[1] == "?") {
    list(console, namesOf<HeadMode>());
    return {};
  }
  const auto mode = enumValue<HeadMode>(words[1]);
  if (!mode)
    return Error{.field = words[1],
                 .what = "there is no such head control mode; try hcm ?" +
                         suggestion(words[1], namesOf<HeadMode>())};
  const bool atPoint = *mode == HeadMode::lookAtPoint, scan = *mode == HeadMode::scanLeftRight;
  const std::size_t numbers = words.size() - 2;
  if (atPoint ? numbers != 3 && numbers != 5 : numbers != 0 && !(scan && numbers == 2))
    return wrongArguments(words);
  double values[5];
  for (std::size_t i = 0; i < numbers; ++i) {
    const auto number = numberOf(words[i + 2], -1e5, 1e5);
    if (!number) return number.error();
    values[i] = *number;
  }
  HeadControlMode wanted{*mode};
  if (atPoint) wanted.point = {values[0], values[1], values[2]};
  if (atPoint && numbers == 5) wanted.pixel = {values[3], values[4]};
  if (scan && numbers == 2) {
    wanted.scanTilt = fromDegrees(values[0]);
    wanted.scanRange = fromDegrees(values[1]);
  }
  return console.forEachRobot([&](ConsoleRobot& robot) {
    warnIfDecided(console, robot);
    robot.headMode = *mode;
    return robot.observed().send(wanted);
  });
}

/// Head motion requests are followed in the head control mode none only.
void warnIfHeadIsMoved(Console& console, ConsoleRobot& robot) {
  if (robot.headMode == HeadMode::none) return;
  const auto mode = valueAt(console, robot.name() + ".HeadControlMode.mode");
  if (mode && mode->text != enumName(HeadMode::none))
    console.print(robot.name() + ": the head control mode is " + mode->text +
                  "; hcm none lets you move the head");
}

Result<void> hmr(Console& console, const Words& words) {
  double angles[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const auto degrees = numberOf(words[1 + i], -180, 180);
    if (!degrees) return degrees.error();
    angles[i] = fromDegrees(*degrees);
  }
  return console.forEachRobot([&](ConsoleRobot& robot) {
    warnIfDecided(console, robot);
    warnIfHeadIsMoved(console, robot);
    return robot.observed().send(HeadMotionRequest{angles[0], angles[1], angles[2], angles[3]});
  });
}

std::vector<std::string> motionChoices(Console& console, const Words& before) {
  const auto motions = console.motions();
  return before.size() == 1 && motions ? motionNames(**motions) : std::vector<std::string>{};
}

template <std::vector<std::string> (*names)()>
std::vector<std::string> oneOf(Console&, const Words& before) {
  return before.size() == 1 ? names() : std::vector<std::string>{};
}

}  // namespace

std::vector<Command> motionCommands() {
  constexpr auto kind = Command::Kind::robot;
  return {
      {kind, "hcm", "? | lookAtPoint X Y Z [PIXEL_X PIXEL_Y] | scanLeftRight [TILT RANGE] | MODE",
       "Sets the head control mode, while no BehaviorControl is active. The point to look at is "
       "relative to the robot, in mm, and appears at that pixel, by default in the middle of the "
       "image. A scan keeps the tilt and turns by the range to each side, in degrees.",
       hcm, oneOf<namesOf<HeadMode>>, true},
      {kind, "hmr", "TILT PAN ROLL MOUTH",
       "Sets the head's joints, in degrees; works in the head control mode none.", hmr, nullptr,
       true},
      {kind, "mr", "? | TYPE [X Y R]",
       "Sets the motion, while no BehaviorControl is active. To walk (normal) takes speeds: ahead "
       "and left in mm/s, counterclockwise in degrees/s.",
       mr, motionChoices, true},
      {kind, "tr", "? | TYPE", "Sets what the tail does, while no BehaviorControl is active.", tr,
       oneOf<namesOf<TailRequest>>, true}};
}

}  // namespace gt
