#include <algorithm>

#include "console/Commands.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {
namespace {

/// The report's names of kicks that have another one here.
constexpr std::pair<std::string_view, std::string_view> reportActions[] = {
    {"leftHeadKick", "headLeft"}, {"rightHeadKick", "headRight"}};

std::vector<std::string> motionNames(const MotionNet& motions) {
  std::vector<std::string> names{"stand", "getup"};
  for (const auto& type : namesOf<WalkType>()) names.push_back(type);
  for (const auto& [name, kick] : motions.motions)
    if (!name.empty() && name != standAction && name != getupAction) names.push_back(name);
  return names;
}

/// What a motion's name asks for; a walk still needs its speeds.
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

/// Commands of a person last while nobody else decides.
void warnIfDecided(Console& console, ConsoleRobot& robot) {
  if (!robot.robot()) return;
  for (const auto& process : robot.robot()->processes()) {
    const std::string active = process->activeSolution("BehaviorControl");
    if (active.empty() || active == SolutionTable::disabled) continue;
    console.print(robot.name() + ": BehaviorControl decides; sr BehaviorControl disabled lets you");
  }
}

Result<void> sendMotion(Console& console, const std::function<void(MotionRequest&)>& change) {
  return console.forEachRobot([&](ConsoleRobot& robot) {
    warnIfDecided(console, robot);
    change(robot.motion);
    return robot.send(robot.motion);
  });
}

Result<void> mr(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  const auto motions = console.motions();
  if (!motions) return motions.error();
  if (words[1] == "?") {
    list(console, motionNames(**motions));
    return {};
  }
  auto request = motionOf(words[1], **motions);
  if (!request) return Error{"", 0, words[1], "there is no such motion; try mr ?"};
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
  if (words.size() != 2) return wrongArguments(words);
  if (words[1] == "?") {
    list(console, namesOf<TailRequest>());
    return {};
  }
  const auto tail = enumValue<TailRequest>(words[1]);
  if (!tail) return Error{"", 0, words[1], "there is no such tail request; try tr ?"};
  return sendMotion(console, [&](MotionRequest& motion) { motion.tail = *tail; });
}

Result<void> hcm(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  if (words[1] == "?") {
    list(console, namesOf<HeadMode>());
    return {};
  }
  const auto mode = enumValue<HeadMode>(words[1]);
  if (!mode) return Error{"", 0, words[1], "there is no such head control mode; try hcm ?"};
  return console.forEachRobot([&](ConsoleRobot& robot) {
    warnIfDecided(console, robot);
    return robot.send(HeadControlMode{*mode, Vector3d::Zero()});
  });
}

Result<void> hmr(Console& console, const Words& words) {
  if (words.size() != 5) return wrongArguments(words);
  double angles[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const auto degrees = numberOf(words[1 + i], -180, 180);
    if (!degrees) return degrees.error();
    angles[i] = fromDegrees(*degrees);
  }
  return console.forEachRobot([&](ConsoleRobot& robot) {
    return robot.send(HeadMotionRequest{angles[0], angles[1], angles[2], angles[3]});
  });
}

/// The report's names of penalties, of the rules of 2003.
constexpr std::pair<std::string_view, Penalty> penalties[] = {
    {"continue", Penalty::none},
    {"illegalDefender", Penalty::illegalDefender},
    {"obstruction", Penalty::obstruction},
    {"keeperCharged", Penalty::keeperCharge},
    {"ballHolding", Penalty::ballHolding},
    {"fieldPlayerCharged", Penalty::fieldPlayerCharge},
    {"illegalDefense", Penalty::illegalDefense},
    {"requestForPickup", Penalty::requestForPickup}};

Result<void> pr(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  const auto known =
      std::ranges::find_if(penalties, [&](const auto& p) { return p.first == words[1]; });
  if (known == std::end(penalties)) return wrongArguments(words);
  const Penalty penalty = known->second;
  Session& session = console.session();
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (robot.index()) {
      session.simulation().referee().setPenalty(*robot.index(), penalty, session.time());
      return {};
    }
    GameControlData data;
    data.state = penalty == Penalty::none ? GameState::playing : GameState::penalized;
    data.penalty = penalty;
    return robot.send(data);
  });
}

std::vector<std::string> motionChoices(Console& console, const Words& before) {
  const auto motions = console.motions();
  if (before.size() != 1 || !motions) return {};
  auto choices = motionNames(**motions);
  choices.emplace_back("?");
  return choices;
}

template <std::vector<std::string> (*names)()>
std::vector<std::string> oneOf(Console&, const Words& before) {
  auto choices = before.size() == 1 ? names() : std::vector<std::string>{};
  if (before.size() == 1) choices.emplace_back("?");
  return choices;
}

std::vector<std::string> penaltyNames(Console&, const Words&) {
  std::vector<std::string> names;
  for (const auto& [name, penalty] : penalties) names.emplace_back(name);
  return names;
}

}  // namespace

Result<void> moveByJoystick(Console& console) {
  const Time now = console.session().time();
  const auto walk = console.joystick().walk(now);
  const auto head = console.joystick().head(now);
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (walk) {
      robot.motion.type = MotionType::walk;
      robot.motion.walk = *walk;
      if (auto done = robot.send(robot.motion); !done) return done;
    }
    return head ? robot.send(*head) : Result<void>{};
  });
}

std::vector<Command> motionCommands() {
  constexpr auto kind = Command::Kind::robot;
  return {
      {kind, "hcm", "? | MODE", "Sets the head control mode, while no BehaviorControl is active.",
       hcm, oneOf<namesOf<HeadMode>>, true},
      {kind, "hmr", "TILT PAN ROLL MOUTH",
       "Sets the head's joints, in degrees; works in the head control mode none.", hmr, nullptr,
       true},
      {kind, "mr", "? | TYPE [X Y R]",
       "Sets the motion, while no BehaviorControl is active. To walk (normal) takes speeds: ahead "
       "and "
       "left in mm/s, counterclockwise in degrees/s.",
       mr, motionChoices, true},
      {kind, "pr",
       "continue | illegalDefender | obstruction | keeperCharged | ballHolding | "
       "fieldPlayerCharged "
       "| illegalDefense | requestForPickup",
       "Penalizes robots, or lets them go on.", pr, penaltyNames, true},
      {kind, "tr", "? | TYPE", "Sets what the tail does, while no BehaviorControl is active.", tr,
       oneOf<namesOf<TailRequest>>, true}};
}

}  // namespace gt
