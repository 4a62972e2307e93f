#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "colors/ColorOrder.h"
#include "commandline/CommandLine.h"
#include "gtlog/Check.h"
#include "gtlog/Export.h"
#include "gtlog/LogList.h"
#include "gtlog/ReplayLog.h"
#include "gtlog/SolutionErrors.h"
#include "logs/ImportNaoLog.h"
#include "logs/LogTransfer.h"
#include "logs/NaoLog.h"

namespace {

using namespace gt;

/// The arguments of the commands; each uses its part.
struct Arguments {
  std::vector<std::string> logs;
  std::string log, out;
  Selection selection;
  std::uint64_t limit = 0;
  std::string layout, config, colors;
  bool naoColors = false;
  std::vector<std::string> solutions, tolerances;
  std::string compared;
  bool wholeRobot = false;
};

void addSelection(CLI::App& command, Selection& selection) {
  command.add_option("--topic", selection.topics, "Only these topics");
  command.add_option("--without", selection.without, "Not these topics");
  command.add_option("--from", selection.from, "From this second of the log");
  command.add_option("--to", selection.to, "Up to this second of the log");
}

/// A line for each thing that was left out; the status of a program that left something out.
int reportLeft(const std::vector<Error>& left) {
  std::fflush(stdout);
  for (const Error& error : left) fmt::print(stderr, "gtlog: {}\n", error.text());
  return left.empty() ? 0 : 2;
}

/// A log of 2009 is no log of ours yet.
Result<int> orHint(Result<int> done) {
  if (done || !isNaoLog(done.error().file)) return done;
  Error error = done.error();
  error.what += "; it is a real robot's log of 2009, which gtlog import converts";
  return error;
}

Result<int> list(const Arguments& arguments) {
  int status = 0;
  for (const std::string& path : arguments.logs) {
    std::vector<Error> damage;
    const auto text = describeLog(path, damage);
    if (!text) return text.error();
    fmt::print("{}", *text);
    status = std::max(status, reportLeft(damage));
  }
  return status;
}

Result<int> show(const Arguments& arguments) {
  const auto left =
      exportJson(arguments.log, arguments.selection, stdout, "standard output", arguments.limit);
  if (!left) return left.error();
  return reportLeft(*left);
}

Result<int> check(const Arguments& arguments) {
  int status = 0;
  for (const std::string& path : arguments.logs) {
    const auto found = checkLog(path);
    if (!found) return found.error();
    for (const Error& channel : found->unchecked)
      fmt::print("{}, so its messages are not checked\n", channel.text());
    if (found->problems.empty())
      fmt::print("{}: {} messages, all checks passed\n", path, found->messages);
    status = std::max(status, reportLeft(found->problems));
  }
  return status;
}

Result<int> report(const Result<Transferred>& done, const std::string& to) {
  if (!done) return done.error();
  fmt::print("{}: {} messages\n", to, done->messages);
  return reportLeft(done->lost);
}

Result<int> exportTo(const Arguments& arguments) {
  const auto left = exportLog(arguments.log, arguments.selection, arguments.out);
  if (!left) return left.error();
  return reportLeft(*left);
}

/// Splits TASK=SOLUTION.
Result<std::pair<std::string, std::string>> taskAndSolution(const std::string& text,
                                                            const char* expected) {
  const auto at = text.find('=');
  if (at == text.npos || at == 0 || at + 1 == text.size())
    return Error{.field = text, .what = std::string{"expected "} + expected};
  return std::pair{text.substr(0, at), text.substr(at + 1)};
}

Result<ReplayOptions> replayOptions(const Arguments& arguments) {
  ReplayOptions options{arguments.log};
  options.wholeRobot = arguments.wholeRobot;
  options.layout = arguments.layout;
  if (!arguments.config.empty()) {
    const auto root = DataRoot::find(DataRoot::places(""));
    if (!root) return root.error();
    ConfigurationPaths paths = ConfigurationPaths::in(*root);
    paths.config = arguments.config;
    paths.colorTable = arguments.colors;
    if (arguments.naoColors) paths.colorOrder = nao2009ColorOrder;
    auto configuration = loadConfiguration(paths);
    if (!configuration) return configuration.error();
    const auto* colors = (*configuration)->find<ColorTable64>();
    if (!paths.colorTable.empty() && colors) {
      const std::string doubt =
          doubtOfOrder(*colors, paths.colorTable, arguments.naoColors,
                       arguments.naoColors ? "without --nao2009-colors" : "--nao2009-colors");
      if (!doubt.empty()) fmt::print(stderr, "gtlog: warning: {}\n", doubt);
    }
    options.configuration = std::move(*configuration);
  }
  for (const std::string& text : arguments.solutions) {
    const auto choice = taskAndSolution(text, "TASK=SOLUTION");
    if (!choice) return choice.error();
    options.solutions.push_back({choice->first, choice->second, "", 0});
  }
  return options;
}

/// Prints how wrong the robot is with each of some solutions.
Result<int> compare(const Arguments& arguments, const ReplayOptions& options) {
  const auto choice = taskAndSolution(arguments.compared, "TASK=SOLUTION,SOLUTION,...");
  if (!choice) return choice.error();
  std::vector<std::string> names;
  std::istringstream list{choice->second};
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  const auto errors = compareSolutions(options, choice->first, names);
  if (!errors) return errors.error();
  fmt::print("{}", tableOf(choice->first, *errors));
  return 0;
}

/// 1 if something differs that may not.
Result<int> replay(const Arguments& arguments) {
  auto options = replayOptions(arguments);
  if (!options) return options.error();
  if (!arguments.compared.empty()) return compare(arguments, *options);
  if (arguments.out.empty())
    return Error{.field = "out", .what = "expected a name for the log of what the robot computes"};
  std::vector<Tolerance> tolerances;
  for (const std::string& text : arguments.tolerances) {
    auto tolerance = parseTolerance(text);
    if (!tolerance) return tolerance.error();
    tolerances.push_back(std::move(*tolerance));
  }
  std::vector<Error> left;
  options->warn = [&](const Error& error) { left.push_back(error); };
  const auto report = replayLog(*options, arguments.out, tolerances);
  if (!report) return report.error();
  fmt::print("{}", report->text());
  const int status = reportLeft(left);
  return status != 0 || report->within() ? status : 1;
}

Result<int> importTo(const Arguments& arguments) {
  const auto left = importNaoLog(arguments.log, arguments.out);
  if (!left) return left.error();
  return reportLeft(*left);
}

void addReplay(CLI::App& command, Arguments& a) {
  command.add_option("log", a.log)->required();
  auto* out = command.add_option("out", a.out, "The log of what the robot computes now");
  command.add_option("--solution", a.solutions,
                     "Another solution of a task, on what was recorded: ImageProcessor=GT2003");
  command.add_flag("--whole-robot", a.wholeRobot,
                   "With another solution or configuration the robot decides anew, too, and its "
                   "odometry is that of another walk");
  auto* within = command.add_option(
      "--within", a.tolerances,
      "How much numbers may differ, or inf for anything: RobotPose.pose.translation=5. Exit status "
      "1 if more does");
  command
      .add_option("--solutions", a.compared,
                  "Prints how far off the recorded truth the robot is with each of these: "
                  "SelfLocator=Kalman,MonteCarlo")
      ->excludes(out)
      ->excludes(within);
  command.add_option("--layout", a.layout, "Another process layout than the log's");
  auto* config = command.add_option(
      "--config", a.config, "Another configuration folder than the log's, on what was recorded");
  command.add_option("--colors", a.colors, "Another color table than the folder's")->needs(config);
  command
      .add_flag("--nao2009-colors", a.naoColors, "Its classes are those of the real robot of 2009")
      ->needs(config);
}

/// What one command reads and writes.
CLI::App& fromTo(CLI::App& command, Arguments& a) {
  command.add_option("log", a.log)->required();
  command.add_option("out", a.out)->required();
  return command;
}

void addReading(CommandLine& line, Arguments& a) {
  line.command("list", "Reports what is in logs: channels, counts, rates, times, metadata",
               [&a] { return orHint(list(a)); })
      .add_option("logs", a.logs)
      ->required();
  CLI::App& showing =
      line.command("show", "Prints messages, one on each line", [&a] { return orHint(show(a)); });
  showing.add_option("log", a.log)->required();
  showing.add_option("--limit", a.limit, "Not more than so many");
  addSelection(showing, a.selection);
  line.command("check", "Reads all of logs: index, checksums, and every message by its schema",
               [&a] { return orHint(check(a)); })
      .add_option("logs", a.logs)
      ->required();
  addSelection(
      fromTo(
          line.command(
              "export",
              "Writes messages as JSON lines (OUT.json), CSV (OUT.csv, one topic), a trace of the "
              "behavior (OUT.trace, for xabsl trace), or into a folder of CSV files",
              [&a] { return orHint(exportTo(a)); }),
          a),
      a.selection);
}

void addWriting(CommandLine& line, Arguments& a) {
  addSelection(
      fromTo(
          line.command("cut", "Writes some of a log's messages into a new one",
                       [&a] { return orHint(report(cutLog(a.log, a.selection, a.out), a.out)); }),
          a),
      a.selection);
  CLI::App& joining = line.command("join", "Joins logs into one, in the order of time",
                                   [&a] { return orHint(report(joinLogs(a.logs, a.out), a.out)); });
  joining.add_option("out", a.out, "The new log")->required();
  joining.add_option("logs", a.logs)->required();
  fromTo(line.command("repair", "Writes what is whole in a damaged log into a new one",
                      [&a] { return orHint(report(repairLog(a.log, a.out), a.out)); }),
         a);
  addReplay(line.command("replay",
                         "Has a robot live on what a log's robot sensed, and compares what it "
                         "computes",
                         [&a] { return orHint(replay(a)); }),
            a);
  fromTo(line.command("import", "Writes a real robot's log of 2009 as a log of ours",
                      [&a] { return importTo(a); }),
         a);
}

}  // namespace

/// gtlog: what is to be done with logs.
int main(int argc, char** argv) {
  CommandLine line{argc, argv, "Logs of robots: MCAP files, which Foxglove and ROS 2 open, too"};
  Arguments arguments;
  addReading(line, arguments);
  addWriting(line, arguments);
  return line.run();
}
