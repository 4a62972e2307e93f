#include <cstdio>

#include "Check.h"
#include "ConsoleProgram.h"
#include "FaultReport.h"
#include "Layout.h"
#include "Picture.h"
#include "Play.h"
#include "commandline/CommandLine.h"
#include "console/Manual.h"
#include "crash/CrashHandler.h"

namespace {

/// The options that every command has which plays a match.
void addMatchOptions(CLI::App& command, gt::MatchOptions& match) {
  command.add_option("scene", match.scene, "Scene file")->capture_default_str();
  command.add_option("--seed", match.seed, "The same seed gives the same match")
      ->capture_default_str();
  command.add_option("--threads", match.threads, "Worker threads; they do not change the match")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_option("--behavior", match.behavior, "Agents file of the behavior")
      ->capture_default_str();
  command.add_option("--motions", match.motions, "Folder of motion descriptions")
      ->capture_default_str();
  command.add_option("--red", match.red,
                     "Team that plays red: a folder with files of its own in config, behavior and "
                     "motions, a name of the folder teams, or commit:REVISION[:TEAM], whose "
                     "programs are built and cached");
  command.add_option("--blue", match.blue, "Team that plays blue");
  command.add_option("--layout", match.layout, "Process layout of all robots, not the scene's");
  command.add_option("--profile", match.profile, "How far all is from perfect, not the scene's")
      ->check(CLI::IsMember(gt::enumNames<gt::Profile>));
  command.add_option("--fidelity", match.fidelity, "How truly bodies move, not the scene's")
      ->check(CLI::IsMember(gt::enumNames<gt::Fidelity>));
}

void addFoxglove(CLI::App& command, gt::FoxgloveAccess& access) {
  command.add_option("--foxglove", access.endpoint,
                     "Shows the robots to Foxglove and Lichtblick, which connect to "
                     "ws://localhost:PORT; ADDRESS:PORT for viewers on other machines");
  command
      .add_option("--foxglove-origin", access.origins,
                  "Lets in viewers that a browser has loaded from there, as from "
                  "https://app.foxglove.dev, not only from this machine")
      ->allow_extra_args(false)
      ->needs("--foxglove");
}

void addPlay(CLI::App& command, gt::PlayOptions& play) {
  addMatchOptions(command, play.match);
  command
      .add_option("--minutes", play.match.minutes,
                  "Both halves together, instead of what the scene says")
      ->check(CLI::Range(0.01, 1e4));
  command.add_option("--out", play.out, "Folder for the results")->capture_default_str();
  command.add_option("--script", play.script, "Console commands to begin with, one per line");
  command.add_flag("!--no-logs", play.logs, "Do not write the robots' logs");
  command.add_flag(
      "--inputs", play.match.inputs,
      "Log all images without loss, so that other vision can be replayed on them (large)");
  command.add_flag("--strict", play.strict, "Fails if a robot warned of something");
  command.add_flag("--check", play.match.check,
                   "Checks after each tick what always holds, such as that no robot stands inside "
                   "another one; fails if it does not");
  command.add_flag("--real-time", play.realTime, "No faster than the clock");
  command.add_option("--remote", play.remote,
                     "Robots whose processes connect from outside (gtrobot-*), in real time: NAME, "
                     "or NAME=ENDPOINT to listen for them there (red3=tcp://10.0.1.5:5003)");
  command.add_option("--keys", play.keys,
                     "robot.key of router --make-keys: for robots on other machines");
  command.add_option(
      "--game-controller", play.match.gameController,
      "UDP port on which a RoboCup game controller of this machine may lead the game "
      "(its own: 3838); ADDRESS:PORT for those of other machines and that broadcast");
  command.add_option("--sockets", play.match.sockets, "Folder in which they find the simulation");
  addFoxglove(command, play.foxglove);
}

void addConsole(CLI::App& command, gt::ConsoleOptions& console) {
  addMatchOptions(command, console.match);
  command
      .add_option("--minutes", console.match.minutes,
                  "Both halves together, instead of what the scene says")
      ->check(CLI::Range(0.01, 1e4));
  command.add_option("--script", console.scripts, "Scripts to execute instead of what is typed");
  command.add_option("-c,--command", console.commands, "Commands to execute, behind the scripts")
      ->allow_extra_args(false);
  command
      .add_option_function<std::string>("--joystick",
                                        [](const std::string&) {
                                          throw CLI::ValidationError{
                                              "--joystick",
                                              "is gone: the command joystick on reads a joystick"};
                                        })
      ->group("");  // in no help
  addFoxglove(command, console.foxglove);
}

void addPicture(CLI::App& command, gt::PictureOptions& picture) {
  addMatchOptions(command, picture.match);
  command.add_option("--time", picture.time, "When, in seconds after the match's begin")
      ->check(CLI::Range(0.0, 6e5))
      ->capture_default_str();
  command.add_option("--from", picture.from, "Where the camera is: x y z on the field in mm")
      ->capture_default_str();
  command.add_option("--at", picture.at, "Where the camera looks: x y z on the field in mm")
      ->capture_default_str();
  command
      .add_option("--angle", picture.camera.openingAngle,
                  "Opening angle from left to right, degrees")
      ->check(CLI::Range(1, 150))
      ->capture_default_str();
  command.add_option("--width", picture.camera.width, "Pixels")
      ->check(CLI::Range(16, 1920))
      ->capture_default_str();
  command.add_option("--height", picture.camera.height, "Pixels")
      ->check(CLI::Range(16, 1080))
      ->capture_default_str();
  command.add_option("--out", picture.out, "PNG file")->capture_default_str();
}

void addLayout(CLI::App& command, gt::LayoutOptions& layout) {
  command.add_option("layout", layout.layout, "Layout file")->capture_default_str();
  command.add_option("--svg", layout.svg, "Draws into an SVG file, too");
}

void addFaultReport(CLI::App& command, gt::FaultReportOptions& report) {
  command.add_option("results", report.results,
                     "Files and folders that show the fault: results of a match (out/match), logs, "
                     "states");
  command.add_option("--out", report.out, "The file, .tar.gz")->capture_default_str();
  command.add_option("--crash", report.crashes,
                     "Crash reports, instead of the newest one in the user's folder for state");
  command.add_option("--note", report.note, "What went wrong, in a sentence");
}

}  // namespace

