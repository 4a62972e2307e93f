#include <algorithm>
#include <map>

#include "console/Commands.h"
#include "console/Condition.h"
#include "simulation/PutText.h"

namespace gt {
namespace {

constexpr double tailPush = fromDegrees(20);

/// The robots of the scene, active and passive, in the world's order.
std::vector<std::string> sceneRobots(Console& console) {
  std::vector<std::string> names;
  for (const SceneRobot* robot : console.session().simulation().scene().allRobots())
    names.push_back(robot->name);
  return names;
}

Result<std::size_t> sceneRobot(Console& console, const std::string& name) {
  const auto names = sceneRobots(console);
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    return Error{.field = name, .what = "the scene has no robot of this name"};
  return static_cast<std::size_t>(found - names.begin());
}

/// The ball that a word names, ball or ball0 being the first; empty if it names none.
std::optional<std::size_t> ballOf(Console& console, const std::string& word) {
  const std::size_t count = console.session().simulation().world().ballCount();
  for (std::size_t i = 0; i < count; ++i)
    if (word == "ball" + std::to_string(i) || (i == 0 && word == "ball")) return i;
  return std::nullopt;
}

std::vector<std::string> thingNames(Console& console, const Words& before) {
  if (before.size() != 1) return {};
  auto names = sceneRobots(console);
  if (before.front() != "place") return names;
  for (std::size_t i = 0; i < console.session().simulation().world().ballCount(); ++i)
    names.push_back(i == 0 ? "ball" : "ball" + std::to_string(i));
  return names;
}

/// Prints the possible names if a command has only ? as its argument; returns whether it has.
bool asked(Console& console, const Words& words, const std::vector<std::string>& names) {
  if (words[1] != "?") return false;
  list(console, names);
  return true;
}

Result<void> place(Console& console, const Words& words) {
  if (asked(console, words, thingNames(console, {"place"}))) return {};
  std::vector<double> numbers;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto number = numberOf(words[i], -10000, 10000);
    if (!number) return number.error();
    numbers.push_back(*number);
  }
  World& world = console.session().simulation().world();
  if (words[1].starts_with("ball")) {
    const auto ball = ballOf(console, words[1]);
    if (!ball) return Error{.field = words[1], .what = "the scene has no such ball"};
    if (numbers.size() == 3) return wrongArguments(words);
    const Vector2d speed = numbers.size() == 4 ? Vector2d{numbers[2], numbers[3]} : Vector2d{0, 0};
    world.placeBall(*ball, {numbers[0], numbers[1]}, speed);
    printPut(console);
    return {};
  }
  const auto robot = sceneRobot(console, words[1]);
  if (!robot) return robot.error();
  if (numbers.size() == 4) return wrongArguments(words);
  const double rotation =
      numbers.size() == 3 ? normalize(fromDegrees(numbers[2])) : world.robot(*robot).pose.rotation;
  world.placeRobot(*robot, {rotation, numbers[0], numbers[1]});
  printPut(console);
  return {};
}

Result<void> throwOver(Console& console, const Words& words) {
  if (asked(console, words, sceneRobots(console))) return {};
  const auto robot = sceneRobot(console, words[1]);
  if (!robot) return robot.error();
  static const std::map<std::string, Posture> postures{{"right", Posture::onRightSide},
                                                       {"nose", Posture::onNose},
                                                       {"back", Posture::onBack},
                                                       {"sitting", Posture::sitting}};
  const auto wanted = postures.find(words.back());
  console.session().simulation().world().throwOver(
      *robot, wanted == postures.end() ? Posture::onLeftSide : wanted->second);
  printPut(console);
  return {};
}

Result<void> standUp(Console& console, const Words& words) {
  if (asked(console, words, sceneRobots(console))) return {};
  const auto robot = sceneRobot(console, words[1]);
  if (!robot) return robot.error();
  console.session().simulation().world().standUp(*robot);
  printPut(console);
  return {};
}

Result<void> press(Console& console, const Words& words) {
  std::vector<std::string> names = namesOf<Switch>();
  names.insert(names.end(), {"tailLeft", "tailRight"});
  if (asked(console, words, names)) return {};
  const auto which = enumValue<Switch>(words[1]);
  const bool on = words.back() != "off";
  const double tail = on ? (words[1] == "tailLeft" ? tailPush : -tailPush) : 0;
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (!robot.index()) return Error{.field = "press", .what = "is for robots of the scene"};
    Sensors& sensors = console.session().simulation().sensors(*robot.index());
    which ? sensors.press(*which, on) : sensors.pushTail(tail);
    return {};
  });
}

Result<void> fidelity(Console& console, const Words& words) {
  Simulation& simulation = console.session().simulation();
  if (words.size() == 1) {
    console.print(enumName(simulation.scene().fidelity));
    return {};
  }
  if (asked(console, words, namesOf<Fidelity>())) return {};
  const Fidelity wanted = *enumValue<Fidelity>(words[1]);
  if (wanted == simulation.scene().fidelity) return {};
  if (auto done = simulation.changeFidelity(wanted); !done) return done;
  console.print(wanted == Fidelity::dynamic
                    ? "All stands where it stood; motors, contacts and friction move it now."
                    : "All stands where it stood; robots move by their own motion model now.");
  for (const std::string& line : describePuts(simulation)) console.print(line);
  return {};
}

}  // namespace

void printPut(Console& console) {
  const Simulation& simulation = console.session().simulation();
  for (const std::string& line : describe(simulation, simulation.world().puts().back()))
    console.print(line);
}

std::vector<Command> worldCommands() {
  using enum Command::Kind;
  return {
      {global, "fidelity", "? | [kinematic | dynamic]",
       "Switches to the other fidelity, with all where it is; prints which one it is.", fidelity,
       nullptr, true},
      {global, "place", "? | ROBOT X Y [ROTATION] | BALL X Y [VX VY]",
       "Puts a robot on the field, in mm and degrees, or a ball, which may roll, in mm/s. Where "
       "something is already, it goes to the nearest free place, which is printed.",
       place, thingNames, true},
      {robot, "press",
       "? | (headFront | headBack | chin | back | pawFR | pawFL | pawHR | pawHL | tailLeft | "
       "tailRight) [on | off]",
       "Presses a switch of the selected robots until it is off again, or pushes the tail aside.",
       press, nullptr, true},
      {global, "stand", "? | ROBOT", "Puts a robot back on its feet.", standUp, thingNames, true},
      {global, "throw", "? | ROBOT [left | right | nose | back | sitting]",
       "Throws a robot on its side, its nose or its back, or makes it sit.", throwOver, thingNames,
       true}};
}

}  // namespace gt
