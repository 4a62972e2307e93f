#include <algorithm>
#include <cmath>

#include "console/Commands.h"

namespace gt {
namespace {

constexpr std::size_t kickButtons = 4;

/// The quickest kicks.
std::vector<std::string> kicksOf(const MotionNet& motions) {
  std::vector<const KickDescription*> kicks;
  for (const MotionNet::Motion& motion : motions.motions)
    if (motion.isKick()) kicks.push_back(&motion.kick);
  std::ranges::stable_sort(kicks, {}, &KickDescription::seconds);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kicks.size(), kickButtons); ++i)
    names.push_back(kicks[i]->motion);
  return names;
}

std::vector<std::string> actionsOf(const MotionNet& motions) {
  std::vector<std::string> names;
  for (const MotionNet::Motion& motion : motions.motions)
    if (!motion.name.empty()) names.push_back(motion.name);
  return names;
}

Result<void> jbc(Console& console, const Words& words) {
  const auto button = numberOf(words[1], 1, Joystick::buttons);
  if (!button) return button.error();
  if (*button != std::floor(*button)) return wrongArguments(words);
  if (!Console::find(words[2]) && !words[2].starts_with('#'))
    return Error{.field = words[2], .what = "there is no such command; try help"};
  const std::size_t command = words.rest.find_first_not_of(" \t", words.rest.find_first_of(" \t"));
  console.joystick().setCommand(static_cast<int>(*button), words.rest.substr(command));
  return {};
}

Result<void> jhc(Console& console, const Words& words) {
  console.joystick().setHeadAxis(*enumValue<Joystick::HeadAxis>(words[1]));
  return {};
}

Result<void> setScheme(Console& console, JoystickSchemeKind kind) {
  console.joystickScheme().reset();
  if (kind == JoystickSchemeKind::commands) return {};
  // The robot's own, which have what the table of kicks says.
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const auto motions = (*robot)->observed().value<MotionNet>();
  if (!motions) return motions.error();
  console.joystickScheme().emplace(kind, kicksOf(**motions), actionsOf(**motions));
  return console.forEachRobot([](ConsoleRobot& robot) {
    robot.motion = {};
    return robot.observed().send(robot.motion);
  });
}

/// Sends the selected robots the scheme's requests that have changed.
Result<void> followScheme(Console& console) {
  const auto changes = console.joystickScheme()->takeChanges();
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (changes.motion) {
      const TailRequest tail = robot.motion.tail;
      robot.motion = *changes.motion;
      robot.motion.tail = tail;
      if (auto done = robot.observed().send(robot.motion); !done) return done;
    }
    if (changes.headMode) {
      robot.headMode = *changes.headMode;
      HeadControlMode mode;
      mode.mode = *changes.headMode;
      if (auto done = robot.observed().send(mode); !done) return done;
    }
    return changes.head ? robot.observed().send(*changes.head) : Result<void>{};
  });
}

/// Controls the selected robots by the present state of the axes.
Result<void> moveRobots(Console& console) {
  if (console.joystickScheme()) return followScheme(console);
  const Time now = console.session().time();
  const auto walk = console.joystick().walk();
  const auto head = console.joystick().head(now);
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (walk) {
      robot.motion.type = MotionType::walk;
      robot.motion.walk = *walk;
      if (auto done = robot.observed().send(robot.motion); !done) return done;
    }
    return head ? robot.observed().send(*head) : Result<void>{};
  });
}

Result<void> moveAxes(Console& console, const Words& words) {
  std::vector<std::pair<Joystick::Axis, double>> moves;
  for (std::size_t i = 1; i < words.size(); i += 2) {
    const auto axis = enumValue<Joystick::Axis>(words[i]);
    if (!axis) return wrongArguments(words);
    const auto value = numberOf(words[i + 1], -1, 1);
    if (!value) return value.error();
    moves.emplace_back(*axis, *value);
  }
  for (const auto& [axis, value] : moves) {
    console.joystick().move(axis, value);
    if (auto& scheme = console.joystickScheme()) scheme->move(axis, value);
  }
  return moveRobots(console);
}

Result<void> connect(Console& console) {
  auto device = SdlJoystick::open();
  if (!device) return device.error();
  console.print("joystick: " + (*device)->name());
  console.read(std::move(*device));
  return {};
}

Result<void> joystick(Console& console, const Words& words) {
  if (words[1] == "on") return connect(console);
  if (words[1] == "off") {
    console.read(nullptr);
    return {};
  }
  if (words[1] == "scheme") {
    const auto kind = enumValue<JoystickSchemeKind>(words[2]);
    return kind ? setScheme(console, *kind) : wrongArguments(words);
  }
  const bool down = words[1] == "press";
  if (!down && words[1] != "release") return moveAxes(console, words);
  if (words.size() != 3) return wrongArguments(words);
  const auto button = numberOf(words[2], 1, Joystick::buttons);
  if (!button) return button.error();
  if (auto& scheme = console.joystickScheme()) {
    scheme->press(static_cast<int>(*button), down);
    return followScheme(console);
  }
  const auto command = console.joystick().press(static_cast<int>(*button), down);
  if (command) return console.executeWithin(*command);
  // Once no button is pressed, robots walk as the stick stands then.
  return down ? Result<void>{} : moveRobots(console);
}

std::vector<std::string> axisNames(Console&, const Words& before) {
  return before.size() % 2 == 1 ? namesOf<Joystick::Axis>() : std::vector<std::string>{};
}

}  // namespace

std::vector<Command> joystickCommands() {
  using enum Command::Kind;
  return {{global, "jbc", "BUTTON COMMAND",
           "Sets what a joystick's button (1 to 32) does when it is pressed.", jbc, nullptr, true},
          {global, "jhc", "tilt | pan | roll",
           "Sets which axis of the head the joystick's accelerator lever controls (by default "
           "pan); the "
           "coolie hat controls the others.",
           jhc, nullptr, true},
          {global, "joystick",
           "on | off | scheme (commands | stickSpeed | acceleratorSpeed) | (press | release) "
           "BUTTON | AXIS VALUE {AXIS VALUE}",
           "Reads this machine's joystick while time passes, or no longer; sets what its parts do "
           "(report J.5.5; at first commands: jbc, jhc). Or does what a joystick does: its buttons "
           "1 to 32, and its axes x, y, z, accelerator, "
           "hatX and "
           "hatY from -1 to 1, which move the selected robots.",
           joystick, axisNames, true}};
}

}  // namespace gt
