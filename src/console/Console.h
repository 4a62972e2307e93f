#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "console/Joystick.h"
#include "console/JoystickInput.h"
#include "console/JoystickScheme.h"
#include "console/ViewRecorder.h"
#include "representations/motion/MotionNet.h"
#include "session/Session.h"
#include "session/SoundPlayer.h"
#include "views/Views.h"
#include "xabsl/language/Behavior.h"

namespace gt {

/// The words of a command line; the first is the command. A backslash escapes the next character; a
/// word that begins with a quote extends to the next quote.
struct Words : std::vector<std::string> {
  using vector::vector;
  std::string rest;  ///< The text behind the command, as it was typed.
};

class Console;

/// A command of the console. Help, completion and docs/console.md are made from the table of these.
struct Command {
  enum class Kind { initialization, global, robot };
  using Choices = std::vector<std::string> (*)(Console& console, const Words& before);

  Kind kind;
  std::string_view name;
  /// Its arguments, in the notation of Usage.h; a line that does not match is refused.
  std::string_view arguments;
  std::string_view help;
  Result<void> (*execute)(Console& console, const Words& words);
  /// The choices for a placeholder behind the words `before`; null: those that its name states.
  Choices choices = nullptr;
  bool changes = false;  ///< Whether it influences the match: a loaded state repeats it.
  std::string_view topic{};
};

/// A topic of commands, which is a part of the help.
struct HelpTopic {
  std::string_view name;
  std::string_view help;
};
const std::vector<HelpTopic>& topics();

/// Executes commands and scripts (report I.5, I.6). Global commands affect the whole session; robot
/// commands affect the selected robots, at the start all of them.
class Console {
 public:
  explicit Console(Session& session);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Executes one line. Errors name the line's command or the word that is wrong.
  Result<void> execute(std::string_view line);
  /// Executes one line for some robots, or for all if `robots` is empty, independent of the
  /// selection. Selections and line are recorded, so that a loaded state repeats them.
  Result<void> executeFor(const std::vector<std::string>& robots, std::string_view line);
  /// Executes one line as a part of another command; only that command is recorded.
  Result<void> executeWithin(std::string_view line);
  /// Executes one line from a joystick and records it, even while another command is executed.
  Result<void> executeInput(std::string_view line);
  /// Executes a script, one command per line, up to the first error, which names file and line.
  /// Scripts of the folder scenes/ need neither folder nor extension (.con).
  Result<void> call(const std::string& path);
  /// Executes the script that the scene begins with, if there is one.
  Result<void> callStartScript();
  /// Ends the running scripts and the program.
  void end() { ended_ = true; }
  bool ended() const { return ended_; }
  /// To be called when a signal ends the program: ends the film, and saves recordings that would be
  /// lost: beside the log to which they were saved last, as `NAME.interrupted.mcap`, or to
  /// `out/logs/ROBOT.interrupted.mcap`. Returns a line, or an error, for each recording.
  std::vector<Result<std::string>> keepRecordings();
  /// To be called when the session was restarted: clears the selection, recorded values and loaded
  /// files, and ends the film.
  void forget();

  static const std::vector<Command>& commands();
  /// A command by its name; null if there is none.
  static const Command* find(std::string_view name);
  /// The completions of the last word of a line that was typed so far.
  std::vector<std::string> completions(std::string_view line);

  Session& session() { return session_; }
  void print(std::string_view line) { session_.screen().print(line); }

  /// The robots that robot commands affect.
  std::vector<ConsoleRobot*> selected();
  const std::vector<std::string>& selection() const { return selected_; }
  void select(std::vector<std::string> names) { selected_ = std::move(names); }
  /// Calls work(robot) for each selected robot, up to the first error, which names the robot.
  Result<void> forEachRobot(const std::function<Result<void>(ConsoleRobot&)>& work);
  /// The first selected robot; an error if there is none.
  Result<ConsoleRobot*> firstRobot();

  /// The special actions whose names the command mr accepts: those of the session's folder.
  Result<const MotionNet*> motions();
  /// The behavior whose names the x commands accept: the one that `xlb` loaded, or that of the
  /// robots.
  Result<const xabsl::Model*> behavior();
  void forgetBehavior() { behavior_.reset(); }

  /// Queues a command that the user may run or discard (report I.5.2: echo).
  void offer(std::string line) {
    if (offers_.size() < mostOffers) offers_.push_back(std::move(line));
  }
  /// The commands that were offered since the last call.
  std::vector<std::string> takeOffers() { return std::exchange(offers_, {}); }

  /// All views: those of the report, and those that were defined (command view).
  std::vector<std::shared_ptr<const View>> views() const;
  /// Defines or redefines a view.
  void define(std::shared_ptr<const View> view);
  /// Removes a defined view; false if there is none of this name.
  bool forgetView(std::string_view name);
  /// The present subject of views.
  ViewSubject viewSubject();

  Joystick& joystick() { return joystick_; }
  /// The scheme by which the joystick moves robots; empty: by `joystick()`.
  std::optional<JoystickScheme>& joystickScheme() { return scheme_; }
  /// Attaches a joystick of this machine, which is read while time passes; null detaches it.
  void read(std::unique_ptr<SdlJoystick> joystick);
  /// Starts or stops playing the selected robots' sounds on this machine.
  void playSounds(bool on);
  /// Records values and films over time (commands plot and film).
  ViewRecorder& recorder() { return *recorder_; }
  /// Whether an expected condition did not hold, so that a script that is a test has failed.
  bool expectationFailed() const { return expectationFailed_; }
  void failExpectation() { expectationFailed_ = true; }

 private:
  void followSounds();

  static constexpr std::size_t mostOffers = 1000;

  Session& session_;
  std::vector<std::string> offers_;
  std::vector<std::string> selected_;  ///< All if empty.
  std::optional<MotionNet> motions_;
  std::optional<xabsl::Behavior> behavior_;
  Joystick joystick_;
  std::vector<std::shared_ptr<const View>> definedViews_;
  std::unique_ptr<ViewRecorder> recorder_;
  std::unique_ptr<SdlJoystick> device_;
  JoystickInput input_;
  std::optional<JoystickScheme> scheme_;
  std::unique_ptr<SoundPlayer> sounds_;
  std::shared_ptr<const void> afterSteps_;
  int depth_ = 0;  ///< Number of nested scripts.
  bool noting_ = true, ended_ = false;
  bool expectationFailed_ = false;
};

/// Splits a line into words; an error if a quote is not closed.
Result<Words> splitWords(std::string_view line);

}  // namespace gt
