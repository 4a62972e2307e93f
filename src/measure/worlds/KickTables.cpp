#include "measure/worlds/KickTables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <set>

#include "base/Hash.h"
#include "base/InParallel.h"
#include "base/UserFolder.h"
#include "simulation/scene/ProfileTable.h"
#include "streams/Config.h"
#include "streams/Json.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::uint64_t, 12> seeds{101, 102, 103, 104, 105, 106,
                                              107, 108, 109, 110, 111, 112};

/// A robot that stands before a ball, with floor, masses and servos of chance.
Result<std::unique_ptr<MovedRobot>> kicker(const std::string& motions, std::uint64_t seed,
                                           const DataRoot& root) {
  auto scene = loadScene(root.path("scenes/match.scene"));
  if (!scene) return scene.error();
  setProfile(*scene, Profile::padova);
  constexpr double variety = 0.1;
  Random random = Random{seed}.fork("dynamics");
  for (double* factor :
       {&scene->dynamics.friction, &scene->dynamics.mass, &scene->dynamics.strength})
    *factor = 1 + variety * random.symmetric();
  scene->fidelity = Fidelity::dynamic;
  scene->game.referee = false;
  scene->robots.resize(1);
  scene->balls.resize(1);
  auto robot = MovedRobot::make(root, *scene, seed, motions);
  if (robot) (*robot)->standUp();
  return robot;
}

Result<KickTable> readTable(const std::string& path) {
  KickTable table;
  if (fs::exists(path))
    if (auto read = readConfig(path, table); !read) return read.error();
  return table;
}

/// The tables of kicks that earlier teams play with, in the order of their names.
Result<std::vector<KickTable>> tablesOfOpponents(const DataRoot& root) {
  std::vector<fs::path> files;
  std::error_code failed;  // then there are none
  for (const auto& entry : fs::directory_iterator{root.path("config/opponents"), failed})
    if (entry.path().extension() == ".cfg") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<KickTable> tables;
  for (const fs::path& file : files) {
    auto table = readTable(file);
    if (!table) return table.error();
    tables.push_back(*std::move(table));
  }
  return tables;
}

/// Names all that a motion does: another one has the same if it asks for the same angles, gains and
/// frames, and goes on in the same way.
std::string nameOf(const MotionNet& net, int motion) {
  Fingerprint sum;
  std::vector<int> nodes;
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    if (net.nodes[i].motion == motion) nodes.push_back(static_cast<int>(i));
  for (const int i : nodes) {
    MotionNet::Node node = net.nodes[static_cast<std::size_t>(i)];
    if (node.kind == MotionNodeKind::transition) {
      // Numbers of nodes and motions depend on the others.
      const MotionNet::Node& target = net.nodes[static_cast<std::size_t>(node.target)];
      sum.add(net.motions[static_cast<std::size_t>(target.motion)].name);
      sum.add(net.motions[static_cast<std::size_t>(node.requested)].name);
      node.target = target.motion == motion ? node.target - nodes.front() : 0;
      node.requested = 0;
    }
    node.motion = 0;
    sum.add(jsonText(node));  // no sentences, as a configuration file has them
  }
  return fmt::format("{:016x}", sum.value());
}

/// The file of the cache for a kick; empty if there is no cache. What the project's table says
/// changes with all that kicks depend on besides their motion.
std::string cacheFile(const std::string& motion, const std::string& made,
                      const KickTable& project) {
  const std::string cache = userFolder(UserFolder::cache);
  if (cache.empty()) return {};
  Fingerprint sum;
  sum.add(made);
  sum.add(kickTableText(project));
  return fmt::format("{}/kicks/{}-{:016x}.cfg", cache, motion, sum.value());
}

}  // namespace

Result<DescribedKick> measureKick(const std::string& motion, const MotionNet& net,
                                  const std::string& motions, const DataRoot& root,
                                  unsigned threads) {
  using Trials = std::vector<GridTrial>;
  const auto measure = [&](std::uint64_t seed, const Trials* near) -> Result<Trials> {
    auto robot = kicker(motions, seed, root);
    if (!robot) return robot.error();
    Random random = Random{seed}.fork(motion);
    return tryGrid(**robot, motion, random, near);
  };
  // Two robots look where it plays balls at all; all of them, how.
  auto looked = inParallel(2, threads, [&](std::size_t i) { return measure(seeds[i], nullptr); });
  Trials near;
  for (auto& trials : looked) {
    if (!trials) return trials.error();
    near.insert(near.end(), trials->begin(), trials->end());
  }
  auto tried =
      inParallel(seeds.size(), threads, [&](std::size_t i) { return measure(seeds[i], &near); });
  Trials all;
  for (auto& trials : tried) {
    if (!trials) return trials.error();
    all.insert(all.end(), trials->begin(), trials->end());
  }
  DescribedKick described = describeKick(motion, all);
  described.kick.made = nameOf(net, net.find(motion));
  return described;
}

