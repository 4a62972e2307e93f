#include <charconv>
#include <cmath>
#include <filesystem>

#include "console/Commands.h"

namespace gt {
namespace {

Result<void> sc(Console& console, const Words& words) {
  const bool gameManager = words.size() > 1 && words[1] == "gameManager";
  const std::vector<std::string> robots{words.begin() + (gameManager ? 2 : 1), words.end()};
  if (robots.empty()) return wrongArguments(words);
  return console.session().connect(robots, gameManager);
}

Result<void> sl(Console& console, const Words& words) {
  if (words.size() != 3) return wrongArguments(words);
  return console.session().replay(words[1], withDefaults(words[2], "out/logs", ".mcap"));
}

void printHelp(Console& console, const Command& command) {
  std::string usage{command.name};
  if (!command.arguments.empty()) usage += " " + std::string{command.arguments};
  console.print(usage);
  console.print("    " + std::string{command.help});
}

Result<void> help(Console& console, const Words& words) {
  if (words.size() > 2) return wrongArguments(words);
  if (words.size() == 2 && !Console::find(words[1]))
    return Error{"", 0, words[1], "there is no such command"};
  for (const Command& command : Console::commands())
    if (words.size() == 1 || command.name == words[1]) printHelp(console, command);
  return {};
}

std::vector<std::string> commandNames(Console&, const Words&) {
  std::vector<std::string> names;
  for (const Command& command : Console::commands()) names.emplace_back(command.name);
  return names;
}

Result<void> echo(Console& console, const Words& words) {
  console.print(words.rest);
  const auto echoed = splitWords(words.rest);
  if (echoed && !echoed->empty() && Console::find(echoed->front())) console.offer(words.rest);
  return {};
}

Result<void> comment(Console&, const Words&) {
  return {};
}

Result<void> cls(Console& console, const Words&) {
  console.session().screen().clear();
  return {};
}

Result<void> call(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  return console.call(words[1]);
}

std::vector<std::string> robotNames(Console& console, const Words&) {
  std::vector<std::string> names{"?", "all"};
  for (const auto& robot : console.session().robots()) names.push_back(robot->name());
  return names;
}

Result<void> selectRobots(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  if (words[1] == "all") {
    console.select({});
    return {};
  }
  if (words[1] == "?") {
    for (const auto& known : console.session().robots()) console.print(known->name());
    return {};
  }
  for (std::size_t i = 1; i < words.size(); ++i)
    if (!console.session().find(words[i]))
      return Error{"", 0, words[i], "there is no robot of that name; try robot ?"};
  console.select({words.begin() + 1, words.end()});
  return {};
}

/// Tells robots that live elsewhere what a game manager would tell them.
Result<void> tellElsewhere(Console& console, GameState state, std::optional<TeamColor> kickOff,
                           std::array<int, 2> score) {
  for (const auto& known : console.session().robots()) {
    if (known->index()) continue;
    TeamColor team = TeamColor::red;
    if (Robot* here = known->robot()) team = here->setup().player.teamColor;
    GameControlData data;
    data.state = state;
    if (kickOff) data.kickOff = *kickOff == team ? KickOff::own : KickOff::opponent;
    data.ownScore = score[static_cast<std::size_t>(team)];
    data.opponentScore = score[static_cast<std::size_t>(opponent(team))];
    if (auto done = known->send(data); !done) return done;
  }
  return {};
}

Result<void> gc(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  const std::string& what = words[1];
  Referee& referee = console.session().simulation().referee();
  const Time now = console.session().time();
  std::array<int, 2> score{referee.score(TeamColor::red), referee.score(TeamColor::blue)};
  std::optional<TeamColor> kickOff;
  GameState state = referee.state();
  if (what == "kickOff") {
    if (words.size() != 3 && words.size() != 5) return wrongArguments(words);
    kickOff = enumValue<TeamColor>(words[2]);
    if (!kickOff) return wrongArguments(words);
    for (std::size_t i = 3; i < words.size(); ++i) {  // blue, then red
      const auto goals = numberOf(words[i], 0, 1000);
      if (!goals) return goals.error();
      score[4 - i] = static_cast<int>(*goals);
    }
    referee.setKickOff(*kickOff);
    state = GameState::set;
  } else if (words.size() == 2) {
    if (what == "reset") {
      score = {0, 0};
      state = GameState::initial;
    } else if (what == "ready") {
      state = GameState::ready;
    } else if (what == "playing") {
      state = GameState::playing;
    } else if (what == "final") {
      state = GameState::finished;
    } else {
      return wrongArguments(words);
    }
  } else {
    return wrongArguments(words);
  }
  referee.setScore(TeamColor::red, score[0], now);
  referee.setScore(TeamColor::blue, score[1], now);
  referee.changeState(state, now);
  return tellElsewhere(console, state, kickOff, score);
}

std::vector<std::string> gcChoices(Console&, const Words& before) {
  if (before.size() == 1) return {"reset", "ready", "playing", "final", "kickOff"};
  if (before.size() == 2 && before[1] == "kickOff") return {"blue", "red"};
  return {};
}

Result<void> jbc(Console& console, const Words& words) {
  if (words.size() < 3) return wrongArguments(words);
  const auto button = numberOf(words[1], 1, Joystick::buttons);
  if (!button) return button.error();
  if (*button != std::floor(*button)) return wrongArguments(words);
  if (!Console::find(words[2]) && !words[2].starts_with('#'))
    return Error{"", 0, words[2], "there is no such command; try help"};
  const std::size_t command = words.rest.find_first_not_of(" \t", words.rest.find_first_of(" \t"));
  console.joystick().setCommand(static_cast<int>(*button), words.rest.substr(command));
  return {};
}

Result<void> jhc(Console& console, const Words& words) {
  const auto axis = words.size() == 2 ? enumValue<Joystick::HeadAxis>(words[1]) : std::nullopt;
  if (!axis) return wrongArguments(words);
  console.joystick().setHeadAxis(*axis);
  return {};
}

Result<void> st(Console& console, const Words& words) {
  if (words.size() < 2 || words.size() > 3) return wrongArguments(words);
  Pace pace;
  if (words[1] == "on") {
    if (words.size() == 3) {
      const auto factor = numberOf(words[2], 0.01, 1000);
      if (!factor) return factor.error();
      pace.factor = *factor;
    }
  } else if (words[1] == "off") {
    pace = {1, 1};
    if (words.size() == 3) {
      const auto slowness = numberOf(words[2], 0.01, 1e6);
      if (!slowness) return slowness.error();
      pace.slowness = *slowness;
    }
  } else {
    return wrongArguments(words);
  }
  console.session().setPace(pace);
  return {};
}

constexpr char on[] = "on", off[] = "off", tilt[] = "tilt", pan[] = "pan", roll[] = "roll";

std::vector<std::string> scripts(Console&, const Words&) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator{"scenes", failed})
    if (entry.path().extension() == ".con") names.push_back(entry.path().stem().string());
  return names;
}

}  // namespace

