#pragma once
#include <malloc.h>
#include <nanobind/nanobind.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "PythonSolution.h"
#include "console/Console.h"
#include "session/Session.h"

namespace gt::python {

/// A match that Python plays. What is done to it is done by lines of the console, which are noted:
/// so a saved state can be loaded here and there.
///
/// It runs without Python's lock. Whoever uses it meanwhile in another thread gets an error.
class PlayedMatch {
 public:
  explicit PlayedMatch(const MatchOptions& options);
  static std::unique_ptr<PlayedMatch> load(const std::string& file, const MatchOptions& options);

  /// One step of 8 ms; false if the game is over.
  bool step();
  /// Steps until `seconds` have passed, or to the end. Returns whether the game goes on.
  bool run(std::optional<double> seconds);
  /// Steps until the predicate returns true, but no longer than `seconds`. Returns whether it did.
  bool until(const nanobind::callable& predicate, double seconds);

  /// Executes any line of the console for a robot, or for all (empty), and returns what it prints.
  std::string console(const std::string& line, const std::string& robot);
  /// What a view shows of a robot, or of the first (empty): an array of RGB. Writes it to a file,
  /// too, unless that is empty.
  nanobind::object picture(const std::string& view, const std::string& robot,
                           const std::vector<double>& numbers, const std::string& file);
  /// Executes a line of the console that changes something.
  void execute(const std::string& line);
  /// The same for one robot; an error is about what was given.
  void executeFor(const std::string& robot, const std::string& line, const std::string& about);
  /// Has a robot's task solved by another solution: by its name, or by a new object of Python that
  /// `solution` makes, which is returned. Such a match cannot be saved.
  nanobind::object solve(std::size_t robot, const std::string& task, nanobind::handle solution);
  /// The solutions written in Python.
  std::vector<PythonSolution> joined() const;
  /// What they did wrong.
  std::vector<SolutionFailures::Failure> failures() const { return failures_->all(); }
  /// Has the true class and geom of each pixel kept with all robots' images from now on.
  void keepLabels();
  bool keepsLabels() const { return keepsLabels_; }
  void save(const std::string& file);
  void close();

  /// The names of its robots, in the scene's order.
  std::vector<std::string> robotNames();

  /// The match, unless it runs. References to what it has are valid until it runs on.
  Match& match();
  Session& session();

 private:
  /// Keeps what is printed while somebody listens, and looks for Ctrl-C meanwhile.
  class Screen : public gt::Screen {
   public:
    void print(std::string_view line) override;
    void stepped() override;

    std::optional<std::string> printed;  ///< Empty: nobody listens.
    Session* session = nullptr;
    int steps = 0;
  };
  /// Marks the match as running.
  class Run;
  /// Gives back to the system what a match held: between the blocks of what lives longer it would
  /// stay, and a program that plays many would grow.
  struct MemoryReturn {
    ~MemoryReturn() { malloc_trim(0); }
  };

  struct Joined {
    std::size_t robot;
    std::string task;
    PythonSolution solution;
  };

  void requireRest() const;
  /// The robot of this name, which must be there; none, for all of them, if it is empty.
  std::vector<std::string> namedOrAll(const std::string& robot);
  const Joined* findJoined(std::size_t robot, const std::string& task,
                           const std::string& name) const;
  nanobind::object join(std::size_t robot, const std::string& task, nanobind::handle made);
  /// Tells by a warning of Python what went wrong since the last time.
  void warnOfFailures();
  template <typename Done>
  bool runUntil(Done done);
  template <typename Done>
  bool stepUntil(Done done);

  MemoryReturn memoryReturn_;  ///< The last one to go.
  Screen screen_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Console> console_;
  std::vector<Joined> joined_;
  std::shared_ptr<SolutionFailures> failures_ = std::make_shared<SolutionFailures>();
  std::size_t toldFailures_ = 0;
  std::size_t toldRobots_ = 0;  ///< Of those whose programs failed.
  bool keepsLabels_ = false;
  bool running_ = false;  ///< Changed with Python's lock only.
};

}  // namespace gt::python
