#include "base/Suggestion.h"
#include "console/Commands.h"
#include "representations/behavior/SoundRequest.h"

namespace gt {
namespace {

Result<void> sound(Console& console, const Words& words) {
  if (words[1] == "?") {
    list(console, namesOf<Sound>());
    return {};
  }
  if (words[1] == "on" || words[1] == "off") {
    console.playSounds(words[1] == "on");
    return {};
  }
  const auto name = enumValue<Sound>(words[1]);
  if (!name)
    return Error{
        .field = words[1],
        .what = "there is no such sound; try sound ?" + suggestion(words[1], namesOf<Sound>())};
  return console.forEachRobot(
      [&](ConsoleRobot& robot) { return robot.observed().send(SoundRequest{*name}); });
}

std::vector<std::string> soundNames(Console&, const Words& before) {
  return before.size() == 1 ? namesOf<Sound>() : std::vector<std::string>{};
}

}  // namespace

std::vector<Command> soundCommands() {
  return {{Command::Kind::robot, "sound", "? | on | off | SOUND",
           "Plays what the selected robots play on this machine's loudspeaker from now on, or no "
           "longer; or requests a sound, while no BehaviorControl is active.",
           sound, soundNames, true}};
}

}  // namespace gt
