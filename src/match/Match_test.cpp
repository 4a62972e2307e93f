#include "match/Match.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>

#include "base/Statistics.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/LandmarksPercept.h"
#include "streams/File.h"
#include "streams/Json.h"
#include "streams/Mcap.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Sanitized programs are 10 to 50 times slower: they see the beginning of a match, in ms.
#if defined(__SANITIZE_THREAD__)
constexpr std::int64_t longest = 800;
#elif defined(__SANITIZE_ADDRESS__)
constexpr std::int64_t longest = 6000;
#else
constexpr std::int64_t longest = std::numeric_limits<std::int64_t>::max();
#endif
constexpr bool wholeMatches = longest > 60'000;

bool isOver(const Match& match) {
  return match.finished() || match.time() >= Time{longest};
}

/// Plays matches into a folder of its own.
class MatchTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("gt2003-match-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::unique_ptr<Match> make(const std::string& name, std::uint64_t seed, std::size_t threads,
                              double minutes, const std::string& scene = "scenes/match.scene") {
    MatchOptions options;
    options.scene = scene;
    options.seed = seed;
    options.threads = threads;
    options.minutes = minutes;
    options.logs = (folder / name).string();
    options.pictures = 4;
    fs::create_directories(options.logs);
    auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    return std::move(*match);
  }
  /// Everything that a match leaves, as bytes by name.
  std::map<std::string, std::string> play(const std::string& name, std::uint64_t seed,
                                          std::size_t threads, double minutes = 0.5,
                                          const std::string& scene = "scenes/match.scene") {
    const auto match = make(name, seed, threads, minutes, scene);
    while (!isOver(*match)) match->step();
    EXPECT_TRUE(match->close());
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator{folder / name})
      files[entry.path().filename()] = *readFile(entry.path().string());
    files["match.json"] = toJson(match->summary()).dump();
    return files;
  }

  fs::path folder;
};

TEST_F(MatchTest, SameSeedSameBytesWithAnyNumberOfThreads) {
  const auto first = play("first", 3, 1);
  EXPECT_EQ(first.size(), 9u) << "eight logs and the summary";
  for (const auto& [name, bytes] : first)
    EXPECT_GT(bytes.size(), wholeMatches ? 10'000u : 1'000u) << name;
  const auto again = play("again", 3, 1), threads = play("threads", 3, 2),
             other = play("other", 4, 2);
  for (const auto& [name, bytes] : first) {
    // Comparisons without the bytes in the message.
    EXPECT_TRUE(bytes == again.at(name)) << name;
    EXPECT_TRUE(bytes == threads.at(name)) << name;
    EXPECT_FALSE(bytes == other.at(name)) << name << " of another seed";
  }
}

/// The report 2.2.3: modules are grouped to processes without a change of their code.
TEST_F(MatchTest, EveryLayoutPlaysTheSameMatch) {
  std::string first;
  for (const char* layout : {"cmd", "single", "pmbm"}) {
    MatchOptions options;
    options.minutes = 0.2;
    options.layout = "layouts/" + std::string{layout} + ".layout";
    const auto match = Match::make(options);
    ASSERT_TRUE(match) << match.error().text();
    while (!isOver(**match)) (*match)->step();
    const std::string summary = toJson((*match)->summary()).dump();
    if (first.empty()) first = summary;
    EXPECT_TRUE(summary == first) << layout;
  }
  EXPECT_GT(first.size(), wholeMatches ? 10'000u : 1'000u);
}

/// Layouts change under a running match without a trace: modules keep what they remember.
TEST_F(MatchTest, LayoutsChangeWhileTheMatchGoesOn) {
  const auto play = [&](bool change) {
    MatchOptions options;
    options.minutes = 0.2;
    const auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    int ticks = 0;
    while (!isOver(**match)) {
      if (change && ++ticks % 50 == 0) {
        const char* name = ticks % 150 == 0   ? "layouts/cmd.layout"
                           : ticks % 100 == 0 ? "layouts/single.layout"
                                              : "layouts/pmbm.layout";
        for (const auto& robot : (*match)->robots()) {
          auto* simulated = dynamic_cast<SimulatedRobot*>(robot);
          simulated->robot().fromTools().write((*match)->time(),
                                               LayoutRequest{name, *readFile(name)});
        }
      }
      (*match)->step();
    }
    return toJson((*match)->summary()).dump();
  };
  EXPECT_TRUE(play(false) == play(true));
}

