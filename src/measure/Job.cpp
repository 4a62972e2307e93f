#include "measure/Job.h"

#include <sstream>

#include "base/Lines.h"
#include "base/Number.h"
#include "streams/Json.h"

namespace gt {
namespace {

/// The line of JSON of a JobResult.
struct ResultLine {
  std::string job;
  std::vector<Measurement::Value> values;

  static constexpr auto fields() {
    return Fields{field<&ResultLine::job>(), field<&ResultLine::values>()};
  }
};
static_assert(complete<ResultLine>);

}  // namespace

std::string Job::text() const {
  std::string text = experiment;
  for (const auto& [name, value] : parameters) text.append(" ").append(name + "=" + value);
  text += " seed=" + std::to_string(seed);
  return commit.empty() ? text : text + " commit=" + commit;
}

double Job::number(const std::string& name) const {
  return numberFrom<double>(parameter(name)).value_or(0);  // `completed` has looked at it
}

Result<Job> parseJob(std::string_view line) {
  std::istringstream words{std::string{line}};
  Job job;
  if (!(words >> job.experiment)) return Error{.what = "expected an experiment"};
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals == word.npos || equals == 0 || equals + 1 == word.size())
      return Error{.field = word, .what = "expected NAME=VALUE"};
    const std::string name = word.substr(0, equals), value = word.substr(equals + 1);
    if (name == "commit")
      job.commit = value;
    else if (name == "seed") {
      const auto seed = numberFrom<std::uint64_t>(value);
      if (!seed) return Error{.field = word, .what = "expected a whole number"};
      job.seed = *seed;
    } else if (!job.parameters.emplace(name, value).second)
      return Error{.field = word, .what = "is given twice"};
  }
  return job;
}

Result<std::vector<Job>> parseJobs(std::string_view text, const std::string& sourceName) {
  std::vector<Job> jobs;
  LineReader lines{text};
  while (const auto whole = lines.next()) {
    const std::string_view line = trimmed(*whole);
    if (line.empty() || line.front() == '#') continue;
    auto job = parseJob(line);
    if (!job)
      return Error{.file = sourceName,
                   .line = lines.number(),
                   .field = job.error().field,
                   .what = job.error().what};
    jobs.push_back(*std::move(job));
  }
  return jobs;
}

std::string JobResult::text() const {
  return jsonText(ResultLine{job.text(), measurement.values});
}

Result<JobResult> parseJobResult(std::string_view line) {
  ResultLine read;
  if (const auto done = readJson(line, "", read); !done) return done.error();
  auto job = parseJob(read.job);
  if (!job) return job.error();
  return JobResult{*std::move(job), {std::move(read.values)}};
}

}  // namespace gt
