#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "network/Router.h"

namespace {

volatile std::sig_atomic_t stopped = 0;

struct Options {
  std::vector<std::string> robots;
  std::string listen = "127.0.0.1";
  int port = 15000;
  bool release = false;
  bool gameManager = false;
  bool noTeams = false;
  bool verbose = false;
  std::string makeKeys, keys, connectKeys;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("robots", options.robots,
                 "Robots: NAME=ENDPOINT, an address (10.0.1.100), or a subnet and numbers (10.0.1 "
                 "100 101 102 103 200); the first four are a team, the others another");
  app.add_option("--listen", options.listen,
                 "Address on which tools connect; others than loopback need --keys")
      ->capture_default_str();
  app.add_option("--port", options.port,
                 "Robots listen there; tools of the robot with the number N connect to PORT+N, of "
                 "those with a name to PORT+301 and on")
      ->check(CLI::Range(1, 65000))
      ->capture_default_str();
  app.add_flag("--release", options.release, "Only team messages: no ports for tools");
  app.add_flag("--gm,--game-manager", options.gameManager,
               "A port for tools of all robots, such as a game manager: PORT+300");
  app.add_flag("--no-teams", options.noTeams, "No messages between team mates");
  app.add_option("--make-keys", options.makeKeys,
                 "Writes robot.key and tool.key into this folder and ends");
  app.add_option("--keys", options.keys, "robot.key: lets in only tools that hold tool.key");
  app.add_option("--connect-keys", options.connectKeys, "tool.key: for robots that ask for it");
  app.add_flag("--verbose", options.verbose, "Tells every ten seconds what went through");
}

int fail(const gt::Error& error) {
  fmt::print(stderr, "router: {}\n", error.text());
  return 2;
}

gt::Result<std::optional<gt::Keys>> keysOf(const std::string& file) {
  if (file.empty()) return std::optional<gt::Keys>{};
  auto keys = gt::loadKeys(file);
  if (!keys) return keys.error();
  return std::optional{std::move(*keys)};
}

gt::Result<gt::RouterOptions> routerOptions(const Options& options) {
  gt::RouterOptions result;
  auto robots = gt::parseRobots(options.robots, options.listen, options.port);
  if (!robots) return robots.error();
  result.robots = std::move(*robots);
  for (gt::RoutedRobot& robot : result.robots) {
    if (options.release) robot.tools.clear();
    if (options.noTeams) robot.team = 0;
  }
  if (options.gameManager)
    result.all = fmt::format("tcp://{}:{}", options.listen, options.port + 300);
  auto keys = keysOf(options.keys);
  if (!keys) return keys.error();
  result.listenKeys = *keys;
  keys = keysOf(options.connectKeys);
  if (!keys) return keys.error();
  result.connectKeys = *keys;
  return result;
}

void tell(const gt::Router& router) {
  for (const auto& s : router.statistics())
    fmt::print("{}: {}, {} tools; {} messages to tools, {} to the robot, {} dropped, {} rejected\n",
               s.robot, s.connected ? "connected" : "not there", s.tools, s.toTools, s.toRobot,
               s.dropped, s.rejected);
  std::fflush(stdout);
}

}  // namespace

/// Passes messages between robots and tools, and between team mates (report 5.3).
int main(int argc, char** argv) {
  CLI::App app{"Router: passes messages between robots and tools, and between team mates"};
  Options options;
  addOptions(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!options.makeKeys.empty()) {
    const auto made = gt::makeKeys(options.makeKeys);
    if (!made) return fail(made.error());
    fmt::print("Keys: {0}/robot.key for who listens, {0}/tool.key for who connects\n",
               options.makeKeys);
    return 0;
  }
  if (options.robots.empty()) return fail({"", 0, "robots", "there is none to connect to"});

  const auto wanted = routerOptions(options);
  if (!wanted) return fail(wanted.error());
  const auto router = gt::Router::open(*wanted);
  if (!router) return fail(router.error());
  for (const gt::RoutedRobot& robot : wanted->robots)
    fmt::print("{} at {}{}\n", robot.name, robot.robot,
               robot.tools.empty() ? "" : ", tools at " + robot.tools);
  if (!wanted->all.empty()) fmt::print("tools of all robots at {}\n", wanted->all);
  std::fflush(stdout);

  std::signal(SIGTERM, [](int) { stopped = 1; });
  std::signal(SIGINT, [](int) { stopped = 1; });
  for (std::int64_t turns = 1; !stopped; ++turns) {
    (*router)->step(10);
    if (options.verbose && turns % 1000 == 0) tell(**router);
  }
  tell(**router);
  return 0;
}
