#include "Jobs.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "Failure.h"
#include "Root.h"
#include "base/Enum.h"
#include "base/OutputLock.h"
#include "experiments/ChangedRoot.h"
#include "experiments/Experiments.h"
#include "experiments/Tournament.h"
#include "match/teams/TeamFolder.h"
#include "measure/RunJobs.h"
#include "robot/ProjectVersion.h"
#include "streams/Json.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

nb::list describeExperiments() {
  nb::list all;
  for (const Experiment& experiment : experiments()) {
    nb::list parameters;
    for (const Parameter& parameter : experiment.parameters)
      parameters.append(nb::make_tuple(parameter.name, parameter.description,
                                       std::string{enumName(parameter.kind)}, parameter.values));
    all.append(nb::make_tuple(experiment.name, experiment.description, parameters));
  }
  return all;
}

std::string versionOf(const std::string& root = "") {
  return orThrow(projectVersion(findRoot(root)));
}

Job jobOf(const std::string& line, const std::string& version) {
  return orThrow(completed(orThrow(parseJob(line)), experiments(), version));
}

std::vector<std::string> textsOf(const std::vector<Job>& jobs) {
  std::vector<std::string> lines;
  for (const Job& job : jobs) lines.push_back(job.text());
  return lines;
}

std::vector<std::string> list(const std::string& seeds, const std::vector<std::string>& only,
                              const std::vector<std::string>& settings) {
  const JobSelection selection{orThrow(parseSeeds(seeds)), only, settings};
  return textsOf(orThrow(listJobs(experiments(), selection, versionOf())));
}

std::vector<std::string> tournament(const std::vector<std::string>& teams, const std::string& seeds,
                                    const std::vector<std::string>& settings) {
  return textsOf(
      orThrow(listTournament(teams, orThrow(parseSeeds(seeds)), settings, findRoot(""))));
}

std::string measure(const std::string& line, const std::string& root) {
  const Job job = jobOf(line, versionOf(root));
  const DataRoot data = findRoot(root);
  const nb::gil_scoped_release release;
  return orThrow(measureJob(job, experiments(), data)).text();
}

std::vector<std::string> texts(const std::vector<Error>& errors) {
  std::vector<std::string> texts;
  for (const Error& error : errors) texts.push_back(error.text());
  return texts;
}

/// The jobs that a file has results of, and the warnings.
auto readResults(const std::string& file) {
  JobResults results;
  orThrow(results.read(file));
  std::vector<std::string> jobs;
  for (const JobResult& result : results.results) jobs.push_back(result.job.text());
  return std::pair{jobs, texts(results.warnings)};
}

std::vector<std::string> mergeResults(const std::vector<std::string>& files,
                                      const std::vector<std::string>& lines,
                                      const std::string& json, const std::string& note) {
  std::vector<Job> jobs;
  const std::string version = versionOf();
  for (const std::string& line : lines) jobs.push_back(jobOf(line, version));
  std::vector<Error> warnings;
  orThrow(mergeFiles(files, jobs, json, warnings, note));
  return texts(warnings);
}

}  // namespace

void bindJobs(nb::module_& module) {
  module.def("_experiments", &describeExperiments);
  module.def("_list_jobs", &list, "seeds"_a, "only"_a, "settings"_a);
  module.def("_list_tournament", &tournament, "teams"_a, "seeds"_a, "settings"_a);
  module.def("_complete_job",
             [](const std::string& line) { return jobOf(line, versionOf()).text(); });
  module.def("_measure_job", &measure, "job"_a, "root"_a);
  module.def("_read_results", &readResults, "file"_a);
  module.def("_result_line",
             [](const std::string& line) { return orThrow(parseJobResult(line)).text(); });
  module.def(
      "_check_json",
      [](const std::string& text, const std::string& file) { orThrow(parseJson(text, file)); },
      "text"_a, "file"_a);
  nb::class_<ChangedRoot>(module, "_ChangedRoot",
                          "A data root with other values, and with a team's files.")
      .def_prop_ro("path", [](const ChangedRoot& changed) { return changed.root().path(""); })
      .def_prop_ro("files", &ChangedRoot::files);
  module.def(
      "_changed_root",
      [](const std::string& values, const std::string& team) {
        return orThrow(ChangedRoot::make(findRoot(""), values, team));
      },
      "values"_a, "team"_a);
  module.def(
      "_team_version",
      [](const std::string& team) { return orThrow(teamVersion(team, findRoot(""))); }, "team"_a);
  module.def("_merge_results", &mergeResults, "files"_a, "jobs"_a, "json"_a, "note"_a);
  nb::class_<OutputLock>(module, "_OutputLock", "Keeps a folder for what one program writes.")
      .def(
          "__init__",
          [](OutputLock* self, const std::string& folder) {
            new (self) OutputLock{orThrow(OutputLock::ofFolder(folder))};
          },
          "folder"_a)
      .def("close", [](OutputLock& self) { const OutputLock over = std::move(self); });
}

}  // namespace gt::python
