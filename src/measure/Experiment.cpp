#include "measure/Experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/Number.h"
#include "measure/RunJobs.h"

namespace gt {
namespace {

/// Whether an experiment was asked for, by its name or by the beginning of it up to a point.
bool isWanted(const std::string& name, const std::string& wanted) {
  return name == wanted || name.starts_with(wanted + '.');
}

Result<void> checkValue(const Parameter& parameter, const std::string& value) {
  if (parameter.kind == Parameter::Kind::text) return {};
  if (parameter.kind == Parameter::Kind::number) {
    const auto number = numberFrom<double>(value);
    if (number && std::isfinite(*number)) return {};
    return Error{.field = parameter.name, .what = "'" + value + "' is not a number"};
  }
  if (std::ranges::find(parameter.values, value) != parameter.values.end()) return {};
  std::string values;
  for (const std::string& v : parameter.values) values += ' ' + v;
  return Error{.field = parameter.name, .what = "'" + value + "' is none of:" + values};
}

/// The jobs of one experiment and seed: a job for each combination of its parameters' values.
void addJobs(const Experiment& experiment, std::uint64_t seed, const std::string& commit,
             const std::map<std::string, std::string>& settings, std::vector<Job>& jobs) {
  std::vector<Job> all{{experiment.name, {}, seed, commit}};
  for (const Parameter& parameter : experiment.parameters) {
    std::vector<std::string> values = parameter.values;
    if (parameter.kind != Parameter::Kind::each) values.resize(1);
    if (const auto set = settings.find(parameter.name); set != settings.end())
      values = {set->second};
    std::vector<Job> extended;
    for (const Job& job : all)
      for (const std::string& value : values) {
        extended.push_back(job);
        extended.back().parameters[parameter.name] = value;
      }
    all = std::move(extended);
  }
  jobs.insert(jobs.end(), all.begin(), all.end());
}

Result<void> checkNames(const Experiments& experiments, const std::vector<std::string>& only) {
  for (const std::string& wanted : only) {
    const auto has = [&](const Experiment& e) { return isWanted(e.name, wanted); };
    if (std::ranges::any_of(experiments, has)) continue;
    std::string names;
    for (const Experiment& e : experiments) names += ' ' + e.name;
    return Error{.field = wanted, .what = "is neither an experiment nor a group of:" + names};
  }
  return {};
}

}  // namespace

Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text) {
  constexpr std::uint64_t most = 10'000;
  std::uint64_t first = 0, last = 0;
  char more = 0;
  if (std::sscanf(text.c_str(), "%lu..%lu%c", &first, &last, &more) != 2) {
    if (std::sscanf(text.c_str(), "%lu%c", &first, &more) != 1)
      return Error{.field = "--seeds", .what = "'" + text + "' is not a range like 1..10"};
    last = first;
  }
  if (last < first || last - first >= most)
    return Error{.field = "--seeds", .what = "'" + text + "' are not 1 to 10000 seeds"};
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t i = 0; i <= last - first; ++i) seeds.push_back(first + i);
  return seeds;
}

Result<std::vector<Job>> listJobs(const Experiments& experiments, const JobSelection& selection,
                                  const std::string& commit) {
  if (auto done = checkNames(experiments, selection.only); !done) return done.error();
  std::map<std::string, std::string> settings;
  for (const std::string& setting : selection.settings) {
    const auto parsed = parseJob("settings " + setting);
    if (!parsed || parsed->parameters.size() != 1)
      return Error{.field = setting, .what = "expected NAME=VALUE of a parameter"};
    settings.insert(*parsed->parameters.begin());
  }
  std::vector<Job> jobs;
  std::map<std::string, std::string> unused = settings;
  for (const Experiment& experiment : experiments) {
    const auto wanted = [&](const std::string& name) { return isWanted(experiment.name, name); };
    if (!selection.only.empty() && std::ranges::none_of(selection.only, wanted)) continue;
    for (const Parameter& parameter : experiment.parameters) unused.erase(parameter.name);
    for (const std::uint64_t seed : selection.seeds) {
      addJobs(experiment, seed, commit, settings, jobs);
      if (experiment.once) break;
    }
  }
  if (!unused.empty())
    return Error{.field = unused.begin()->first,
                 .what = "is a parameter of none of the experiments"};
  for (const Job& job : jobs)
    if (auto checked = completed(job, experiments, commit); !checked) return checked.error();
  return jobs;
}

const Experiment* findExperiment(const Experiments& experiments, const std::string& name) {
  const auto found = std::ranges::find(experiments, name, &Experiment::name);
  return found == experiments.end() ? nullptr : &*found;
}

Result<Job> completed(Job job, const Experiments& experiments, const std::string& commit) {
  const Experiment* experiment = findExperiment(experiments, job.experiment);
  if (!experiment) return Error{.field = job.experiment, .what = "there is no such experiment"};
  if (auto done = checkCommit(job, commit); !done) return done.error();
  job.commit = commit;
  for (const auto& [name, value] : job.parameters) {
    const auto parameter = std::ranges::find(experiment->parameters, name, &Parameter::name);
    if (parameter == experiment->parameters.end())
      return Error{.field = name, .what = "is not a parameter of " + job.experiment};
    if (auto done = checkValue(*parameter, value); !done) return done.error();
  }
  for (const Parameter& parameter : experiment->parameters)
    job.parameters.emplace(parameter.name, parameter.values.front());
  return job;
}

}  // namespace gt
