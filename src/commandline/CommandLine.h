#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>

#include "base/DataRoot.h"
#include "base/Result.h"

namespace gt {

/// The command line of a program. In all programs an error is reported in one line that begins with
/// the program's name, and ends the program with exit status 2. An exception thrown by the
/// program's work is handled in the same way.
class CommandLine {
 public:
  /// Returns the exit status, or the error that ends the program.
  using Action = std::function<Result<int>()>;

  CommandLine(int argc, char** argv, const std::string& description);

  /// The parser, to which the program adds its options.
  CLI::App& app() { return app_; }
  /// Adds the option --root. The root is searched immediately, so that other options can have
  /// default files in it. If there is none, `run` reports that.
  const DataRoot& root();

  /// Adds a command, one of which must be given. Its action may return a Result<void>, a
  /// Result<int> or an int.
  template <typename F>
  CLI::App& command(const char* name, const char* description, F action) {
    return addCommand(name, description, actionOf(std::move(action)));
  }
  /// Parses the command line and performs the action of the command that is given; if none is,
  /// performs `action`. Returns the exit status.
  template <typename F>
  int run(F action) {
    return perform(actionOf(std::move(action)));
  }
  /// Parses the command line and performs the given command, which is required.
  int run() { return perform(nullptr); }

 private:
  template <typename F>
  static Action actionOf(F action) {
    return [action = std::move(action)]() mutable -> Result<int> {
      if constexpr (std::is_same_v<decltype(action()), Result<void>>) {
        if (const auto done = action(); !done) return done.error();
        return 0;
      } else {
        return action();
      }
    };
  }
  CLI::App& addCommand(const char* name, const char* description, Action action);
  int perform(const Action& action);
  int fail(const std::string& what) const;
  int failToPrint(const std::string& why) const;

  int argc_;
  char** argv_;
  std::string name_;
  CLI::App app_;
  Action command_;  ///< Action of the given command.
  std::string rootOption_;
  std::optional<Result<DataRoot>> root_;
};

}  // namespace gt
