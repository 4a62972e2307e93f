#include "Experiments.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "LocalizationPage.h"
#include "measure/JobResults.h"

namespace gt {

const Experiments& experiments() {
  static const Experiments all = [] {
    Experiments list = localizationExperiments();
    for (const auto& experiment : realismExperiments()) list.push_back(experiment);
    for (const auto& experiment : motionExperiments()) list.push_back(experiment);
    for (const auto& experiment : headExperiments()) list.push_back(experiment);
    for (const auto& experiment : challengeExperiments()) list.push_back(experiment);
    for (const auto& experiment : playExperiments()) list.push_back(experiment);
    for (const auto& experiment : calibrationExperiments()) list.push_back(experiment);
    for (const auto& experiment :
         {fidelityExperiment(), goalieExperiment(), showExperiment(), kickExperiment(),
          grabExperiment(), matchExperiment(), soakExperiment(), visionExperiment(),
          visionPlayExperiment(), visionSightExperiment(), collisionExperiment(),
          worldModelExperiment(), rollingExperiment()})
      list.push_back(experiment);
    std::ranges::sort(list, {}, &Experiment::name);
    return list;
  }();
  return all;
}

namespace {

Result<void> writePages(const Figures& figures, const std::filesystem::path& json,
                        const std::string& note) {
  const auto ofLocators = [](const Figure& f) { return f.name.starts_with("localization."); };
  if (std::ranges::none_of(figures.all(), ofLocators)) return {};
  return writeLocalizationPage(std::filesystem::path{json}.replace_extension(".html"), figures,
                               note);
}

}  // namespace

Result<Figures> mergeFiles(const std::vector<std::string>& files, const std::vector<Job>& jobs,
                           const std::string& json, std::vector<Error>& warnings,
                           const std::string& note) {
  JobResults results;
  for (const std::string& file : files)
    if (auto done = results.read(file); !done) return done.error();
  const auto figures = merge(results);
  if (!figures) return figures;
  warnings = std::move(results.warnings);
  for (const Job& job : missingJobs(jobs, results.results))
    warnings.push_back({.field = job.text(), .what = "has no result"});
  if (auto done = figures->write(json); !done) return done.error();
  if (auto done = writePages(*figures, json, note); !done) return done.error();
  return figures;
}

}  // namespace gt