TEST_F(MatchTest, TheDynamicFidelityIsAsRepeatable) {
  const auto first = play("first", 3, 1, 0.1, "scenes/dynamic.scene");
  const auto threads = play("threads", 3, 2, 0.1, "scenes/dynamic.scene");
  EXPECT_EQ(first.size(), 9u);
  for (const auto& [name, bytes] : first) EXPECT_TRUE(bytes == threads.at(name)) << name;
}

/// What a person does to a match in the tests: puts the ball.
Result<void> putBall(Match& match, const std::string& line) {
  match.simulation().world().placeBall(0, {std::stod(line), 100}, {300, 0});
  return {};
}

TEST_F(MatchTest, ASavedMatchGoesOnWithTheSameBits) {
  const std::string file = (folder / "match.state").string();
  constexpr std::int64_t intervened = wholeMatches ? 1200 : 400,
                         savedAt = wholeMatches ? 2000 : 800, end = 2 * savedAt;
  for (const char* scene : {"scenes/match.scene", "scenes/dynamic.scene"}) {
    MatchOptions options;
    options.scene = scene;
    options.seed = 11;
    auto made = Match::make(options);
    ASSERT_TRUE(made) << made.error().text();
    Match* const whole = made->get();
    const auto run = [](Match& match, std::int64_t ms) {
      while (match.time() < Time{ms}) match.step();
    };
    run(*whole, intervened);
    ASSERT_TRUE(putBall(*whole, "-250"));
    whole->note(InterventionKind::console, "-250");
    run(*whole, savedAt);
    const auto saved = whole->save(file);
    ASSERT_TRUE(saved) << saved.error().text();
    run(*whole, end);
    options.threads = 2;
    auto loaded = Match::load(file, options, putBall);
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ((*loaded)->time(), Time{savedAt});
    run(**loaded, end);
    EXPECT_EQ((*loaded)->simulation().fingerprint(), whole->simulation().fingerprint());
    EXPECT_TRUE(toJson((*loaded)->summary()) == toJson(whole->summary()));
    // The state of the loaded match is as good as the first one's.
    ASSERT_TRUE((*loaded)->save(file));
    EXPECT_TRUE(Match::load(file, options, putBall));
  }
}

/// A game controller's message of 2019: state, and the score of blue, the first team.
std::vector<std::byte> order(int state, int score) {
  const std::string head{"RGme"};
  std::vector<std::byte> bytes(54);
  for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<std::byte>(head[i]);
  for (const auto& [at, value] : std::map<std::size_t, int>{{4, 12},
                                                            {10, state},
                                                            {12, 1},
                                                            {13, 5},
                                                            {14, 60},
                                                            {18, 5},
                                                            {20, score},
                                                            {36, 7},
                                                            {37, 1}})
    bytes[at] = static_cast<std::byte>(value);
  return bytes;
}

TEST_F(MatchTest, AGameControllerLeadsByUdpAndIsAnswered) {
  MatchOptions options;
  options.minutes = 1;
  options.gameControllerPort = 0x8000 + ::getpid() % 0x4000;
  auto made = Match::make(options);
  ASSERT_TRUE(made) << made.error().text();
  Match& match = **made;
  // Answers come to the port 3939 of whoever sent; if somebody else has it here, they go there.
  auto answers = GameControllerLink::listen(gameControllerAnswerPort(12));
  const auto send = [&](std::span<const std::byte> bytes) {
    const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(match.gameController()->port()));
    ::sendto(socket, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
    ::close(socket);
  };
  send(std::as_bytes(std::span{"garbage"}));
  match.step();
  EXPECT_FALSE(match.simulation().referee().led());
  send(order(3, 2));
  match.step();
  const Referee& referee = match.simulation().referee();
  EXPECT_TRUE(referee.led());
  EXPECT_EQ(referee.state(), GameState::playing);
  EXPECT_EQ(referee.score(TeamColor::blue), 2);
  EXPECT_EQ(referee.kickOff(), TeamColor::blue);
  if (answers) {
    int heard = 0;
    while (const auto bytes = (*answers)->receive())
      heard += bytes->size() == 8 && std::memcmp(bytes->data(), "RGrt", 4) == 0;
    EXPECT_EQ(heard, 8);
  }
  // What it said is part of the state.
  for (int i = 0; i < 20; ++i) match.step();
  const std::string file = (folder / "led.state").string();
  ASSERT_TRUE(match.save(file));
  const auto loaded = Match::load(file, {}, putBall);
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_EQ((*loaded)->simulation().referee().score(TeamColor::blue), 2);
}

