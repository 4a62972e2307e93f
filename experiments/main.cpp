#include <fmt/core.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <thread>

#include "Experiments.h"
#include "Tournament.h"
#include "base/EndSignals.h"
#include "base/File.h"
#include "base/InParallel.h"
#include "base/OutputLock.h"
#include "commandline/CommandLine.h"
#include "crash/CrashHandler.h"
#include "measure/RunJobs.h"
#include "robot/ProjectVersion.h"

namespace gt {

namespace {

/// The arguments of the command line; each command uses a part of them.
struct Arguments {
  std::string seeds = "1..10";
  JobSelection selection;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::string json = "out/experiments.json";
  std::vector<std::string> lists, lines, results, teams;
  std::vector<std::string> kicks;
  std::string out, jobs, team;
};

Result<std::vector<Job>> selectedJobs(Arguments arguments, const DataRoot& root) {
  auto seeds = parseSeeds(arguments.seeds);
  if (!seeds) return seeds.error();
  arguments.selection.seeds = *std::move(seeds);
  const auto version = projectVersion(root);
  if (!version) return version.error();
  return listJobs(experiments(), arguments.selection, *version);
}

Result<void> list(const Arguments& arguments, const DataRoot& root) {
  const auto jobs = selectedJobs(arguments, root);
  if (!jobs) return jobs.error();
  for (const Job& job : *jobs) fmt::print("{}\n", job.text());
  return {};
}

Result<void> tournament(const Arguments& arguments, const DataRoot& root) {
  const auto seeds = parseSeeds(arguments.seeds);
  if (!seeds) return seeds.error();
  const auto jobs = listTournament(arguments.teams, *seeds, arguments.selection.settings, root);
  if (!jobs) return jobs.error();
  for (const Job& job : *jobs) fmt::print("{}\n", job.text());
  return {};
}

/// What is still to be done when a signal has come, with a sentence on how far the jobs are.
using AtInterrupt = std::function<Result<void>(const std::string& note)>;

/// How jobs ended: the exit status, and a sentence if some failed.
struct JobsEnd {
  int status = 0;
  std::string note;
};

/// Does jobs and reports each on the standard error. A signal ends the program, without the jobs
/// under way.
Result<JobsEnd> runAll(const std::vector<Job>& jobs, const std::string& out, const DataRoot& root,
                       unsigned threads, const AtInterrupt& atInterrupt) {
  auto writer = JobResultWriter::open(out);
  if (!writer) return writer.error();
  std::atomic<std::size_t> done = 0;
  const EndSignals signals;
  RunOptions options;
  options.threads = threads;
  options.ready = [&](const Job& job) -> Result<void> {
    const auto version = projectVersion(root);
    if (!version) return version.error();
    return checkCommit(job, *version);
  };
  options.report = [&](const Job& job, const Result<void>& result) {
    if (signals.received()) return;
    fmt::print(stderr, "{}/{} {}{}\n", ++done, jobs.size(), job.text(),
               result ? "" : ": " + result.error().text());
  };
  const FileDescriptor allDone{eventfd(0, EFD_CLOEXEC)};
  std::jthread watch{[&] {
    if (signals.waitFor(allDone.number())) return;
    writer->close();
    const std::string note = fmt::format("Interrupted: {} of {} jobs are done.", done, jobs.size());
    const auto ended = guarded([&]() -> Result<void> {
      fmt::print(stderr, "experiment: {}\n", note);
      return atInterrupt(note);
    });
    if (!ended) std::fprintf(stderr, "experiment: %s\n", ended.error().text().c_str());
    std::fflush(stdout);
    std::_Exit(signals.status());  // jobs cannot be stopped
  }};
  const auto failed = runJobs(jobs, experiments(), root, *writer, options);
  const std::uint64_t one = 1;
  static_cast<void>(write(allDone.number(), &one, sizeof one));
  watch.join();
  if (!failed) return failed.error();
  if (*failed == 0) return JobsEnd{};
  fmt::print(stderr, "experiment: {} jobs failed\n", *failed);
  return JobsEnd{2, fmt::format("{} of {} jobs failed.", *failed, jobs.size())};
}

Result<std::string> readList(const std::string& path) {
  if (path != "-") return readFile(path);
  return std::string{std::istreambuf_iterator<char>{std::cin}, {}};
}

/// The jobs of lists and of the command line, each once.
Result<std::vector<Job>> readJobs(const std::vector<std::string>& lists,
                                  const std::vector<std::string>& lines, const DataRoot& root) {
  std::vector<Job> jobs;
  for (const std::string& path : lists) {
    const auto text = readList(path);
    if (!text) return text.error();
    const auto read = parseJobs(*text, path == "-" ? "standard input" : path);
    if (!read) return read.error();
    jobs.insert(jobs.end(), read->begin(), read->end());
  }
  for (const std::string& line : lines) {
    const auto job = parseJob(line);
    if (!job) return job.error();
    jobs.push_back(*job);
  }
  const auto version = projectVersion(root);
  if (!version) return version.error();
  std::set<Job> known;
  std::vector<Job> each;
  for (const Job& job : jobs) {
    const auto whole = completed(job, experiments(), *version);
    if (!whole) return whole.error();
    if (known.insert(*whole).second) each.push_back(*whole);
  }
  return each;
}

void warn(const std::vector<Error>& warnings) {
  for (const Error& warning : warnings)
    fmt::print(stderr, "experiment: warning: {}\n", warning.text());
}

Result<int> run(const Arguments& arguments, const DataRoot& root) {
  auto jobs = readJobs(arguments.lists, arguments.lines, root);
  if (!jobs) return jobs.error();
  if (!arguments.out.empty() && std::filesystem::exists(arguments.out)) {
    JobResults before;
    if (auto done = before.read(arguments.out); !done) return done.error();
    warn(before.warnings);
    const std::size_t all = jobs->size();
    *jobs = missingJobs(*jobs, before.results);
    if (jobs->size() < all)
      fmt::print(stderr, "{}: {} of {} jobs are done\n", arguments.out, all - jobs->size(), all);
  }
  const auto ended = runAll(*jobs, arguments.out, root, arguments.threads, [&](const std::string&) {
    if (!arguments.out.empty())
      fmt::print(stderr, "experiment: the same command does the others\n");
    return Result<void>{};
  });
  if (!ended) return ended.error();
  return ended->status;
}

/// Merges results and prints the figures.
Result<void> mergeAll(const std::vector<std::string>& files, const std::vector<Job>& jobs,
                      const std::string& json, const std::string& note = {}) {
  std::vector<Error> warnings;
  const auto figures = mergeFiles(files, jobs, json, warnings, note);
  if (!figures) return figures.error();
  warn(warnings);
  figures->print();
  return {};
}

Result<void> mergeResults(const Arguments& arguments, const DataRoot& root) {
  std::vector<Job> jobs;
  if (!arguments.jobs.empty()) {
    auto read = readJobs({arguments.jobs}, {}, root);
    if (!read) return read.error();
    jobs = *std::move(read);
  }
  return mergeAll(arguments.results, jobs, arguments.json);
}

/// Lists, runs and merges; merges what there is also if jobs failed or a signal came.
Result<int> measure(const Arguments& arguments, const DataRoot& root) {
  const auto jobs = selectedJobs(arguments, root);
  if (!jobs) return jobs.error();
  const std::filesystem::path results =
      std::filesystem::path{arguments.json}.replace_extension(".jsonl");
  std::error_code ignored;  // then writing reports what is wrong
  std::filesystem::create_directories(results.parent_path(), ignored);
  const auto lock = OutputLock::ofFile(results.string());
  if (!lock) return lock.error();
  std::filesystem::resize_file(results, 0, ignored);
  const auto mergeDone = [&](const std::vector<Job>& wanted,
                             const std::string& note) -> Result<void> {
    if (std::filesystem::is_empty(results, ignored)) return {};
    return mergeAll({results.string()}, wanted, arguments.json, note);
  };
  const auto ended = runAll(*jobs, results.string(), root, arguments.threads,
                            [&](const std::string& note) { return mergeDone({}, note); });
  const auto merged = mergeDone(*jobs, ended ? ended->note : ended.error().text());
  if (!ended || !merged) return ended ? merged.error() : ended.error();
  return ended->status;
}

Result<void> calibrate(const Arguments& arguments, const DataRoot& root,
                       decltype(calibrateCollisions) fit) {
  const auto seeds = parseSeeds(arguments.seeds);
  if (!seeds) return seeds.error();
  return fit(*seeds, root, arguments.threads);
}

/// Experiments, their parameters and values, for --help.
std::string catalogue() {
  std::string text = "Experiments and their parameters:\n";
  for (const Experiment& experiment : experiments()) {
    text += fmt::format("  {:<33} {}\n", experiment.name, experiment.description);
    for (const Parameter& parameter : experiment.parameters) {
      const bool open =
          parameter.kind == Parameter::Kind::number || parameter.kind == Parameter::Kind::text;
      std::string values;
      for (const std::string& value : parameter.values)
        values += (values.empty() ? "" : "|") + value;
      text += fmt::format("    {:<31} {}{}{}\n", parameter.name, parameter.description,
                          open ? "; by default " : ": ", values);
    }
  }
  return text;
}

void addSelection(CLI::App& app, Arguments& a) {
  app.add_option("--seeds", a.seeds, "A range like 101..110, or one")->capture_default_str();
  app.add_option("--only", a.selection.only,
                 "Which experiments, like localization.walk, or groups of them, like "
                 "localization; all if not given")
      ->delimiter(',');
  app.add_option("--set", a.selection.settings,
                 "NAME=VALUE: the value of a parameter, of all experiments that have it");
  app.add_option("--threads", a.threads, "Jobs at once; they do not change what is measured")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--json", a.json, "File for the figures; the results of the jobs lie beside it")
      ->capture_default_str();
}

void addCommands(CommandLine& line, Arguments& a, const DataRoot& root) {
  line.command("list", "Prints the jobs, one a line", [&] { return list(a, root); });
  CLI::App& playing =
      line.command("tournament", "Prints the jobs of a tournament: all teams against all",
                   [&] { return tournament(a, root); });
  playing.add_option("teams", a.teams, "Folders, names of the folder teams, or GT2003")->required();
  CLI::App& running = line.command("run", "Does jobs and appends a line of JSON for each",
                                   [&] { return run(a, root); });
  running.add_option("lists", a.lists, "Files with jobs, one a line; - is the standard input");
  running.add_option("--job", a.lines, "A job: 'match minutes=10 seed=7'");
  running.add_option("--out", a.out,
                     "File for the results, to which they are appended; jobs that are done there "
                     "are not done again; by default the standard output");
  CLI::App& merging = line.command("merge", "Makes figures of the results of jobs",
                                   [&] { return mergeResults(a, root); });
  merging.add_option("results", a.results, "Files with results")->required();
  merging.add_option("--jobs", a.jobs, "A list of jobs, to report those that have no result");
  line.command("calibrate-collisions",
               "Fits the collision detectors to the walks, and writes their configuration",
               [&] { return calibrate(a, root, calibrateCollisions); });
  line.command("calibrate-posture",
               "Fits how bodies lean on legs that give to the walks, and writes the configuration",
               [&] { return calibrate(a, root, calibratePosture); });
  CLI::App& kicks =
      line.command("calibrate-kicks", "Measures what kicks do, and writes their table",
                   [&] { return calibrateKicks(a.kicks, a.team, root, a.threads); });
  kicks.add_option("kicks", a.kicks, "Some of them; all, if none is named");
  kicks.add_option(
      "--team", a.team,
      "Whose: a folder, a name of the folder teams, or commit:REVISION, whose table is "
      "kept in config/opponents");
}

}  // namespace
}  // namespace gt

/// Reproduces the project's figures of accuracy against the truth, over several seeds.
int main(int argc, char** argv) {
  gt::installCrashHandler({"experiment"});
  gt::CommandLine line{argc, argv,
                       "Experiments: accuracy against the truth, over several seeds. Without a "
                       "command: lists the jobs, runs them and merges their results"};
  const gt::DataRoot root = line.root();
  gt::Arguments arguments;
  gt::addSelection(line.app(), arguments);
  gt::addCommands(line, arguments, root);
  line.app().footer(gt::catalogue());
  return line.run([&] { return gt::measure(arguments, root); });
}
