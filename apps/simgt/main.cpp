#include <CLI/CLI.hpp>

#include "Play.h"

/// SimGT2003: plays scenes of simulated robots.
int main(int argc, char** argv) {
  CLI::App app{"SimGT2003: simulated robots that play soccer"};
  app.require_subcommand(1);

  gt::PlayOptions play;
  CLI::App& command =
      *app.add_subcommand("play", "Plays a match and writes logs, match.json and report.html");
  command.add_option("scene", play.match.scene, "Scene file")->capture_default_str();
  command.add_option("--minutes", play.match.minutes, "Both halves together, simulated")
      ->check(CLI::Range(0.01, 1e4))
      ->capture_default_str();
  command.add_option("--seed", play.match.seed, "The same seed gives the same match")
      ->capture_default_str();
  command
      .add_option("--threads", play.match.threads, "Worker threads; they do not change the match")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_option("--out", play.out, "Folder for the results")->capture_default_str();
  command.add_flag("!--no-logs", play.logs, "Do not write the robots' logs");
  command.add_option("--behavior", play.match.behavior, "Agents file of the behavior")
      ->capture_default_str();
  command.add_option("--motions", play.match.motions, "Folder of motion descriptions")
      ->capture_default_str();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return gt::play(play);
}
