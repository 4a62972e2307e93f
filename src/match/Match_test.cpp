#include "match/Match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "match/TestMatch.h"
#include "representations/perception/CollisionPercept.h"
#include "streams/Config.h"
#include "streams/mcap/Mcap.h"

namespace gt {
namespace {

TEST_F(MatchTest, SameSeedSameBytesWithAnyNumberOfThreads) {
  const auto play = [&](const char* name, std::uint64_t seed, std::size_t threads) {
    return this->play(name, seed, threads, 0.1);
  };
  const auto first = play("first", 3, 1);
  EXPECT_EQ(first.size(), 9u) << "eight logs and the summary";
  for (const auto& [name, bytes] : first) EXPECT_GT(bytes.size(), 1'000u) << name;
  const auto threads = play("threads", 3, 2), other = play("other", 4, 2);
  for (const auto& [name, bytes] : first) {
    // Comparisons without the bytes in the message.
    EXPECT_TRUE(bytes == threads.at(name)) << name;
    EXPECT_FALSE(bytes == other.at(name)) << name << " of another seed";
  }
}

TEST_F(MatchTest, SameSeedSameBytesInEveryProfile) {
  std::map<std::string, std::string> before;
  for (const std::string_view name : enumNames<Profile>) {
    const std::string profile{name};
    const auto play = [&](std::size_t threads) {
      return this->play(profile + std::to_string(threads), 5, threads, 0.05, "scenes/match.scene",
                        profile);
    };
    const auto one = play(1), two = play(2);
    EXPECT_EQ(one.size(), 9u);
    for (const auto& [file, bytes] : one) EXPECT_TRUE(bytes == two.at(file)) << profile << file;
    EXPECT_FALSE(one == before) << profile;
    before = one;
  }
}

TEST_F(MatchTest, WhatCannotBePlayedLeavesTheLogsOfTheMatchBefore) {
  const auto before = play("kept", 3, 1, 0.02);
  MatchOptions options;
  options.logs = (folder / "kept").string();
  options.truth = {"nobody"};
  const auto match = Match::make(options);
  ASSERT_FALSE(match);
  EXPECT_EQ(match.error().field, "nobody");
  for (const auto& [name, bytes] : before) {
    const auto now = readFile((folder / "kept" / name).string());
    EXPECT_TRUE(!now || *now == bytes) << name;  // the summary is no file
  }
}

/// Stands, and performs a kick.
class Kicker : public RobotController {
 public:
  void cycle(const RobotInput&, RobotOutput& output) override {
    output.specialAction = "pushStrong";
  }
};

TEST_F(MatchTest, AKickIsItsMotionAlsoInTheKinematicFidelity) {
  const auto team = folder / "team";
  std::filesystem::create_directories(team / "motions/kicks");
  ASSERT_TRUE(writeFile(team / "motions/kicks/pushStrong.mof",
                        "motion_id = pushStrong\nlabel start\nposture stand  1 150\n"
                        "transition allMotions extern start\n"));
  ASSERT_EQ(setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1), 0);
  MatchOptions options;
  options.red = team;
  const auto match = Match::make(options);
  unsetenv("XDG_CACHE_HOME");
  ASSERT_TRUE(match) << match.error().text();
  KickTable table;
  ASSERT_TRUE(readConfig("config/kicks.cfg", table));
  const KickDescription& kick = *table.kickOf("pushStrong");
  Simulation& simulation = (*match)->simulation();
  const auto speedAfterKickOf = [&](std::size_t robot) {
    const Pose2D pose = simulation.world().robot(robot).pose;
    simulation.attach(robot, std::make_unique<Kicker>());
    simulation.world().placeBall(0, pose * Vector2d{kick.x, kick.y});
    double fastest = 0;
    for (double s = 0; s < kick.strike + 0.1; s += tickSeconds) {
      simulation.step();
      fastest = std::max(fastest, simulation.world().ball(0).speed.norm());
    }
    return fastest;
  };
  EXPECT_EQ(speedAfterKickOf(2), 0) << "red's motion stands still";
  EXPECT_GT(speedAfterKickOf(6), 500) << "blue's is the project's";
}

/// The sample of report 3.6: a robot that sees nothing gets away from whatever it runs into.
TEST_F(MatchTest, ARobotTurnsAwayFromWhatItsLegsBumpInto) {
  MatchOptions options;
  options.scene = "scenes/turn-away.scene";
  options.seed = 1;
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  const RobotBody& body = (*match)->simulation().world().robot(0);
  const Robot& robot = (*match)->robots()[0]->robot();
  int felt = 0, stuck = 0, longest = 0;
  Time last = never();
  for (int tick = 0; tick < 60 * 125; ++tick) {
    (*match)->step();
    const Time collision = robot.provided<CollisionPercept>()->lastCollision;
    felt += collision - last > 1000;
    last = collision;
    stuck = body.blocked ? stuck + 1 : 0;
    longest = std::max(longest, stuck);
  }
  EXPECT_GE(felt, 3);
  EXPECT_GT(body.walked, 5000);
  EXPECT_LT(longest, 3 * 125);
}

/// The report 2.2.3: modules are grouped to processes without a change of their code.
TEST_F(MatchTest, EveryLayoutPlaysTheSameMatch) {
  std::string first;
  for (const char* layout : {"cmd", "single", "pmbm"}) {
    MatchOptions options;
    options.minutes = 0.1;
    options.layout = "layouts/" + std::string{layout} + ".layout";
    const auto match = Match::make(options);
    ASSERT_TRUE(match) << match.error().text();
    ASSERT_TRUE(whistle(**match, ""));
    while (!isPlayed(**match)) (*match)->step();
    const std::string summary = jsonText((*match)->summary());
    if (first.empty()) first = summary;
    EXPECT_TRUE(summary == first) << layout;
  }
  EXPECT_GT(first.size(), 1'000u);
}

/// Layouts change under a running match without a trace: modules keep what they remember.
TEST_F(MatchTest, LayoutsChangeWhileTheMatchGoesOn) {
  const auto play = [&](bool change) {
    MatchOptions options;
    options.minutes = 0.1;
    const auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    EXPECT_TRUE(whistle(**match, ""));
    int ticks = 0;
    while (!isPlayed(**match)) {
      if (change && ++ticks % 50 == 0) {
        const char* name = ticks % 150 == 0   ? "layouts/cmd.layout"
                           : ticks % 100 == 0 ? "layouts/single.layout"
                                              : "layouts/pmbm.layout";
        for (SimulatedRobot* robot : (*match)->robots())
          robot->robot().fromTools().write((*match)->time(), LayoutRequest{name, *readFile(name)});
      }
      (*match)->step();
    }
    return jsonText((*match)->summary());
  };
  EXPECT_TRUE(play(false) == play(true));
}

TEST_F(MatchTest, TheDynamicFidelityIsAsRepeatable) {
  const auto play = [&](const char* name, std::size_t threads) {
    return this->play(name, 3, threads, 0.1, "scenes/dynamic.scene");
  };
  const auto first = play("first", 1), threads = play("threads", 2);
  EXPECT_EQ(first.size(), 9u);
  for (const auto& [name, bytes] : first) EXPECT_TRUE(bytes == threads.at(name)) << name;
}

TEST_F(MatchTest, RobotsPlayAndLogsHoldWhatIsConfigured) {
  if (!wholeMatches) GTEST_SKIP() << "needs a whole match";
  const auto match = make("log", 6, 2, 0.5, "tests/support/short.scene");
  while (!match->finished()) match->step();
  ASSERT_TRUE(match->close());
  const MatchSummary summary = match->summary();
  const double seconds = static_cast<double>(summary.duration.ms) / 1000;
  ASSERT_EQ(summary.robots.size(), 8u);
  double walked = 0, seen = 0;
  for (const RobotSummary& robot : summary.robots) {
    walked += robot.distanceWalked;
    seen += static_cast<double>(robot.ballError.count);
    EXPECT_GT(robot.localizationError.count, 500);
    EXPECT_NEAR(static_cast<double>(robot.samples.size()), seconds, 1);
  }
  EXPECT_GT(walked, 8000);
  EXPECT_GT(seen, 25 * seconds) << "at least one robot in the mean sees the ball";
  EXPECT_FALSE(match->images().empty());
  EXPECT_EQ(summary.events.back().kind, "gameOver");
  const auto log = McapReader::open((folder / "log/red1.mcap").string());
  ASSERT_TRUE(log) << log.error().text();
  std::map<std::string, double> counts;
  for (const McapChannel& channel : log->channels())
    counts[channel.topic] = static_cast<double>(channel.messageCount);
  EXPECT_NEAR(counts["/RobotPose"], 25 * seconds, 1) << "25 a second";
  EXPECT_NEAR(counts["/BallPercept"], 25 * seconds, 1);
  EXPECT_NEAR(counts["/camera"], seconds / 2, 1) << "one in two seconds";
}

TEST_F(MatchTest, TheSceneSaysHowLongAGameLasts) {
  ASSERT_TRUE(writeFile((folder / "short.scene").string(),
                        "<scene config=\"" + std::filesystem::absolute("config").string() +
                            "\" field=\"" +
                            std::filesystem::absolute("models/field2003.xml").string() +
                            "\"><game referee=\"false\" minutes=\"0.01\"/></scene>"));
  MatchOptions options;
  options.scene = (folder / "short.scene").string();
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  while (!(*match)->finished() && (*match)->time() < Time{2000}) (*match)->step();
  EXPECT_EQ((*match)->time(), Time{600});
  EXPECT_EQ((*match)->simulation().referee().parameters().minutes, 0.01);
  for (const double minutes : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    options.minutes = minutes;
    const auto none = Match::make(options);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().field, "minutes");
  }
  options.minutes = 0.02;
  const auto longer = Match::make(options);
  ASSERT_TRUE(longer);
  EXPECT_EQ((*longer)->simulation().referee().parameters().minutes, 0.02);
}

/// A robot whose program failed gets no more images, and the others' are compared as before.
TEST_F(MatchTest, StatisticsGoOnAfterTheFirstRobotFailed) {
  MatchOptions options;
  options.minutes = 1;
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  const auto comparisons = [&](std::size_t robot) {
    return (*match)->summary().robots[robot].localizationError.count;
  };
  for (int i = 0; i < 250; ++i) (*match)->step();
  (*match)->robots().front()->observe(
      [](const MessageQueue&) { throw std::runtime_error{"out of battery"}; });
  (*match)->step();
  const auto failed = comparisons(0), others = comparisons(1);
  EXPECT_GT(failed, 10);
  for (int i = 0; i < 50; ++i) (*match)->step();
  EXPECT_EQ((*match)->simulation().input(0).image, nullptr);
  EXPECT_LE(comparisons(0), failed + 1);
  EXPECT_EQ(comparisons(1), others + 10);
}

/// A team lays its files over the project's, and plays in either color.
TEST_F(MatchTest, TeamsPlayWithFilesOfTheirOwn) {
  const auto write = [&](const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder / name).parent_path());
    ASSERT_TRUE(writeFile((folder / name).string(), text));
  };
  write("same/motions/readme.txt", "none of its own");
  write("still/config/modules.cfg", *readFile("config/modules.cfg") + "WalkingEngine disabled\n");
  const auto play = [&](const std::string& red, const std::string& blue) {
    MatchOptions options;
    options.minutes = 0.1;
    options.seed = 4;
    options.red = red.empty() ? "" : (folder / red).string();
    options.blue = blue.empty() ? "" : (folder / blue).string();
    auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    EXPECT_TRUE(whistle(**match, ""));
    (*match)->note(InterventionKind::console, "");
    while (!isPlayed(**match)) (*match)->step();
    return std::move(*match);
  };
  const auto walked = [](const Match& match, TeamColor team) {
    double sum = 0;
    for (const RobotSummary& robot : match.summary().robots)
      if (robot.team == team) sum += robot.distanceWalked;
    return sum;
  };
  const auto own = play("", ""), same = play("same", "same");
  EXPECT_TRUE(jsonText(own->summary()) == jsonText(same->summary()));
  for (const TeamColor color : {TeamColor::red, TeamColor::blue}) {
    const bool red = color == TeamColor::red;
    const auto match = play(red ? "still" : "", red ? "" : "still");
    EXPECT_LT(walked(*match, color), 1) << "nobody pushes them yet";
    EXPECT_GT(walked(*match, red ? TeamColor::blue : TeamColor::red), wholeMatches ? 500 : -1);
    const std::string file = (folder / "match.state").string();
    ASSERT_TRUE(match->save(file));
    const auto loaded = Match::load(file, {}, whistle);
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_TRUE(jsonText((*loaded)->summary()) == jsonText(match->summary()));
  }
}

