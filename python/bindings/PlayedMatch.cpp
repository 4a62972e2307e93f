#include "PlayedMatch.h"

#include <cmath>

#include "Failure.h"
#include "base/Lines.h"

namespace gt::python {
namespace {

namespace nb = nanobind;

/// How often a long run looks whether somebody presses Ctrl-C.
constexpr int stepsBetweenSignals = 50;

}  // namespace

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
  // As `simgt play`: a console hands the truth to robots whose tasks are disabled.
  execute("so off");
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

void PlayedMatch::execute(const std::string& line) {
  requireRest();
  orThrow(console_->execute(line));
}

void PlayedMatch::executeFor(const std::string& robot, const std::string& line) {
  execute("robot " + quotedWord(robot));
  execute(line);
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