/// SimGT2003: plays scenes of simulated robots.
int main(int argc, char** argv) {
  gt::installCrashHandler({"simgt"});
  gt::CommandLine line{argc, argv, "SimGT2003: simulated robots that play soccer"};
  const gt::DataRoot root = line.root();
  const gt::MatchOptions match{root};

  gt::PlayOptions play;
  play.match = match;
  addPlay(line.command("play", "Plays a match and writes logs, match.json and report.html",
                       [&] { return gt::play(play); }),
          play);
  gt::ConsoleOptions console;
  console.match = match;
  addConsole(
      line.command("console",
                   "Runs a scene with a console: commands from scripts, a pipe or the terminal",
                   [&] { return gt::runConsole(console); }),
      console);
  gt::PictureOptions picture;
  picture.match = match;
  addPicture(line.command("picture", "Takes an image of a match from beside the field",
                          [&] { return gt::takePicture(picture); }),
             picture);
  gt::LayoutOptions layout{root.path("layouts/cmd.layout"), ""};
  addLayout(line.command("layout", "Shows what runs in which process and what crosses",
                         [&] { return gt::showLayout(layout); }),
            layout);
  line.command("commands", "Prints the console's commands: docs/console.md", [] {
    std::fputs(gt::consoleManual().c_str(), stdout);
    return 0;
  });
  gt::FaultReportOptions report;
  report.root = root;
  addFaultReport(line.command("fault-report",
                              "Packs what it takes to look into a fault elsewhere into one file",
                              [&] { return gt::packFaultReport(report); }),
                 report);
  gt::CheckOptions check;
  check.root = root.path(".");
  CLI::App& checking = line.command(
      "check",
      "Loads every configuration, team, layout, scene, motion and behavior; reports errors",
      [&] { return gt::checkTree(check); });
  checking.add_option("root", check.root, "Folder of the tree")->capture_default_str();
  checking.add_flag("--strict", check.strict, "Fails because of warnings, too");
  checking.add_option(
      "--fits", check.fits,
      "Only keeps that a file of config/calibrated.cfg fits what it depends on now");
  return line.run();
}