/// A robot knows what its body senses, in every layout; the truth only if somebody gave it.
TEST_F(MatchTest, NoRobotGetsTheTruthButThoseThatAreNamed) {
  using Names = std::vector<std::string>;
  const auto told = [](const Names& names, const std::string& layout) {
    MatchOptions options;
    options.truth = names;
    options.layout = "layouts/" + layout + ".layout";
    const auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    while ((*match)->time() < Time{400}) (*match)->step();
    Names knowing;
    for (SimulatedRobot* robot : (*match)->robots())
      if (std::ranges::any_of(robot->robot().processes(), [](const auto& process) {
            Blackboard& blackboard = process->blackboard();
            return blackboard.find("OracledWorldState") &&
                   blackboard.get<OracledWorldState>().time != Time{};
          }))
        knowing.push_back(robot->name());
    EXPECT_EQ((*match)->summary().truth, knowing);
    return knowing;
  };
  for (const char* layout : {"cmd", "single", "pmbm"}) {
    EXPECT_EQ(told({}, layout), Names{}) << layout;
    EXPECT_EQ(told({"red3", "blue"}, layout), (Names{"red3", "blue1", "blue2", "blue3", "blue4"}));
  }
}

/// The log holds it, as the simulator knows it.
TEST_F(MatchTest, LogsHoldTheTruthThatTheirRobotsWereNotGiven) {
  const auto match = make("truth", 5, 1, 0.1);
  std::vector<double> truth, logged;
  while (match->time() < Time{600}) {
    match->step();
    if (match->simulation().input(0).image)
      truth.push_back(match->simulation().input(0).oracle.robotPose.translation.x());
  }
  ASSERT_TRUE(match->close());
  auto log = McapReader::open((folder / "truth/red1.mcap").string());
  ASSERT_TRUE(log) << log.error().text();
  while (const auto message = log->next()) {
    const std::string& topic = log->channel(message->channel)->topic;
    EXPECT_NE(topic, "/input/OracledWorldState");
    if (topic != "/OracledWorldState") continue;
    OracledWorldState state;
    ASSERT_TRUE(decode(message->data, state));
    logged.push_back(state.robotPose.translation.x());
  }
  EXPECT_GT(logged.size(), 10u);
  EXPECT_EQ(logged, truth);
}