TEST_F(MatchTest, StatesThatDoNotFitAreRefused) {
  const std::string file = (folder / "match.state").string();
  const auto match = make("match", 1, 1, 0.01);
  for (int i = 0; i < 25; ++i) match->step();
  ASSERT_TRUE(match->save(file));
  const std::string good = *readFile(file);
  const auto errorOf = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    EXPECT_TRUE(writeFile(file, text));
    const auto loaded = Match::load(file, {}, putBall);
    return loaded ? std::string{"no error"} : loaded.error().text();
  };
  EXPECT_NE(errorOf("\"seed\": 1", "\"seed\": 2").find("went another way"), std::string::npos);
  EXPECT_NE(errorOf("\"time\": 200", "\"time\": 201").find("time"), std::string::npos);
  EXPECT_NE(errorOf("\"time\": 200", "\"time\": 8000000").find("over before"), std::string::npos);
  EXPECT_NE(errorOf("match.scene", "no.scene").find("no.scene"), std::string::npos);
  EXPECT_NE(errorOf("[]", "[{\"time\": 800}]").find("history"), std::string::npos);
  EXPECT_NE(errorOf("{", "").find("match.state"), std::string::npos);
  match->spoil("somebody was hasty");
  EXPECT_FALSE(match->save(file));
}

TEST_F(MatchTest, LogsHoldWhatIsConfigured) {
  if (!wholeMatches) GTEST_SKIP() << "needs a whole match";
  const auto match = make("log", 5, 2, 0.5);
  while (!match->finished()) match->step();
  ASSERT_TRUE(match->close());
  const double seconds = static_cast<double>(match->time().ms) / 1000;
  std::size_t balls = 0;
  for (const RobotSummary& robot : match->summary().robots)
    balls += static_cast<std::size_t>(robot.ballError.count);
  EXPECT_GT(balls, 25 * seconds) << "at least one robot in the mean sees the ball";
  const auto log = McapReader::open((folder / "log/red1.mcap").string());
  ASSERT_TRUE(log) << log.error().text();
  std::map<std::string, double> counts;
  for (const McapChannel& channel : log->channels())
    counts[channel.topic] = static_cast<double>(channel.messageCount);
  EXPECT_NEAR(counts["/RobotPose"], 25 * seconds, 1) << "25 a second";
  EXPECT_NEAR(counts["/BallPercept"], 25 * seconds, 1);
  EXPECT_NEAR(counts["/camera"], seconds / 2, 1) << "one in two seconds";
}

TEST_F(MatchTest, RobotsPlay) {
  if (!wholeMatches) GTEST_SKIP() << "needs a whole match";
  const auto match = make("play", 6, 2, 1);
  while (!match->finished()) match->step();
  const MatchSummary summary = match->summary();
  ASSERT_EQ(summary.robots.size(), 8u);
  double walked = 0, seen = 0;
  for (const RobotSummary& robot : summary.robots) {
    walked += robot.distanceWalked;
    seen += static_cast<double>(robot.ballError.count);
    EXPECT_GT(robot.localizationError.count, 500);
    EXPECT_NEAR(static_cast<double>(robot.samples.size()),
                static_cast<double>(summary.duration.ms) / 1000, 1);
  }
  EXPECT_GT(walked, 8000);
  EXPECT_GT(seen, 1000);
  EXPECT_FALSE(match->pictures().empty());
  EXPECT_EQ(summary.events.back().kind, "gameOver");
}

