#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/FileDescriptor.h"
#include "measure/Job.h"

namespace gt {

/// Appends results to a file, one line each. Each line is written at once, so that several programs
/// may write to the same file, and a program that is killed loses only unfinished jobs.
class JobResultWriter {
 public:
  /// Opens the file. Starts a new line if the last one is incomplete. An empty path is the standard
  /// output.
  static Result<JobResultWriter> open(const std::string& path);
  /// Writes a result. Thread-safe.
  Result<void> write(const JobResult& result);
  /// Waits until the present line is written. Later results are not written.
  void close();

 private:
  std::string path_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  FileDescriptor file_;
};

/// The results read from files, and the problems of dropped lines.
struct JobResults {
  std::vector<JobResult> results;
  std::vector<Error> warnings;

  /// Adds the results of a file. Incomplete lines are dropped with a warning. A file that is
  /// missing or unreadable is an error.
  Result<void> read(const std::string& path);
};

/// Merges the results of jobs, in any order, to figures in the order of their names, each with its
/// runs in the order of the seeds. A job that was executed twice is counted once; if its results
/// differ, the first one in the order of their text is used, with a warning. Results of several
/// commits, or a figure that was measured with different parameters, are an error.
Result<Figures> merge(JobResults& results);

/// The jobs of a list that have no result.
std::vector<Job> missingJobs(const std::vector<Job>& jobs, const std::vector<JobResult>& results);

}  // namespace gt