/// One line with the team's own file; whoever gives it the truth may play with it.
TEST_F(MatchTest, TeamsThatAskForTheTruthAreRefused) {
  const std::string team = (folder / "asking").string();
  std::filesystem::create_directories(team + "/config");
  ASSERT_TRUE(writeFile(team + "/config/modules.cfg",
                        "SelfLocator Oracled\nBallLocator Oracled\nPlayersLocator Oracled\n"));
  MatchOptions options;
  options.minutes = 0.05;
  options.blue = team;
  const auto refused = Match::make(options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(),
            team +
                "/config/modules.cfg:1: SelfLocator: 'Oracled' reads OracledWorldState, which "
                "this robot does not get");
  options.truth = {"blue"};
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  ASSERT_TRUE(whistle(**match, ""));
  (*match)->note(InterventionKind::console, "");
  while (!isPlayed(**match)) (*match)->step();
  const MatchSummary summary = (*match)->summary();
  EXPECT_EQ(summary.truth, (std::vector<std::string>{"blue1", "blue2", "blue3", "blue4"}));
  for (const RobotSummary& robot : summary.robots) {
    if (robot.team == TeamColor::blue) {
      EXPECT_LT(robot.localizationError.maximum, 20) << robot.name;
    }
  }
  const std::string file = (folder / "match.state").string();
  ASSERT_TRUE((*match)->save(file));
  const auto loaded = Match::load(file, {}, whistle);
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_TRUE(jsonText((*loaded)->summary()) == jsonText(summary));
}

