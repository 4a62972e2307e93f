#include <fmt/core.h>

#include "Viewers.h"
#include "base/EndSignals.h"
#include "commandline/CommandLine.h"
#include "network/RobotAddresses.h"
#include "network/RouterSettings.h"
#include "streams/Config.h"

namespace {

void addOptions(CLI::App& app, gt::RouterSettings& settings) {
  app.add_option(
      "robots", settings.robots,
      "Robots: NAME=ENDPOINT, an address (10.0.1.100), a subnet and numbers (10.0.1 100 "
      "101 102 103 200), a subnet in which they are searched for (10.0.1 auto), or auto: "
      "those on this machine. The first four are team A, the next team B; of those "
      "found, whose names differ in the last digit only are a team. Without any "
      "argument: all as the last time");
  app.add_option("--listen", settings.listen,
                 "Address on which tools connect; others than loopback need --keys")
      ->capture_default_str();
  app.add_option("--port", settings.port,
                 "Robots listen there; tools of the robot with the number N connect to PORT+N, of "
                 "those without a number to PORT+301 and on")
      ->check(CLI::Range(1, 65000))
      ->capture_default_str();
  app.add_option("--sockets", settings.sockets, "Folder in which auto finds robots")
      ->capture_default_str();
  app.add_flag("--release", settings.release, "Only team messages: no ports for tools");
  app.add_flag("--gm,--game-manager", settings.gameManager,
               "A port for tools of all robots, such as a game manager: PORT+300");
  app.add_flag("--no-teams", settings.noTeams, "No messages between team mates");
  app.add_option("--team", settings.team, "All robots are of this team, whichever that is");
  app.add_flag("--routers", settings.routers,
               "A port for other routers, whose robots may be of the same teams: PORT+299");
  app.add_option("--join", settings.join,
                 "Another router's port for routers: tcp://10.0.1.1:15299; each two of them "
                 "are joined once")
      ->allow_extra_args(false);
  app.add_option("--keys", settings.keys,
                 "robot.key: lets in only tools and routers that hold tool.key");
  app.add_option("--connect-keys", settings.connectKeys,
                 "tool.key: for robots and routers that ask for it");
  app.add_option("--foxglove", settings.foxglove,
                 "Shows the robots to Foxglove and Lichtblick, which connect to "
                 "ws://localhost:PORT; ADDRESS:PORT for viewers on other machines");
  app.add_option("--foxglove-origin", settings.foxgloveOrigins,
                 "Lets in viewers that a browser has loaded from there, as from "
                 "https://app.foxglove.dev, not only from this machine")
      ->allow_extra_args(false)
      ->needs("--foxglove");
}

/// Starting without arguments is starting as the last time (report 5.3).
gt::Result<void> recall(gt::RouterSettings& settings) {
  const std::string file = gt::lastSettingsFile();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    return gt::Error{.field = "robots",
                     .what = "there is none, and no last time; router --help prints more"};
  return gt::readConfig(file, settings);
}

void keep(const gt::RouterSettings& settings) {
  const std::string file = gt::lastSettingsFile();
  if (file.empty()) return;
  if (const auto done = gt::keepSettings(settings, file); !done)
    fmt::print(stderr, "router: not kept for the next time: {}\n", done.error().text());
}

void report(const gt::RoutedRobot& robot) {
  fmt::print("{} at {}{}{}\n", robot.name, robot.robot,
             robot.tools.empty() ? "" : ", tools at " + robot.tools,
             robot.team.empty() ? "" : ", team " + robot.team);
}

std::string state(const gt::Router::Statistics& s) {
  if (s.connected) return "connected";
  return s.trouble.empty() ? "not there" : "not there (" + s.trouble + ")";
}

void report(const gt::FoxgloveServer& viewers) {
  fmt::print("viewers: {} connected, {} messages dropped\n", viewers.viewers(), viewers.dropped());
  for (const auto& refusal : viewers.refusals())
    fmt::print("viewers: {} not let in: {}\n", refusal.count, refusal.why);
}

void report(const gt::Router& router) {
  for (const auto& s : router.statistics())
    fmt::print("{}: {}, {} tools; {} messages to tools, {} to the robot, {} dropped, {} rejected\n",
               s.robot, state(s), s.tools, s.toTools, s.toRobot, s.dropped, s.rejected);
  for (const auto& [name, refusals] : router.refusals())
    if (const std::string text = gt::describe(refusals); !text.empty())
      fmt::print("{}: {}\n", name, text);
  if (router.routers() > 0) fmt::print("{} other routers\n", router.routers());
  std::fflush(stdout);
}

/// Serves robots that were found.
void serve(gt::Router& router, gt::RobotList& robots, const gt::RouterSettings& settings) {
  for (std::size_t found = robots.find(router.elapsed()); found > 0; --found) {
    const auto robot = settings.wanted(robots.robots()[robots.robots().size() - found]);
    if (const auto done = router.add(robot); !done)
      fmt::print(stderr, "router: {}\n", done.error().text());
    else
      report(robot);
    std::fflush(stdout);
  }
}

/// Passes messages until a signal ends it, as is usual.
gt::Result<void> run(gt::Router& router, gt::RobotList& robots, const gt::RouterSettings& settings,
                     gt::Viewers* viewers, bool verbose) {
  const gt::EndSignals signals;
  const auto reportAll = [&] {
    if (viewers) report(viewers->server());
    report(router);
  };
  std::int64_t reported = 0, looked = 0;
  while (!signals.received()) {
    router.step(10);
    if (robots.searches()) serve(router, robots, settings);
    if (viewers)
      if (auto done = viewers->update(); !done) return done;
    if (router.elapsed() - looked >= 1000) {
      looked = router.elapsed();
      for (const std::string& line : router.takeNews()) fmt::print(stderr, "router: {}\n", line);
    }
    if (viewers)
      for (const std::string& line : viewers->takeNews()) fmt::print(stderr, "router: {}\n", line);
    if (!verbose || router.elapsed() - reported < 10'000) continue;
    reported = router.elapsed();
    reportAll();
  }
  reportAll();
  return {};
}

gt::Result<void> makeKeys(const std::string& folder) {
  if (auto made = gt::makeKeys(folder); !made) return made;
  fmt::print("Keys: {0}/robot.key for who listens, {0}/tool.key for who connects\n", folder);
  return {};
}

gt::Result<void> route(const gt::RouterSettings& settings, bool verbose) {
  auto robots = gt::RobotList::parse(settings.robots, settings.places());
  if (!robots) return robots.error();
  if (robots->robots().empty() && !robots->searches())
    return gt::Error{.field = "robots", .what = "there is none to connect to"};
  auto options = gt::routerOptions(settings);
  if (!options) return options.error();
  for (const gt::RoutedRobot& robot : robots->robots())
    options->robots.push_back(settings.wanted(robot));
  const auto router = gt::Router::open(*options);
  if (!router) return router.error();
  std::unique_ptr<gt::Viewers> viewers;
  if (!settings.foxglove.empty()) {
    auto opened = gt::Viewers::open(**router, settings, *options);
    if (!opened) return opened.error();
    viewers = std::move(*opened);
  }
  keep(settings);
  for (const gt::RoutedRobot& robot : options->robots) report(robot);
  if (!options->all.empty()) fmt::print("tools of all robots at {}\n", options->all);
  if (!options->routers.empty()) fmt::print("other routers at {}\n", options->routers);
  std::fflush(stdout);
  return run(**router, *robots, settings, viewers.get(), verbose);
}

}  // namespace

/// Passes messages between robots and tools, and between teammates (report 5.3).
int main(int argc, char** argv) {
  gt::CommandLine line{argc, argv,
                       "Router: passes messages between robots and tools, and between team mates"};
  gt::RouterSettings settings;
  settings.sockets = gt::defaultSocketFolder();
  addOptions(line.app(), settings);
  std::string keyFolder;
  line.app().add_option("--make-keys", keyFolder,
                        "Writes robot.key and tool.key into this folder and ends");
  bool verbose = false;
  line.app().add_flag("--verbose", verbose, "Reports every ten seconds what went through");
  return line.run([&]() -> gt::Result<void> {
    if (!keyFolder.empty()) return makeKeys(keyFolder);
    if (argc == 1)
      if (auto done = recall(settings); !done) return done;
    return route(settings, verbose);
  });
}