Result<KickTable> kicksOfMotions(const MotionNet& net, const ConfigurationPaths& paths,
                                 const DataRoot& root, unsigned threads) {
  const auto own = readTable(paths.config + "/kicks.cfg");
  if (!own) return own.error();
  const auto project = readTable(root.path("config/kicks.cfg"));
  if (!project) return project.error();
  const auto opponents = tablesOfOpponents(root);
  if (!opponents) return opponents.error();
  std::vector<const KickTable*> tables{&*own, &*project};
  std::set<std::string> names;
  for (const KickTable* table : tables)
    for (const KickDescription& kick : table->kicks) names.insert(kick.motion);
  for (const KickTable& table : *opponents) tables.push_back(&table);
  for (std::string& name : kicksIn(paths.motions)) names.insert(std::move(name));
  KickTable kicks;
  for (const std::string& name : names) {
    const int motion = net.find(name);
    if (motion <= 0) continue;
    const std::string made = nameOf(net, motion);
    const KickDescription* known = nullptr;
    for (const KickTable* table : tables)
      if (const auto* kick = table->kickOf(name); !known && kick && kick->made == made)
        known = kick;
    if (known) {
      kicks.kicks.push_back(*known);
      continue;
    }
    const std::string file = cacheFile(name, made, *project);
    if (!file.empty() && fs::exists(file)) {
      const auto cached = readTable(file);
      if (!cached) return cached.error();
      kicks.kicks.insert(kicks.kicks.end(), cached->kicks.begin(), cached->kicks.end());
      continue;
    }
    std::fprintf(stderr, "measuring what the kick %s does, which is in no table as it is\n",
                 name.c_str());
    auto measured = measureKick(name, net, paths.motions, root, threads);
    if (!measured) return measured.error();
    KickTable one;
    if (!measured->kick.places.empty()) one.kicks.push_back(measured->kick);
    kicks.kicks.insert(kicks.kicks.end(), one.kicks.begin(), one.kicks.end());
    // Without a cache it is measured again the next time.
    std::error_code failed;
    if (!file.empty() && (fs::create_directories(fs::path{file}.parent_path(), failed), !failed))
      static_cast<void>(writeFile(file, kickTableText(one)));
  }
  return kicks;
}

std::vector<std::string> kicksIn(const std::string& motions) {
  std::vector<std::string> names;
  std::error_code failed;  // then there are none
  for (const auto& entry : fs::directory_iterator{motions + "/kicks", failed})
    if (entry.path().extension() == ".mof") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

std::string kickTableText(const KickTable& table) {
  std::string text =
      "// What each kick does with a ball, measured in the dynamic fidelity from the approach:\n"
      "// written by `experiment calibrate-kicks`. Motion, and what names all it does (made); the "
      "best place of the ball x, y (mm), the\n"
      "// direction from there (degrees), length (mm), seconds, strike (s), falls (share, around "
      "there); step of the grid (mm);\n"
      "// places: x, y (mm), share of hits, direction, its standard deviation (degrees), length, "
      "its standard deviation (mm)\n";
  for (std::size_t k = 0; k < table.kicks.size(); ++k) {
    const KickDescription& kick = table.kicks[k];
    text += fmt::format(
        "\n[kicks.{}]\nmotion {}\n{}x {:.0f}\ny {:.0f}\ndirection {:.1f}\nlength {:.0f}\n"
        "seconds {:.3f}\nstrike {:.3f}\nfalls {:.4f}\nstep {:.0f}\n",
        k, kick.motion, kick.made.empty() ? "" : "made " + kick.made + "\n", kick.x, kick.y,
        kick.direction, kick.length, kick.seconds, kick.strike, kick.falls, kick.step);
    for (std::size_t i = 0; i < kick.places.size(); ++i) {
      const auto& [x, y, hits, direction, spread, length, deviation] = kick.places[i];
      text += fmt::format("places.{} {:.0f} {:.0f} {:.2f} {:.1f} {:.1f} {:.0f} {:.0f}\n", i, x, y,
                          hits, direction, spread, length, deviation);
    }
  }
  return text;
}

}  // namespace gt
