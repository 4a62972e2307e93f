#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>

#include "LogSpeed.h"
#include "MatchSpeed.h"
#include "Parts.h"
#include "RobotPrograms.h"
#include "benchmarks/streams/Streams.h"

/// Measures the speed of whole matches and of the parts of the system.
int main(int argc, char** argv) {
  CLI::App app{"Benchmarks: the speed of whole matches and of the parts of the system"};
  std::string json = "out/bench.json";
  gt::MatchSpeedOptions options;
  app.add_option("--minutes", options.minutes, "Length of a match")->capture_default_str();
  app.add_option("--runs", options.runs, "Matches of each kind")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  std::string only;
  app.add_option("--only", only,
                 "Measures but one part: matches, logs, streams, programs, parts, or of these "
                 "camera, localization or vision")
      ->check(CLI::IsMember(
          {"matches", "logs", "streams", "programs", "parts", "camera", "localization", "vision"}));
  app.add_option("--json", json, "File for the figures")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  gt::Figures figures;
  using Measure = std::function<gt::Result<void>()>;
  const std::vector<std::pair<std::string_view, Measure>> parts{
      {"matches", [&] { return gt::measureMatchSpeed(figures, options); }},
      {"logs", [&] { return gt::measureLogSpeed(figures); }},
      {"programs", [&] { return gt::measureRobotPrograms(figures); }},
      {"streams", [&] { return gt::measureStreams(figures), gt::Result<void>{}; }},
      {"parts", [&] { return gt::measureParts(figures, "all"), gt::Result<void>{}; }}};
  for (const auto& [part, measure] : parts) {
    if (!only.empty() && only != part) continue;
    if (const auto done = measure(); !done) {
      fmt::print(stderr, "bench: {}\n", done.error().text());
      return 2;
    }
  }
  if (only == "camera" || only == "localization" || only == "vision")
    gt::measureParts(figures, "^speed\\." + only);
  figures.addRatio("speed.vision.blackWhiteBall.ofOpenCv", "speed.vision.blackWhiteBall",
                   "speed.vision.blackWhiteBall.opencv", gt::Aim::atMost(0.1));
  figures.print();
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path{json}.parent_path(), ignored);
  if (figures.write(json)) return 0;
  fmt::print(stderr, "bench: {} cannot be written\n", json);
  return 2;
}
