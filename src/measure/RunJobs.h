#pragma once
#include <functional>

#include "measure/Experiment.h"
#include "measure/JobResults.h"

namespace gt {

/// Options for executing jobs.
struct RunOptions {
  unsigned threads = 1;
  /// If set, called before each job, by several threads. If it returns an error, the job fails.
  std::function<Result<void>(const Job&)> ready;
  /// Called when a job was finished or failed, by one thread at a time.
  std::function<void(const Job&, const Result<void>&)> report;
};

/// Returns an error if a job requires another commit, or other files of the project: `commit` may
/// be COMMIT+FINGERPRINT, and a job without a fingerprint accepts any files.
Result<void> checkCommit(const Job& job, const std::string& commit);

/// Executes one job that is `completed`. An exception that is thrown by the experiment becomes an
/// error.
Result<JobResult> measureJob(const Job& job, const Experiments& experiments, const DataRoot& root);

/// Executes jobs that are `completed`, several in parallel; jobs that must run alone are last. Each
/// result is written as soon as its job is finished. The other jobs continue if a job fails.
/// Returns the number of failed jobs, or the error that prevented writing results.
Result<int> runJobs(const std::vector<Job>& jobs, const Experiments& experiments,
                    const DataRoot& root, JobResultWriter& writer, const RunOptions& options);

}  // namespace gt
