#include "measure/RunJobs.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "base/CrashNotes.h"
#include "base/InParallel.h"

namespace gt {
namespace {

const Experiment& experimentOf(const Job& job, const Experiments& experiments) {
  return *findExperiment(experiments, job.experiment);
}

/// The name of a figure with the values of the parameters that names tell.
std::string nameOf(const Job& job, const Experiment& experiment, std::string figure) {
  for (const Parameter& parameter : experiment.parameters)
    if (const std::string& value = job.parameter(parameter.name);
        parameter.inNames && value != parameter.values.front())
      figure.insert(std::min(figure.find('.'), figure.size()), "." + value);
  return figure;
}

Result<Measurement> measure(const Job& job, const Experiment& experiment, const DataRoot& root) {
  const std::string text = job.text();
  const CrashContext context{text.c_str()};
  auto measurement = experiment.measure(job, root);
  if (!measurement) return measurement;
  for (Measurement::Value& value : measurement->values) {
    if (!std::isfinite(value.value)) return Error{.field = value.name, .what = "is not a number"};
    value.name = nameOf(job, experiment, value.name);
  }
  return measurement;
}

/// Does jobs and writes what they measured.
class Runner {
 public:
  Runner(const Experiments& experiments, const DataRoot& root, JobResultWriter& writer,
         const RunOptions& options)
      : experiments_{experiments}, root_{root}, writer_{writer}, options_{options} {}

  void run(const std::vector<Job>& jobs, unsigned threads) {
    inParallel(jobs.size(), threads, [&](std::size_t i) {
      const auto ready = isReady(jobs[i]);
      finish(jobs[i], ready ? measureJob(jobs[i], experiments_, root_) : ready.error());
      return Result<void>{};
    });
  }
  bool isAlone(const Job& job) const { return experimentOf(job, experiments_).alone; }
  Result<int> failed() const {
    if (unwritten_) return *unwritten_;
    return failed_;
  }

 private:
  /// A program that crashes meanwhile was at this job, too.
  Result<void> isReady(const Job& job) const {
    if (!options_.ready) return {};
    const std::string text = job.text();
    const CrashContext context{text.c_str()};
    return options_.ready(job);
  }
  void finish(const Job& job, const Result<JobResult>& measured) {
    const std::lock_guard lock{mutex_};
    Result<void> done;
    if (measured) {
      done = writer_.write(*measured);
      if (!done) unwritten_ = done.error();
    } else {
      done = measured.error();
      ++failed_;
    }
    if (options_.report) options_.report(job, done);
  }

  const Experiments& experiments_;
  const DataRoot& root_;
  JobResultWriter& writer_;
  const RunOptions& options_;
  std::mutex mutex_;
  int failed_ = 0;
  std::optional<Error> unwritten_;
};

}  // namespace

Result<void> checkCommit(const Job& job, const std::string& commit) {
  const std::string program = commit.substr(0, commit.find('+'));
  if (job.commit.empty() || job.commit == commit || job.commit == program) return {};
  return Error{.field = job.commit,
               .what = job.commit.starts_with(program + "+")
                           ? "is of other files of the project than there are now, " + commit
                           : "is another commit than this program's, " + commit};
}

Result<JobResult> measureJob(const Job& job, const Experiments& experiments, const DataRoot& root) {
  auto measured = guarded([&] { return measure(job, experimentOf(job, experiments), root); });
  if (!measured) return measured.error();
  return JobResult{job, *std::move(measured)};
}

Result<int> runJobs(const std::vector<Job>& jobs, const Experiments& experiments,
                    const DataRoot& root, JobResultWriter& writer, const RunOptions& options) {
  Runner runner{experiments, root, writer, options};
  std::vector<Job> beside, alone;
  for (const Job& job : jobs) (runner.isAlone(job) ? alone : beside).push_back(job);
  runner.run(beside, options.threads);
  runner.run(alone, 1);
  return runner.failed();
}

}  // namespace gt
