#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/FileDescriptor.h"
#include "measure/Job.h"

namespace gt {

/// Appends results to a file, one line each. Each line is written at once, so that several
/// programs may write to one file, and a program that is killed loses the jobs under way only.
class JobResultWriter {
 public:
  /// Begins a new line if the last one is not whole. An empty path is the standard output.
  static Result<JobResultWriter> open(const std::string& path);
  /// May be called by several threads.
  Result<void> write(const JobResult& result);
  /// Waits until the line under way is written. Nothing is written any more.
  void close();

 private:
  std::string path_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  FileDescriptor file_;
};

/// Results that were read, and what was wrong with the lines that were dropped.
struct JobResults {
  std::vector<JobResult> results;
  std::vector<Error> warnings;

  /// Adds those of a file. Lines that are not whole are dropped with a warning. A file that is
  /// missing or cannot be read is an error.
  Result<void> read(const std::string& path);
};

/// Merges the results of jobs, in whatever order they come, to figures in the order of their names,
/// each with its runs in the order of the seeds. A job that was done twice counts once; if its
/// results differ, the first in the order of their text counts, with a warning. It is an error if
/// the results are of several commits, or a figure was measured with different parameters.
Result<Figures> merge(JobResults& results);

/// The jobs of a list of which there is no result.
std::vector<Job> missingJobs(const std::vector<Job>& jobs, const std::vector<JobResult>& results);

}  // namespace gt