Result<double> numberOf(const std::string& word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(number))
    return Error{"", 0, word, "is no number"};
  return number;
}

Result<double> numberOf(const std::string& word, double low, double high) {
  const auto number = numberOf(word);
  if (number && (*number < low || *number > high)) {
    const auto shortText = [](double value) {
      char text[32];
      return std::string{text, std::to_chars(text, text + sizeof text, value).ptr};
    };
    return Error{"", 0, word, "is not from " + shortText(low) + " to " + shortText(high)};
  }
  return number;
}

Result<bool> switchOf(const Words& words, std::size_t word) {
  if (words.size() != word + 1 || (words[word] != "on" && words[word] != "off"))
    return wrongArguments(words);
  return words[word] == "on";
}

Error wrongArguments(const Words& words) {
  const Command* command = Console::find(words.front());
  return {"", 0, words.front(),
          "expected: " + words.front() + " " + std::string{command ? command->arguments : ""}};
}

std::string withDefaults(const std::string& file, const std::string& folder,
                         const std::string& extension) {
  std::filesystem::path path{file};
  if (!path.has_parent_path()) path = std::filesystem::path{folder} / path;
  if (!path.has_extension()) path += extension;
  return path.string();
}

void list(Console& console, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) console.print(line);
}

std::vector<Command> globalCommands() {
  using enum Command::Kind;
  return {
      {initialization, "sc",
       "[gameManager] (A.B.C.D | A.B.C D {D} | NAME=ENDPOINT {NAME=ENDPOINT})",
       "Connects to real robots, through a router that runs in the background; with gameManager it "
       "has a port for one. To be used once. A robot is named by the last number of its address.",
       sc},
      {initialization, "sl", "NAME FILE",
       "Makes a robot of that name that lives on a log, from out/logs/ and with .mcap if the file "
       "has no folder and extension. With st on, which is the default, no picture is lost.",
       sl},
      {global, "#", "TEXT", "A comment.", comment},
      {global, "?", "[COMMAND]", "The same as help.", help, commandNames},
      {global, "call", "FILE",
       "Executes a script, one command per line; from scenes/ and with .con if the file has no "
       "folder and extension.",
       call, scripts},
      {global, "cls", "", "Clears the console.", cls},
      {global, "echo", "TEXT",
       "Prints a text. If that is a command, who types finds it in the history.", echo},
      {global, "gc", "reset | ready | playing | final | kickOff (blue | red) [BLUESCORE REDSCORE]",
       "Controls the game of all robots, as a game manager does; reset also clears the score.", gc,
       gcChoices, true},
      {global, "help", "[COMMAND]", "Tells what there is.", help, commandNames},
      {global, "jbc", "BUTTON COMMAND",
       "Sets what a joystick's button (1 to 32) does when it is pressed.", jbc, nullptr, true},
      {global, "jhc", "tilt | pan | roll",
       "Sets which axis of the head the joystick's accelerator lever controls (by default pan); "
       "the "
       "coolie hat controls the others.",
       jhc, oneOf<tilt, pan, roll>, true},
      {global, "robot", "? | all | NAME {NAME}",
       "Selects the robots that the robot commands are for, or lists them.", selectRobots,
       robotNames, true},
      {global, "st", "off [SLOWNESS] | on [FACTOR]",
       "Simulated time, on by default: each step advances it by 8 ms, as fast as it goes or at "
       "most "
       "FACTOR times real time. Off: real time; a robot whose modules take longer loses pictures, "
       "as "
       "if its computer were SLOWNESS times slower than this one.",
       st, oneOf<on, off>}};
}

}  // namespace gt