/// Who is told the truth and does not ask for it plays as before: nothing else hangs on it.
TEST_F(MatchTest, TheTruthChangesNothingWhereNobodyAsksForIt) {
  const auto play = [&](bool give) {
    MatchOptions options;
    options.minutes = 0.1;
    const auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    EXPECT_TRUE(whistle(**match, ""));
    while (!isPlayed(**match)) {
      if (give && (*match)->time() == Time{400}) {
        for (SimulatedRobot* robot : (*match)->robots()) EXPECT_TRUE(robot->giveTruth(true));
      }
      (*match)->step();
    }
    MatchSummary summary = (*match)->summary();
    EXPECT_EQ(summary.truth.size(), give ? 8u : 0u);
    summary.truth.clear();
    return jsonText(summary);
  };
  EXPECT_TRUE(play(false) == play(true));
}

TEST_F(MatchTest, WrongFilesAreToldInOneLine) {
  const auto errorOf = [](const MatchOptions& options) {
    const auto match = Match::make(options);
    return match ? std::string{"no error"} : match.error().text();
  };
  MatchOptions options;
  options.scene = "scenes/nowhere.scene";
  EXPECT_NE(errorOf(options).find("scenes/nowhere.scene"), std::string::npos);
  options = {};
  options.motions = "nowhere";
  EXPECT_NE(errorOf(options).find("nowhere"), std::string::npos);
  options = {};
  options.behavior = "behavior/nowhere.xabsl";
  EXPECT_NE(errorOf(options).find("nowhere.xabsl"), std::string::npos);
  options = {};
  options.truth = {"red1", "red7"};
  EXPECT_EQ(errorOf(options), options.scene + ": red7: the scene has no such robot or team");
  options.truth = {"red"};
  options.remote = {{"red2", ""}};
  options.sockets = (folder / "sockets").string();
  EXPECT_EQ(errorOf(options),
            options.scene + ": red2: runs in another program, which cannot be given the truth");
}

