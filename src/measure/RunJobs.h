#pragma once
#include <functional>

#include "measure/Experiment.h"
#include "measure/JobResults.h"

namespace gt {

/// How jobs are done.
struct RunOptions {
  unsigned threads = 1;
  /// If given, is called before each job, by several threads. Its error is the job's.
  std::function<Result<void>(const Job&)> ready;
  /// Is called, by one thread at a time, when a job was done or failed.
  std::function<void(const Job&, const Result<void>&)> report;
};

/// An error if a job asks for another commit, or for other files of the project: `commit` may be
/// COMMIT+FINGERPRINT, and a job without a fingerprint asks for any files.
Result<void> checkCommit(const Job& job, const std::string& commit);

/// Does one job that is `completed`. An exception that leaves the experiment becomes its error.
Result<JobResult> measureJob(const Job& job, const Experiments& experiments, const DataRoot& root);

/// Does jobs that are `completed`, several at once; those that must be alone come last. Each result
/// is written as soon as its job is done. A job that fails does not keep the others from being
/// done. Returns how many failed, or the error that kept results from being written.
Result<int> runJobs(const std::vector<Job>& jobs, const Experiments& experiments,
                    const DataRoot& root, JobResultWriter& writer, const RunOptions& options);

}  // namespace gt
