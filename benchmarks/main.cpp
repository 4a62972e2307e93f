#include <CLI/CLI.hpp>
#include <filesystem>

#include "LogSpeed.h"
#include "MatchSpeed.h"
#include "Parts.h"
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
  app.add_option("--only", only, "Measures but one part: matches, logs, streams or parts")
      ->check(CLI::IsMember({"matches", "logs", "streams", "parts"}));
  app.add_option("--json", json, "File for the figures")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  gt::Figures figures;
  const auto wanted = [&](std::string_view part) { return only.empty() || only == part; };
  if (wanted("matches"))
    if (const auto done = gt::measureMatchSpeed(figures, options); !done) {
      fmt::print(stderr, "bench: {}\n", done.error().text());
      return 2;
    }
  if (wanted("logs"))
    if (const auto done = gt::measureLogSpeed(figures); !done) {
      fmt::print(stderr, "bench: {}\n", done.error().text());
      return 2;
    }
  if (wanted("streams")) gt::measureStreams(figures);
  if (wanted("parts")) gt::measureParts(figures);
  figures.print();
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path{json}.parent_path(), ignored);
  if (figures.write(json)) return 0;
  fmt::print(stderr, "bench: {} cannot be written\n", json);
  return 2;
}
