#include "console/Console.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include "base/File.h"
#include "base/Lines.h"
#include "base/Suggestion.h"
#include "console/Commands.h"
#include "console/Usage.h"
#include "logs/RobotLog.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "representations/behavior/BehaviorRequest.h"
#include "robot/Configuration.h"

namespace gt {
namespace {

constexpr int deepest = 16;  // scripts that call scripts
constexpr std::string_view blanks = " \t\r";

/// Reads one word from `at` on, and moves `at` behind it; empty if a quote is not closed.
std::optional<std::string> takeWord(std::string_view line, std::size_t& at) {
  std::string word;
  const bool quoted = line[at] == '"';
  if (quoted) ++at;
  for (; at < line.size(); ++at) {
    if (quoted ? line[at] == '"' : blanks.find(line[at]) != blanks.npos) break;
    if (line[at] == '\\' && at + 1 < line.size()) ++at;
    word += line[at];
  }
  if (quoted && at++ >= line.size()) return std::nullopt;
  return word;
}

/// The parts of the table of commands.
struct CommandPart {
  HelpTopic topic;
  std::vector<Command> (*commands)();
};
constexpr CommandPart parts[] = {
    {{"scripts", "help, scripts, what is printed"}, scriptCommands},
    {{"robots", "which robots there are, and which are selected"}, connectionCommands},
    {{"time", "how time passes; scenes and states"}, timeCommands},
    {{"game", "what a referee does"}, gameCommands},
    {{"world", "robots and balls moved by hand"}, worldCommands},
    {{"values", "values, parameters, conditions"}, valueCommands},
    {{"debugging", "solutions, debug keys, processes of robots"}, robotCommands},
    {{"configurations", "writing and reading what robots work with"}, configurationCommands},
    {{"logs", "recording, and playing what was recorded"}, logCommands},
    {{"motion", "robots moved by hand"}, motionCommands},
    {{"motions", "motions tried line by line"}, mofCommands},
    {{"joystick", "robots moved by a joystick"}, joystickCommands},
    {{"sound", "what robots play"}, soundCommands},
    {{"behavior", "what Xabsl2 decides"}, behaviorCommands},
    {{"views", "drawings, plots, films"}, viewCommands},
    {{"tests", "many runs"}, testCommands}};

std::vector<std::string> commandNames() {
  std::vector<std::string> names;
  for (const Command& command : Console::commands()) names.emplace_back(command.name);
  return names;
}

}  // namespace

Console::Console(Session& session)
    : session_{session},
      recorder_{std::make_unique<ViewRecorder>()},
      afterSteps_{session.afterSteps([this] {
        recorder_->step(*this);
        followSounds();
      })} {}

Console::~Console() {
  read(nullptr);
}

void Console::read(std::unique_ptr<SdlJoystick> joystick) {
  if (!joystick && !device_) return;
  device_ = std::move(joystick);
  if (!device_) return session_.setInput({});
  session_.setInput([this] {
    input_.take(*this, *device_);
    input_.update(*this);
  });
}

void Console::playSounds(bool on) {
  sounds_ = on ? std::make_unique<SoundPlayer>(session_.options().root.path("sounds")) : nullptr;
  followSounds();
}

void Console::followSounds() {
  if (!sounds_) return;
  if (const auto done = sounds_->follow(session_, selected()); !done) {
    print(done.error().text());
    sounds_.reset();
  }
}

Result<Words> splitWords(std::string_view line) {
  Words words;
  for (std::size_t at = 0;;) {
    at = line.find_first_not_of(blanks, at);
    if (at == line.npos) return words;
    if (words.size() == 1) {
      words.rest = line.substr(at);
      words.rest.erase(words.rest.find_last_not_of(blanks) + 1);
    }
    auto word = takeWord(line, at);
    if (!word) return Error{.what = "a quote is not closed"};
    words.push_back(std::move(*word));
  }
}

const std::vector<Command>& Console::commands() {
  static const std::vector<Command> table = [] {
    std::vector<Command> all;
    for (const CommandPart& part : parts)
      for (Command& command : part.commands()) {
        command.topic = part.topic.name;
        all.push_back(command);
      }
    std::stable_sort(all.begin(), all.end(), [](const Command& a, const Command& b) {
      return std::pair{a.kind, a.name} < std::pair{b.kind, b.name};
    });
    return all;
  }();
  return table;
}

const std::vector<HelpTopic>& topics() {
  static const std::vector<HelpTopic> all = [] {
    std::vector<HelpTopic> list;
    for (const CommandPart& part : parts) list.push_back(part.topic);
    return list;
  }();
  return all;
}

const Command* Console::find(std::string_view name) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command& command) { return command.name == name; });
  return found == commands().end() ? nullptr : &*found;
}

Result<void> Console::executeFor(const std::vector<std::string>& robots, std::string_view line) {
  const auto selecting = [](const std::vector<std::string>& names) {
    std::string command = "robot";
    for (const std::string& name : names) command += " " + quotedWord(name);
    return names.empty() ? command + " all" : command;
  };
  std::vector<std::string> before = selected_;
  if (auto done = execute(selecting(robots)); !done) return done;
  auto done = execute(line);
  std::erase_if(before, [this](const std::string& name) { return !session_.find(name); });
  const auto back = execute(selecting(before));
  return done ? back : done;
}

Result<void> Console::executeWithin(std::string_view line) {
  const bool noting = std::exchange(noting_, false);
  auto done = execute(line);
  noting_ = noting;
  return done;
}