/// A module that throws, as when there is not enough memory: its robot stands, the others play, and
/// all that the match leaves says so.
TEST_F(MatchTest, ARobotThatThrowsStandsAndIsNamed) {
  const auto match = make("throws", 3, 2, 0.1);
  ASSERT_TRUE(whistle(*match, ""));
  match->robots()[1]->observe([&](const MessageQueue&) {
    if (match->time() >= Time{1000}) throw std::runtime_error{"a module"};
  });
  EXPECT_TRUE(match->soundness());
  while (!isPlayed(*match)) match->step();
  EXPECT_TRUE(match->teamFailure()) << "the others play on";
  EXPECT_EQ(match->time(), Time{6000});
  ASSERT_EQ(match->failures().size(), 1u);
  const std::string error = "red2: its program failed: exception: a module";
  ASSERT_FALSE(match->soundness());
  EXPECT_EQ(match->soundness().error().text(), error);
  const MatchSummary summary = match->summary();
  const auto event = std::ranges::find(summary.events, "failure", &MatchEvent::kind);
  ASSERT_NE(event, summary.events.end());
  EXPECT_EQ(event->text, error);
  EXPECT_EQ(event->time, match->failures()[0].time);
  EXPECT_EQ(event->team, TeamColor::red);
  EXPECT_EQ(event->player, 2);
  EXPECT_TRUE(std::ranges::is_sorted(summary.events, {}, &MatchEvent::time));
}

TEST_F(MatchTest, ARobotOutsideThatNeverCameIsNamed) {
  MatchOptions options;
  options.scene = "scenes/one-robot.scene";
  options.sockets = folder / "sockets";
  const auto scene = loadScene(options.scene);
  ASSERT_TRUE(scene);
  const std::string name = scene->robots.front().name;
  options.remote[name] = "";
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  for (int i = 0; i < 10; ++i) (*match)->step();
  EXPECT_TRUE((*match)->soundness()) << "the match goes on without it";
  const MatchSummary summary = (*match)->summary();
  ASSERT_FALSE(summary.events.empty());
  EXPECT_EQ(summary.events.back().kind, "failure");
  EXPECT_EQ(summary.events.back().text, name + ": no program has come");
  EXPECT_EQ(summary.events.back().time, (*match)->time());
}

}  // namespace
}  // namespace gt
