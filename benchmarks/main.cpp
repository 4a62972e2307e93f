#include <array>
#include <functional>
#include <string_view>
#include <utility>

#include "LogSpeed.h"
#include "MatchSpeed.h"
#include "Parts.h"
#include "RobotPrograms.h"
#include "benchmarks/streams/Streams.h"
#include "commandline/CommandLine.h"

namespace {

/// What is measured in one piece, by the second word of its figures' names.
gt::Result<void> measure(gt::Figures& figures, const gt::MatchSpeedOptions& options,
                         const std::string& only) {
  using Measure = std::function<gt::Result<void>()>;
  const std::array<std::pair<std::string_view, Measure>, 4> pieces{
      {{"match", [&] { return gt::measureMatchSpeed(figures, options); }},
       {"log", [&] { return gt::measureLogSpeed(figures, options.root); }},
       {"programs", [&] { return gt::measureRobotPrograms(figures, options.root); }},
       {"stream", [&] { return gt::measureStreams(figures), gt::Result<void>{}; }}}};
  bool found = false;
  for (const auto& [piece, measurePiece] : pieces) {
    if (!only.empty() && only != piece) continue;
    found = true;
    if (auto done = measurePiece(); !done) return done;
  }
  if (found && !only.empty()) return {};
  const std::string parts = only.empty() ? "all" : "^speed\\." + only + "([./]|$)";
  if (gt::measureParts(figures, parts, options.root) > 0) return {};
  return gt::Error{.field = "--only", .what = "no figures begin with speed." + only};
}

}  // namespace

/// Measures the speed of whole matches and of the parts of the system.
int main(int argc, char** argv) {
  gt::CommandLine line{argc, argv,
                       "Benchmarks: the speed of whole matches and of the parts of the system"};
  gt::MatchSpeedOptions options{line.root()};
  std::string json = "out/bench.json", only;
  line.app().add_option("--minutes", options.minutes, "Length of a match")->capture_default_str();
  line.app()
      .add_option("--runs", options.runs, "Matches of each kind")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  line.app().add_option(
      "--only", only,
      "Measures one part only, by the second word of its figures' names: match (with module, world "
      "and sensors in it), log, programs, stream, camera, debug, framework, localization, process, "
      "vision, world, xabsl");
  line.app().add_option("--json", json, "File for the figures")->capture_default_str();
  return line.run([&]() -> gt::Result<void> {
    gt::Figures figures;
    if (auto done = measure(figures, options, only); !done) return done;
    figures.print();
    return figures.write(json);
  });
}
