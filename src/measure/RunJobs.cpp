#include "measure/RunJobs.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "base/CrashNotes.h"
#include "measure/InParallel.h"

namespace gt {
namespace {

/// Does jobs and writes what they measured.
class Runner {
 public:
  Runner(const Experiments& experiments, const DataRoot& root, JobResultWriter& writer,
         const RunOptions& options)
      : experiments_{experiments}, root_{root}, writer_{writer}, options_{options} {}

  void run(const std::vector<Job>& jobs, unsigned threads) {
    inParallel(jobs.size(), threads, [&](std::size_t i) {
      finish(jobs[i], guarded([&] { return measure(jobs[i]); }));
      return Result<void>{};
    });
  }
  bool isAlone(const Job& job) const { return experiment(job).alone; }
  Result<int> failed() const {
    if (unwritten_) return *unwritten_;
    return failed_;
  }

 private:
  const Experiment& experiment(const Job& job) const {
    return *findExperiment(experiments_, job.experiment);
  }
  Result<Measurement> measure(const Job& job) const {
    const std::string text = job.text();
    const CrashContext context{text.c_str()};
    auto measurement = experiment(job).measure(job, root_);
    if (!measurement) return measurement;
    for (Measurement::Value& value : measurement->values) {
      if (!std::isfinite(value.value)) return Error{.field = value.name, .what = "is not a number"};
      value.name = nameOf(job, value.name);
    }
    return measurement;
  }
  /// The name of a figure with the values of the parameters that names tell.
  std::string nameOf(const Job& job, std::string figure) const {
    for (const Parameter& parameter : experiment(job).parameters)
      if (const std::string& value = job.parameter(parameter.name);
          parameter.inNames && value != parameter.values.front())
        figure.insert(std::min(figure.find('.'), figure.size()), "." + value);
    return figure;
  }
  void finish(const Job& job, const Result<Measurement>& measurement) {
    const std::lock_guard lock{mutex_};
    Result<void> done;
    if (measurement) {
      done = writer_.write({job, *measurement});
      if (!done) unwritten_ = done.error();
    } else {
      done = measurement.error();
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
