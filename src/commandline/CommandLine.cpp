#include "commandline/CommandLine.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "base/Guarded.h"

namespace gt {
namespace {

constexpr int wrongInput = 2;  // exit status

/// The value of --root, before the other options are parsed.
std::string rootOptionOf(int argc, char** argv) {
  constexpr std::string_view option = "--root", withValue = "--root=";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == option && i + 1 < argc) return argv[i + 1];
    if (argument.starts_with(withValue)) return std::string{argument.substr(withValue.size())};
  }
  return "";
}

/// Refuses what the library takes for a number: no number, and a negative one where none can be
/// (which it wraps around).
void checkNumbers(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& text : option->results()) {
      const std::string type = option->get_type_name();
      double number = 0;
      if (type.starts_with("FLOAT") && CLI::detail::lexical_cast(text, number) &&
          !std::isfinite(number))
        throw CLI::ValidationError{option->get_name(), text + " is no number"};
      if (type.starts_with("UINT") && text.starts_with('-'))
        throw CLI::ValidationError{option->get_name(), text + " is less than 0"};
    }
  for (const CLI::App* command : app.get_subcommands()) checkNumbers(*command);
}

}  // namespace

CommandLine::CommandLine(int argc, char** argv, const std::string& description)
    : argc_{argc},
      argv_{argv},
      name_{std::filesystem::path{argv[0]}.filename().string()},
      app_{description, name_} {
  app_.fallthrough();  // options of the program may stand behind the command
}

const DataRoot& CommandLine::root() {
  static const DataRoot none;
  if (!root_) {
    app_.add_option("--root", rootOption_,
                    "Folder of the data: behavior, config, layouts, models, motions, scenes; by "
                    "default $GT2003_ROOT, or the tree that the program belongs to");
    root_ = DataRoot::find(DataRoot::places(rootOptionOf(argc_, argv_)));
  }
  return *root_ ? **root_ : none;
}

CLI::App& CommandLine::addCommand(const char* name, const char* description, Action action) {
  app_.require_subcommand(1);
  CLI::App& command = *app_.add_subcommand(name, description);
  command.callback([this, action = std::move(action)] { command_ = action; });
  return command;
}

int CommandLine::perform(const Action& action) {
  if (action && !app_.get_subcommands({}).empty()) app_.require_subcommand(0, 1);
  try {
    app_.parse(argc_, argv_);
    checkNumbers(app_);
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app_.exit(error) : fail(error.what());
  }
  if (root_ && !*root_) return fail(root_->error().text());
  // A file that grows beyond its limit is an error of who writes it.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const auto status = command_ ? command_() : action();
    if (!status) return fail(status.error().text());
    if (std::fflush(stdout) != 0) return failToPrint(std::generic_category().message(errno));
    if (*status == 0 && std::ferror(stdout) != 0) return failToPrint("cannot be written");
    return *status;
  } catch (const std::exception& exception) {
    const auto* ofSystem = dynamic_cast<const std::system_error*>(&exception);
    if (ofSystem && std::ferror(stdout) != 0)  // fmt's, where nothing can be printed
      return failToPrint(ofSystem->code().message());
    return fail(errorOf(exception).text());
  }
}

int CommandLine::failToPrint(const std::string& why) const {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  const bool readerHasGone = poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
  return readerHasGone ? 128 + SIGPIPE : fail("standard output: " + why);
}

int CommandLine::fail(const std::string& what) const {
  std::fflush(stdout);
  std::fprintf(stderr, "%s: %s\n", name_.c_str(), what.c_str());
  return wrongInput;
}

}  // namespace gt
