#include "commandline/CommandLine.h"

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

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

}  // namespace

CommandLine::CommandLine(int argc, char** argv, const std::string& description)
    : argc_{argc},
      argv_{argv},
      name_{std::filesystem::path{argv[0]}.filename().string()},
      app_{description, name_} {
  app_.fallthrough();             // options of the program may stand behind the command
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its writer
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
  } catch (const CLI::ParseError& error) {
    return app_.exit(error) == 0 ? 0 : wrongInput;
  }
  if (root_ && !*root_) return fail(root_->error().text());
  try {
    const auto status = command_ ? command_() : action();
    if (!status) return fail(status.error().text());
    if (std::fflush(stdout) == 0) return *status;
    return fail("standard output: " + std::generic_category().message(errno));
  } catch (const std::system_error& error) {  // fmt's, where nothing can be printed
    return fail(std::string{"standard output: "} + error.what());
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  }
}

int CommandLine::fail(const std::string& what) const {
  std::fflush(stdout);
  std::fprintf(stderr, "%s: %s\n", name_.c_str(), what.c_str());
  return wrongInput;
}

}  // namespace gt