Result<void> Console::executeInput(std::string_view line) {
  const bool noting = std::exchange(noting_, true);
  auto done = execute(line);
  noting_ = noting;
  return done;
}

Result<void> Console::execute(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
  if (begin == line.size() || line[begin] == '#') return {};
  auto words = splitWords(line);
  if (!words) return words.error();
  if (words->size() > Usage::mostWords)
    return Error{.field = words->front(),
                 .what = "has more than " + std::to_string(Usage::mostWords) + " words"};
  const Command* command = find(words->front());
  if (!command)
    return Error{
        .field = words->front(),
        .what = "there is no such command; try help" + suggestion(words->front(), commandNames())};
  if (!Usage{command->arguments}.matches(std::span{*words}.subspan(1)))
    return wrongArguments(*words);
  auto done = command->execute(*this, *words);
  if (done && noting_ && command->changes && words->back() != "?")
    session_.match().note(InterventionKind::console, std::string{line});
  if (!done && done.error().field.empty())
    return Error{.file = done.error().file,
                 .line = done.error().line,
                 .field = words->front(),
                 .what = done.error().what};
  return done;
}

Result<void> Console::call(const std::string& path) {
  if (depth_ >= deepest)
    return Error{.file = path, .field = "call", .what = "scripts call each other too deeply"};
  const std::string file = dataFile(*this, path, "scenes", ".con");
  const auto text = readFile(std::filesystem::exists(path) ? path : file);
  if (!text) return text.error();
  ++depth_;
  Result<void> done;
  LineReader lines{*text};
  for (auto line = lines.next(); line && done && !ended_; line = done ? lines.next() : line)
    done = execute(*line);
  --depth_;
  // The error of a script that was called names its own place.
  if (!done && done.error().file.empty())
    return Error{.file = path,
                 .line = lines.number(),
                 .field = done.error().field,
                 .what = done.error().what};
  return done;
}

Result<void> Console::callStartScript() {
  const std::string script = session_.simulation().scene().startScript();
  return script.empty() ? Result<void>{} : call(script);
}

void Console::forget() {
  select({});
  forgetBehavior();
  recorder_->clear(*this);
}

std::vector<ConsoleRobot*> Console::selected() {
  std::vector<ConsoleRobot*> robots;
  for (const auto& robot : session_.robots())
    if (selected_.empty() || std::ranges::find(selected_, robot->name()) != selected_.end())
      robots.push_back(robot.get());
  return robots;
}

Result<ConsoleRobot*> Console::firstRobot() {
  const auto robots = selected();
  if (robots.empty()) return Error{.field = "robot", .what = "there is none"};
  return robots.front();
}

Result<void> Console::forEachRobot(const std::function<Result<void>(ConsoleRobot&)>& work) {
  const auto robots = selected();
  if (robots.empty()) return Error{.field = "robot", .what = "there is none"};
  for (ConsoleRobot* robot : robots)
    if (const auto done = work(*robot); !done) {
      Error error = done.error();
      error.what += " (" + robot->name() + ")";
      return error;
    }
  return {};
}

Result<const MotionNet*> Console::motions() {
  if (!motions_) {
    auto loaded = loadMotionNet(session_.options().motions);
    if (!loaded) return loaded.error();
    motions_ = std::move(*loaded);
  }
  return &*motions_;
}

std::vector<std::shared_ptr<const View>> Console::views() const {
  auto all = builtInViews();
  all.insert(all.end(), definedViews_.begin(), definedViews_.end());
  return all;
}

void Console::define(std::shared_ptr<const View> view) {
  forgetView(view->name());
  definedViews_.push_back(std::move(view));
}

bool Console::forgetView(std::string_view name) {
  return std::erase_if(definedViews_, [&](const auto& view) { return view->name() == name; }) > 0;
}

ViewSubject Console::viewSubject() {
  ViewSubject subject{session_.time(),
                      {},
                      &session_.simulation(),
                      session_.match().configuration().get<FieldDimensions>(),
                      &recorder_->series()};
  for (ConsoleRobot* robot : selected()) subject.robots.push_back(&robot->observed());
  return subject;
}

Result<const xabsl::Model*> Console::behavior() {
  if (!behavior_) {
    const std::string& path =
        session_.behavior.empty() ? session_.options().behavior : session_.behavior;
    const auto motions = this->motions();
    if (!motions) return motions.error();
    auto loaded = loadBehavior({path, {}}, **motions);
    if (!loaded) return loaded.error();
    behavior_ = std::move(*loaded->compiled);
  }
  return &behavior_->model();
}

std::vector<Result<std::string>> Console::keepRecordings() {
  recorder_->clear(*this);
  std::vector<Result<std::string>> kept;
  for (const auto& robot : session_.robots()) {
    if (robot->recorder.unsaved() == 0) continue;
    const std::filesystem::path saved{robot->recorder.file()};
    const std::string base =
        saved.empty() ? "out/logs/" + robot->name() : (saved.parent_path() / saved.stem()).string();
    const std::string file = freeLogFile(base + ".interrupted");
    if (const auto done = robot->recorder.save(file); !done)
      kept.emplace_back(done.error());
    else
      kept.emplace_back(robot->name() + ": " + std::to_string(robot->recorder.messages()) +
                        " messages in " + file);
  }
  return kept;
}

}  // namespace gt