TEST_F(MatchTest, WrongFilesAreToldInOneLine) {
  const auto errorOf = [](MatchOptions options) {
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
}

/// A robot that stands and looks, whose body leans otherwise than its joints tell (degrees).
struct Lean {
  double tilt = 0, roll = 0;
};

/// How far from the truth percepts lie.
struct Distances {
  RunningStatistics ball, flags;  ///< mm
};

class LeaningBody : public MatchTest {
 protected:
  /// Ball 1 m away and the flag behind it as a robot measures them, with robot.cfg or without.
  void measure(const Lean& lean, bool corrected, std::uint64_t seed, Distances& distances) {
    const fs::path config = folder / "config";
    fs::copy("config", config, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    const Lean known = corrected ? lean : Lean{};
    ASSERT_TRUE(writeFile((config / "robot.cfg").string(),
                          "[00022D1F626B]\nbodyTiltOffset " +
                              std::to_string(fromDegrees(known.tilt)) + "\nbodyRollOffset " +
                              std::to_string(fromDegrees(known.roll)) + "\n"));
    const auto here = [](const char* path) { return fs::absolute(path).string(); };
    ASSERT_TRUE(writeFile(
        (folder / "lean.scene").string(),
        "<scene field=\"" + here("models/field2003.xml") + "\" config=\"" + config.string() +
            "\"><game referee=\"false\"/><robots><robot x=\"1000\" y=\"700\" rotation=\"32\" "
            "model=\"" +
            here("models/ers210.xml") + "\" layout=\"" + here("layouts/cmd.layout") +
            "\" address=\"00022D1F626B\" bodyTilt=\"" + std::to_string(lean.tilt) +
            "\" bodyRoll=\"" + std::to_string(lean.roll) +
            "\"/></robots><balls><ball x=\"1848\" y=\"1230\" model=\"" + here("models/ball.xml") +
            "\"/></balls></scene>"));
    const auto match = make("logs", seed, 1, 1, (folder / "lean.scene").string());
    Robot& robot = match->robots()[0]->robot();
    ASSERT_TRUE(robot.request(SolutionRequest{"BehaviorControl", "disabled"}));
    for (int tick = 0; tick < 400; ++tick) {
      robot.layIfDisabled(HeadControlMode{HeadMode::lookAtPoint, {1000, 0, 150}});
      match->step();
      if (tick >= 250) add(*match, distances);
    }
  }

  /// What the last picture showed against the truth.
  void add(Match& match, Distances& distances) {
    const Robot& robot = match.robots()[0]->robot();
    const World& world = match.simulation().world();
    const Pose2D pose = world.robot(0).pose;
    const auto& ball = *robot.provided<BallPercept>();
    if (ball.seen)
      distances.ball.add((ball.offset - relative(pose, world.ball(0).position)).norm());
    const auto& landmarks = *robot.provided<LandmarksPercept>();
    const FieldDimensions field;
    for (int i = 0; i < landmarks.numberOfFlags; ++i) {
      const FlagPercept& flag = landmarks.flags[static_cast<std::size_t>(i)];
      if (flag.type != FlagType::skyblueAbovePink || flag.distance == 0) continue;
      const Vector2d place = flag.distance * direction(flag.angle);
      const double elevation = (flag.boundary.top + flag.boundary.bottom) / 2;
      const double height = landmarks.cameraOffset.z() +
                            (place - landmarks.cameraOffset.head<2>()).norm() * std::tan(elevation);
      const Vector2d truth = relative(pose, positionOf(flag.type, TeamColor::red, field));
      const Vector2d off = place - truth;
      distances.flags.add(
          std::hypot(off.x(), off.y(), height - (field.flagBottom + field.flagTop) / 2));
    }
  }
};

/// Report B.4.5: with the corrections in robot.cfg, what leans otherwise than its joints tell sees
/// things where they are.
TEST_F(LeaningBody, RobotCfgBringsPerceptsBackToTheTruth) {
  Distances upright, leaning, corrected;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    measure({}, false, seed, upright);
    for (const Lean lean : {Lean{3, 0}, Lean{-3, 0}, Lean{0, 4}, Lean{2, -4}}) {
      measure(lean, false, seed, leaning);
      measure(lean, true, seed, corrected);
    }
  }
  for (const auto& [name, d] : {std::pair{"upright", &upright}, std::pair{"leaning", &leaning},
                                std::pair{"corrected", &corrected}})
    std::cout << name << ": ball " << d->ball.mean() << " mm of " << d->ball.count() << ", flag "
              << d->flags.mean() << " mm of " << d->flags.count() << " off\n";
  ASSERT_GT(upright.ball.count(), 300u);
  ASSERT_GT(upright.flags.count(), 300u);
  EXPECT_GT(leaning.ball.mean(), 2 * upright.ball.mean());
  EXPECT_GT(leaning.flags.mean(), 1.5 * upright.flags.mean());
  EXPECT_LT(corrected.ball.mean(), 1.3 * upright.ball.mean() + 3);
  EXPECT_LT(corrected.flags.mean(), 1.3 * upright.flags.mean() + 3);
}

}  // namespace
}  // namespace gt
