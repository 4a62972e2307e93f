#include "console/Manual.h"

#include "console/Commands.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr const char* introduction = R"(# The console

Made by `simgt commands` from the table of commands; a test holds both together.

`simgt console SCENE` runs a scene with a console: commands are typed (with a history, kept in `$XDG_STATE_HOME/gt2003`, and completion by the tab key), piped in, or
stand in scripts (`--script FILE`, `-c COMMAND`), one a line; `#` begins a comment. A scene names the script that it begins with; if
it does not, `console.con` beside it is executed where there is one. After an error a script ends, and so does the program, with exit
status 2, or 1 if a condition did not hold that was expected to (a script is a test). Ctrl-C, SIGTERM and a closed terminal end scripts
and program with status 130, 143 or 129, as does who reads no more of what is printed, with 141; a film is whole then, and recordings are saved beside the log to which they were saved last, as `NAME.interrupted.mcap`, or to
`out/logs/ROBOT.interrupted.mcap`.

    robot red4
    sr BallLocator disabled
    place ball 300 0
    until distance(red4, ball) < 200 within 30
    expect red4.posture == standing

Arguments: `|` stands between alternatives, `[ ]` around what may be missing, `{ }` around what may be repeated. A backslash takes
the next character as it is; quotes keep words together. Names of symbols, options and elements may be written as in the report,
with hyphens. Simulated time stands while nothing is asked of it: `run` and `until` let it pass, and `start` while lines are typed.
Where lines are typed, Ctrl-C stops it, and nothing is lost. `help` lists the commands by topic.

## Values and conditions

`get`, `until`, `expect`, `plot` and `test situation` take values by path:

| path | value |
| --- | --- |
| `time`, `half`, `timeLeft`, `state`, `kickOff`, `score.red`, `score.blue` | of the game; times in s |
| `ball.x`, `ball.y`, `ball.speed`, `ball.toucher` | truly, in mm and mm/s; `ball1` is the second ball |
| `red1.x`, `.y`, `.rotation`, `.height`, `.tilt`, `.roll`, `.walked`, `.posture` | of a robot's body, truly, in mm and degrees |
| `red1.RobotPose.pose.rotation`, `RobotPose.pose.rotation` | of a representation; without a name of the selected robot |
| `red1.WalkingEngine.normal.maxStepSizeX`, `WalkingEngine.InvKin.normal.maxStepSizeX` | a parameter, of the solution that runs or another one |
| `robots.red1.joints.headPan`, `emitters.ambient`, `radio.loss`, `fidelity` | an object of the scene, in mm and degrees: `get ?` lists them |

A number behind an object counts its numbers: `robots.red1.0` is x. `get` also takes the beginning of a path, and prints all values
below it: `get RobotPose`.

Conditions compare values (`<`, `<=`, `>`, `>=`, `==`, `!=`) with each other, numbers, names and sums (`+ - * /`, `abs(a)`,
`min(a, b)`, `max(a, b)`, `distance(red1, ball)`), joined by `and`, `or`, `not` and parentheses.
)";

void add(std::string& text, Command::Kind kind, const char* heading) {
  text += std::string{"\n## "} + heading + "\n";
  for (const Command& command : Console::commands()) {
    if (command.kind != kind) continue;
    text += "\n**" + std::string{command.name} + "**";
    if (!command.arguments.empty()) text += " `" + std::string{command.arguments} + "`";
    text += "\n\n" + std::string{command.help} + "\n";
  }
}

}  // namespace

std::string consoleManual() {
  std::string text = introduction;
  add(text, Command::Kind::initialization, "Commands for the beginning (report I.5.1)");
  add(text, Command::Kind::global, "Global commands (report I.5.2)");
  add(text, Command::Kind::robot, "Commands for the selected robots (report I.5.3)");
  text +=
      "\n## Views\n\nOf `picture` and `film`; `view` defines more. [simulator.md](simulator.md) "
      "shows each.\n\n";
  text += "| view | what it shows |\n| --- | --- |\n";
  for (const auto& view : builtInViews())
    text += "| `" + view->name() + "` | " + view->help() + " |\n";
  return text;
}

}  // namespace gt
