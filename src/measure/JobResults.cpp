#include "measure/JobResults.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>

#include "base/File.h"
#include "base/Lines.h"

namespace gt {
namespace {

Error systemError(const std::string& path) {
  return {.file = path, .what = std::generic_category().message(errno)};
}

Result<void> writeAll(int file, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const auto written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return systemError(path);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

/// Whether a file has something behind its last line.
bool endsInALine(int file) {
  const auto size = ::lseek(file, 0, SEEK_END);
  char last = '\n';
  return size <= 0 || ::pread(file, &last, 1, size - 1) != 1 || last == '\n';
}

}  // namespace

Result<JobResultWriter> JobResultWriter::open(const std::string& path) {
  JobResultWriter writer;
  writer.path_ = path.empty() ? "standard output" : path;
  if (path.empty()) {
    writer.file_ = FileDescriptor{::dup(STDOUT_FILENO)};
  } else {
    std::error_code ignored;  // then opening reports what is wrong
    std::filesystem::create_directories(std::filesystem::path{path}.parent_path(), ignored);
    writer.file_ =
        FileDescriptor{::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)};
  }
  if (!writer.file_) return systemError(writer.path_);
  if (!path.empty() && !endsInALine(writer.file_.number()))
    if (auto done = writeAll(writer.file_.number(), "\n", path); !done) return done.error();
  return writer;
}

Result<void> JobResultWriter::write(const JobResult& result) {
  const std::string line = result.text() + '\n';
  const std::lock_guard lock{*mutex_};
  if (!file_) return Error{.file = path_, .what = "is closed"};
  return writeAll(file_.number(), line, path_);
}

void JobResultWriter::close() {
  const std::lock_guard lock{*mutex_};
  const FileDescriptor closed = std::move(file_);
}

Result<void> JobResults::read(const std::string& path) {
  const auto text = readFile(path);
  if (!text) return text.error();
  LineReader lines{*text};
  while (const auto line = lines.next()) {
    if (line->empty()) continue;
    auto result = parseJobResult(*line);
    if (result)
      results.push_back(*std::move(result));
    else
      warnings.push_back({.file = path,
                          .line = lines.number(),
                          .what = "is not a whole result, so it is dropped"});
  }
  return {};
}

Result<Figures> merge(JobResults& all) {
  std::vector<std::pair<JobResult, std::string>> results;  // with their text
  for (const JobResult& result : all.results) results.emplace_back(result, result.text());
  std::ranges::sort(results, [](const auto& a, const auto& b) {
    return std::tie(a.first.job, a.second) < std::tie(b.first.job, b.second);
  });
  struct Column {
    std::string unit;
    Aim aim;
    std::vector<double> runs;
    std::vector<std::uint64_t> seeds;
    Job first;
  };
  std::map<std::string, Column> columns;
  const JobResult* last = nullptr;
  for (const auto& [result, text] : results) {
    if (result.job.commit != results.front().first.job.commit)
      return Error{.field = "commit",
                   .what = "results are of " + results.front().first.job.commit + " and of " +
                           result.job.commit};
    if (last && last->job == result.job) {
      if (last->measurement != result.measurement)
        all.warnings.push_back(
            {.field = result.job.text(), .what = "was done twice with different results"});
      continue;
    }
    last = &result;
    for (const Measurement::Value& value : result.measurement.values) {
      const auto [place, isNew] =
          columns.try_emplace(value.name, Column{value.unit, value.aim, {}, {}, result.job});
      Column& column = place->second;
      if (column.first.experiment != result.job.experiment ||
          column.first.parameters != result.job.parameters)
        return Error{.field = value.name,
                     .what = "was measured by '" + column.first.text() + "' and by '" +
                             result.job.text() + "'"};
      column.runs.push_back(value.value);
      column.seeds.push_back(result.job.seed);
    }
  }
  Figures figures;
  for (const auto& [name, column] : columns)
    figures.add(name, column.unit, column.runs, column.aim, column.seeds);
  return figures;
}

std::vector<Job> missingJobs(const std::vector<Job>& jobs, const std::vector<JobResult>& results) {
  std::set<Job> done;
  for (const JobResult& result : results) done.insert(result.job);
  std::vector<Job> missing;
  std::ranges::copy_if(jobs, std::back_inserter(missing),
                       [&](const Job& job) { return !done.contains(job); });
  return missing;
}

}  // namespace gt
