#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "Experiments.h"
#include "LocalizationPage.h"

namespace gt {
namespace {

/// 1..10 or a single number.
std::optional<std::vector<std::uint64_t>> parseSeeds(const std::string& text) {
  std::uint64_t first = 0, last = 0;
  char more = 0;
  if (std::sscanf(text.c_str(), "%lu..%lu%c", &first, &last, &more) != 2) {
    if (std::sscanf(text.c_str(), "%lu%c", &first, &more) != 1) return std::nullopt;
    last = first;
  }
  if (last < first || last - first >= 10'000) return std::nullopt;
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
  return seeds;
}

using Experiment = Result<void> (*)(Figures&, const ExperimentOptions&);
const std::map<std::string, Experiment> experiments{{"calibration", measureCalibration},
                                                    {"collisions", measureCollisions},
                                                    {"fidelity", measureFidelity},
                                                    {"localization.goToPoint", measureGoToPoint},
                                                    {"localization.robustness", measureRobustness},
                                                    {"localization.search", measureSearch},
                                                    {"localization.walk", measureWalks},
                                                    {"matches", measureMatches},
                                                    {"soak", measureSoak},
                                                    {"vision", measureVision},
                                                    {"visionplay", measureVisionPlay},
                                                    {"worldmodel", measureWorldModel}};

/// Whether an experiment was asked for, by its name or by that of its group before the point.
bool isWanted(const std::string& name, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& wanted) {
           return name == wanted || name.starts_with(wanted + '.');
         });
}

/// Tells what is wrong with a name that was asked for; nothing if there is such an experiment.
std::string checkName(const std::string& wanted) {
  std::string names;
  for (const auto& [name, measure] : experiments) {
    if (isWanted(name, {wanted})) return {};
    names += ' ' + name;
  }
  return "'" + wanted + "' is none of:" + names;
}

/// Writes the page of the self-locators beside the figures' file, if they were measured.
Result<void> writePages(const Figures& figures, const std::filesystem::path& json) {
  const auto ofLocators = [](const Figure& f) { return f.name.starts_with("localization."); };
  if (std::none_of(figures.all().begin(), figures.all().end(), ofLocators)) return {};
  return writeLocalizationPage(std::filesystem::path{json}.replace_extension(".html"), figures);
}

}  // namespace
}  // namespace gt

/// Reproduces the project's figures of accuracy against the truth, over several seeds.
int main(int argc, char** argv) {
  CLI::App app{"Experiments: accuracy against the truth, over several seeds"};
  std::string seeds = "1..10", json = "out/experiments.json";
  std::vector<std::string> only;
  gt::ExperimentOptions options;
  app.add_option("--seeds", seeds, "A range like 101..110, or one")->capture_default_str();
  app.add_option("--minutes", options.minutes, "Length of a match")->capture_default_str();
  app.add_option("--only", only,
                 "Which experiments, like localization.walk, or groups of them, like "
                 "localization; all if not given")
      ->delimiter(',')
      ->check(gt::checkName);
  app.add_option("--moments", options.moments, "For vision: moments of matches per seed")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_flag("--ceiling", options.ceiling,
               "For the world model: the truth from a camera at the ceiling, not the oracle");
  app.add_option("--ceiling-logs", options.ceilingLogs, "Folder for the logs of that camera");
  app.add_flag("--true-camera", options.trueCamera, "For vision: the true camera pose");
  bool calibrate = false;
  app.add_flag("--calibrate-collisions", calibrate,
               "Only writes the collision detector's thresholds, from walks on these seeds");
  app.add_option("--json", json, "File for the figures")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto parsed = gt::parseSeeds(seeds);
  if (!parsed) {
    fmt::print(stderr, "experiment: --seeds: '{}' is not a range like 1..10\n", seeds);
    return 2;
  }
  options.seeds = *parsed;

  if (calibrate) {
    const auto done = gt::calibrateCollisions(options);
    if (!done) fmt::print(stderr, "experiment: {}\n", done.error().text());
    return done ? 0 : 2;
  }
  gt::Figures figures;
  for (const auto& [name, measure] : gt::experiments)
    if (gt::isWanted(name, only))
      if (const auto done = measure(figures, options); !done) {
        fmt::print(stderr, "experiment: {}\n", done.error().text());
        return 2;
      }
  figures.print();
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path{json}.parent_path(), ignored);
  if (const auto done = gt::writePages(figures, json); !done) {
    fmt::print(stderr, "experiment: {}\n", done.error().text());
    return 2;
  }
  if (figures.write(json)) return 0;
  fmt::print(stderr, "experiment: {} cannot be written\n", json);
  return 2;
}
