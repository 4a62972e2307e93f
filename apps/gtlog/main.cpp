#include <fmt/core.h>

#include <algorithm>

#include "commandline/CommandLine.h"
#include "gtlog/Check.h"
#include "gtlog/Export.h"
#include "gtlog/LogList.h"
#include "gtlog/ReplayLog.h"
#include "observer/LogTransfer.h"
#include "robot/logs/ImportNaoLog.h"
#include "robot/logs/NaoLog.h"

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
  std::vector<std::string> solutions;
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

Result<ReplayOptions> replayOptions(const Arguments& arguments) {
  ReplayOptions options{arguments.log};
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
    options.configuration = std::move(*configuration);
  }
  for (const std::string& text : arguments.solutions) {
    const auto at = text.find('=');
    if (at == text.npos) return Error{.field = text, .what = "expected TASK=SOLUTION"};
    options.solutions.push_back({text.substr(0, at), text.substr(at + 1), "", 0});
  }
  return options;
}

Result<int> replay(const Arguments& arguments) {
  auto options = replayOptions(arguments);
  if (!options) return options.error();
  std::vector<Error> left;
  options->warn = [&](const Error& error) { left.push_back(error); };
  const auto topics = replayLog(*options, arguments.out);
  if (!topics) return topics.error();
  for (const ReplayedTopic& topic : *topics) {
    fmt::print("{:24} recorded {:7}, replayed {:7}, ", topic.topic, topic.recorded, topic.replayed);
    if (topic.different == 0)
      fmt::print("{}\n", topic.same() ? "the same" : "the same at the same times");
    else
      fmt::print("{} differ, the first at {:.3f} s\n", topic.different, seconds(*topic.first));
  }
  return reportLeft(left);
}

Result<int> importTo(const Arguments& arguments) {
  const auto left = importNaoLog(arguments.log, arguments.out);
  if (!left) return left.error();
  return reportLeft(*left);
}

void addReplay(CLI::App& command, Arguments& a) {
  command.add_option("log", a.log)->required();
  command.add_option("out", a.out, "The log of what the robot computes now")->required();
  command.add_option("--solution", a.solutions,
                     "Another solution of a task: ImageProcessor=GT2003");
  command.add_option("--layout", a.layout, "Another process layout than the log's");
  auto* config =
      command.add_option("--config", a.config, "Another configuration folder than the log's");
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
