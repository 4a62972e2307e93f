#include "PlayedMatch.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cmath>

#include "Failure.h"
#include "base/Lines.h"
#include "base/Suggestion.h"
#include "framework/UnknownNames.h"
#include "robot/Solutions.h"

namespace gt::python {
namespace {

namespace nb = nanobind;

/// How often a long run looks whether somebody presses Ctrl-C.
constexpr int stepsBetweenSignals = 50;

/// Commands that would take the match away, or more than one line.
constexpr std::string_view notForPython[] = {"call",   "exit",  "load", "quit",  "reset",
                                             "rewind", "scene", "seed", "start", "test"};

}  // namespace

void PlayedMatch::Screen::print(std::string_view line) {
  if (printed) printed->append(line).append("\n");
}

void PlayedMatch::Screen::stepped() {
  if (!printed || ++steps % stepsBetweenSignals != 0) return;
  const nb::gil_scoped_acquire acquired;
  if (PyErr_Occurred() || PyErr_CheckSignals() != 0) session->interrupt();
}

class PlayedMatch::Run {
 public:
  explicit Run(PlayedMatch& match) : match_{match} {
    match_.requireRest();
    match_.running_ = true;
  }
  ~Run() { match_.running_ = false; }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

 private:
  PlayedMatch& match_;
};

PlayedMatch::PlayedMatch(const MatchOptions& options)
    : session_{orThrow(Session::make(options, screen_))},
      console_{std::make_unique<Console>(*session_)} {
  screen_.session = session_.get();
}

std::unique_ptr<PlayedMatch> PlayedMatch::load(const std::string& file,
                                               const MatchOptions& options) {
  auto loaded = std::make_unique<PlayedMatch>(options);
  Console& console = *loaded->console_;
  const nb::gil_scoped_release released;
  orThrow(loaded->session_->load(file, [&](const std::string& line) -> Result<void> {
    const Command* command = Console::find(line.substr(0, line.find(' ')));
    if (!command || !command->changes)
      return Error{.field = line, .what = "is no command that changes something"};
    return console.execute(line);
  }));
  return loaded;
}

void PlayedMatch::requireRest() const {
  if (running_) throw Failure{Error{.field = "match", .what = "it runs in another thread"}};
}

Match& PlayedMatch::match() {
  return session().match();
}

Session& PlayedMatch::session() {
  requireRest();
  return *session_;
}

template <typename Done>
bool PlayedMatch::runUntil(Done done) {
  const bool goesOn = stepUntil(done);
  orThrow(session_->match().teamFailure());
  warnOfFailures();
  return goesOn;
}

template <typename Done>
bool PlayedMatch::stepUntil(Done done) {
  const Run run{*this};
  const nb::gil_scoped_release released;
  Match& match = session_->match();
  for (int steps = 1; !done(match); ++steps) {
    if (match.finished() || !session_->step()) return false;
    if (steps % stepsBetweenSignals == 0) {
      const nb::gil_scoped_acquire acquired;
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
    }
  }
  return true;
}

bool PlayedMatch::step() {
  bool stepped = false;
  return runUntil([&](const Match&) { return std::exchange(stepped, true); });
}

bool PlayedMatch::run(std::optional<double> seconds) {
  if (!seconds) return runUntil([](const Match&) { return false; });
  if (!(*seconds >= 0 && *seconds <= 1e7))
    throw Failure{Error{.field = "seconds", .what = "must be from 0 to 1e7"}};
  const Time end = match().time() + std::llround(*seconds * 1000);
  return runUntil([end](const Match& match) { return match.time() >= end; }) && !match().finished();
}

bool PlayedMatch::until(const nb::callable& predicate, double seconds) {
  if (!(seconds >= 0 && seconds <= 1e7))
    throw Failure{Error{.field = "seconds", .what = "must be from 0 to 1e7"}};
  const Time end = match().time() + std::llround(seconds * 1000);
  while (!nb::cast<bool>(nb::bool_(predicate())))
    if (match().time() >= end || !step()) return false;
  return true;
}

std::vector<std::string> PlayedMatch::robotNames() {
  std::vector<std::string> names;
  for (const auto& robot : match().robots()) names.push_back(robot->name());
  return names;
}

std::vector<std::string> PlayedMatch::namedOrAll(const std::string& robot) {
  if (robot.empty()) return {};
  const std::vector<std::string> known = robotNames();
  if (std::ranges::find(known, robot) == known.end())
    throw Failure{
        Error{.field = "robot", .what = "there is no '" + robot + "'" + suggestion(robot, known)}};
  return {robot};
}

std::string PlayedMatch::console(const std::string& line, const std::string& robot) {
  const Words words = orThrow(splitWords(line));
  if (words.empty()) return {};
  if (words.front() == "robot")
    throw Failure{Error{.field = "robot", .what = "name it: match.console(LINE, robot=\"red1\")"}};
  if (std::ranges::find(notForPython, words.front()) != std::end(notForPython))
    throw Failure{Error{.field = words.front(),
                        .what = "is not for a match of Python, which it would end or replace"}};
  const std::vector<std::string> robots = namedOrAll(robot);
  requireRest();
  Result<void> done;
  screen_.printed.emplace();
  {
    const Run run{*this};
    const nb::gil_scoped_release released;
    done = console_->executeFor(robots, line);
  }
  const std::string printed = *std::exchange(screen_.printed, std::nullopt);
  if (PyErr_Occurred()) throw nb::python_error();
  orThrow(session_->match().teamFailure());
  warnOfFailures();
  orThrow(done);
  return printed;
}

nb::object PlayedMatch::picture(const std::string& view, const std::string& robot,
                                const std::vector<double>& numbers, const std::string& file) {
  ViewSubject subject = console_->viewSubject();
  for (const std::string& name : namedOrAll(robot))
    subject.robots = {&session_->find(name)->observed()};
  const auto views = console_->views();
  const auto found = std::ranges::find(views, view, [](const auto& v) { return v->name(); });
  if (found == views.end()) {
    std::vector<std::string> known;
    for (const auto& one : views) known.push_back(one->name());
    throw Failure{
        Error{.field = "view", .what = "there is no '" + view + "'" + suggestion(view, known)}};
  }
  const Sheet sheet = orThrow((*found)->show(subject, numbers));
  if (!file.empty()) orThrow(sheet.write(file));
  auto pixels = std::make_unique<RgbImage>(sheet.pixels());
  const std::size_t shape[] = {static_cast<std::size_t>(pixels->height),
                               static_cast<std::size_t>(pixels->width), 3};
  std::uint8_t* const first = pixels->pixels.data();
  const nb::capsule owner{pixels.release(),
                          [](void* p) noexcept { delete static_cast<RgbImage*>(p); }};
  return nb::ndarray<nb::numpy, std::uint8_t>(first, 3, shape, owner).cast();
}

void PlayedMatch::execute(const std::string& line) {
  requireRest();
  orThrow(console_->execute(line));
}

void PlayedMatch::executeFor(const std::string& robot, const std::string& line,
                             const std::string& about) {
  requireRest();
  try {
    orThrow(console_->executeFor({robot}, line));
  } catch (const Failure& failure) {
    std::string what = failure.error.what;
    if (what.starts_with(about + ": ")) what.erase(0, about.size() + 2);
    throw Failure{Error{.field = about, .what = what}};
  }
}

const PlayedMatch::Joined* PlayedMatch::findJoined(std::size_t robot, const std::string& task,
                                                   const std::string& name) const {
  const auto found = std::ranges::find_if(joined_, [&](const Joined& joined) {
    return joined.robot == robot && joined.task == task && joined.solution.name() == name;
  });
  return found == joined_.end() ? nullptr : &*found;
}

nb::object PlayedMatch::solve(std::size_t robot, const std::string& task, nb::handle solution) {
  if (!nb::isinstance<nb::str>(solution)) return join(robot, task, solution);
  const auto name = nb::cast<std::string>(solution);
  executeFor(match().robots()[robot]->name(), "sr " + quotedWord(task) + " " + quotedWord(name),
             task);
  return nb::none();
}

nb::object PlayedMatch::join(std::size_t robot, const std::string& task, nb::handle made) {
  if (!PyCallable_Check(made.ptr()))
    throw Failure{Error{.field = task,
                        .what = "expected a solution's name, or a class of solutions that is made "
                                "without arguments"}};
  const nb::object object = made();
  const Run busy{*this};  // what follows runs code of Python, which may let other threads run
  SimulatedRobot& known = *session_->match().robots()[robot];
  const Task* described = solutions().find(task);
  if (!described) throw Failure{Error{.field = task, .what = noSuchTask(solutions(), task)}};
  std::string instead{SolutionTable::disabled};
  for (const auto& process : known.robot().processes())
    if (process->solves(task)) instead = process->activeSolution(task);
  if (const Joined* active = findJoined(robot, task, instead)) instead = active->solution.instead();
  PythonSolution solution{*described, object, robot, instead, failures_};
  orThrow(known.add(task, solution.entry()));
  orThrow(known.robot().request(SolutionRequest{task, solution.name()}));
  std::erase_if(joined_, [&](const Joined& other) {
    return other.robot == robot && other.task == task && other.solution.name() == solution.name();
  });
  joined_.push_back({robot, task, std::move(solution)});
  session_->match().markIrreproducible(known.name() + " has a solution that is written in Python");
  return object;
}

std::vector<PythonSolution> PlayedMatch::joined() const {
  std::vector<PythonSolution> all;
  for (const Joined& joined : joined_) all.push_back(joined.solution);
  return all;
}

void PlayedMatch::warnOfFailures() {
  const auto all = failures_->all();
  while (toldFailures_ < all.size()) {
    const SolutionFailures::Failure& failure = all[toldFailures_++];
    const std::string text = match().robots()[failure.robot]->name() + "'s " + failure.task + " " +
                             failure.solution + " failed at " + std::to_string(failure.time.ms) +
                             " ms and is switched off:\n" + failure.trace;
    if (PyErr_WarnEx(PyExc_RuntimeWarning, text.c_str(), 1) != 0) throw nb::python_error();
  }
  const auto& robots = match().failures();
  while (toldRobots_ < robots.size()) {
    const std::string text = robots[toldRobots_++].error.text();
    if (PyErr_WarnEx(PyExc_RuntimeWarning, text.c_str(), 1) != 0) throw nb::python_error();
  }
}

void PlayedMatch::keepLabels() {
  Match& all = match();
  for (std::size_t i = 0; i < all.robots().size(); ++i)
    all.simulation().keepTruth(all.robotIndex(i));
  keepsLabels_ = true;
}

void PlayedMatch::save(const std::string& file) {
  orThrow(match().save(file));
}

void PlayedMatch::close() {
  orThrow(match().close());
}

}  // namespace gt::python
