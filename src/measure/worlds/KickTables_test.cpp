#include "measure/worlds/KickTables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// What robots did with balls at 25 places: a length (mm) and a direction (degrees) for each place
/// and robot.
template <typename Way>
std::vector<GridTrial> trialsOf(Way&& way, int robots = 6) {
  std::vector<GridTrial> trials;
  for (int robot = 0; robot < robots; ++robot)
    for (int x = 100; x <= 180; x += 20)
      for (int y = -40; y <= 40; y += 20) {
        const auto [length, degrees] = way(x, y, robot);
        GridTrial trial{x, y, {}};
        trial.kick.way = length * direction(fromDegrees(degrees));
        trial.kick.seconds = 1.5;
        trial.kick.strike = 0.8;
        trials.push_back(trial);
      }
  return trials;
}

double swinging(double spread, int robot) {
  return robot % 2 ? spread : -spread;
}

TEST(DescribeKick, TakesThePlaceFromWhichTheBallSurelyGoesFarAndOneWay) {
  const auto described = describeKick("kick", trialsOf([](int, int y, int robot) {
                                        return y > 20 ? std::pair{1500., swinging(12, robot)}
                                                      : std::pair{1000., swinging(1, robot)};
                                      }));
  EXPECT_EQ(described.kick.x, 120);
  EXPECT_EQ(described.kick.y, -20);
  EXPECT_EQ(described.kick.length, 1000);
  EXPECT_NEAR(described.kick.direction, 0, 1e-9);
  EXPECT_EQ(described.kick.seconds, 1.5);
  EXPECT_EQ(described.kick.strike, 0.8);
  EXPECT_EQ(described.kick.places.size(), 25);
  EXPECT_EQ(
      described.why,
      "best place 120, -20: 1000 mm to 0 degrees, spread 1.0; worth 800 = hits at least 100 % "
      "x 1000 mm with the places around it - 1.0 degrees astray x 200 mm");
}

TEST(DescribeKick, MeansDirectionsBehindTheRobot) {
  const auto described = describeKick("kick", trialsOf([](int, int, int robot) {
                                        return std::pair{1000., robot % 2 ? 178. : -178.};
                                      }));
  EXPECT_NEAR(std::abs(described.kick.direction), 180, 1e-9);
  EXPECT_EQ(described.kick.at({140, 0})->spread, 2);
}

TEST(DescribeKick, PrefersPlacesWhereTheRobotStaysOnItsFeet) {
  auto trials = trialsOf([](int x, int, int) { return std::pair{10. * x, 0.}; });
  EXPECT_EQ(describeKick("kick", trials).kick.x, 160);
  for (GridTrial& trial : trials) trial.kick.fell = trial.x >= 160;
  EXPECT_EQ(describeKick("kick", trials).kick.x, 120);
}

TEST(DescribeKick, HasNoPlacesIfTheBallIsSurelyMovedFromNone) {
  const auto described = describeKick("kick", trialsOf([](int, int, int robot) {
                                        return std::pair{robot % 3 ? 1000. : 100., 0.};
                                      }));
  EXPECT_TRUE(described.kick.places.empty());
  EXPECT_EQ(described.why, "hits 90 % of the balls from no place");
}

TEST(DescribeKick, LeavesOutWhereThereIsNoRoomForTheBallAndWhereItGoesAnywhere) {
  auto trials = trialsOf([](int x, int, int robot) {
    return std::pair{1000., x == 180 ? 60. * robot : 0.};
  });
  for (GridTrial& trial : trials) trial.kick.overlaps = trial.x == 100;
  const KickDescription kick = describeKick("kick", trials).kick;
  EXPECT_FALSE(kick.at({100, 0}));
  EXPECT_TRUE(kick.at({120, 0}));
  EXPECT_FALSE(kick.at({180, 0}));
}

TEST(KickTables, AreReadAsTheyWereWritten) {
  KickTable table, read;
  ASSERT_TRUE(readConfig("config/kicks.cfg", table));
  ASSERT_FALSE(table.kicks.empty());
  const std::string text = kickTableText(table);
  ASSERT_TRUE(parseConfig(text, "kicks.cfg", read));
  EXPECT_EQ(kickTableText(read), text);
  EXPECT_EQ(*readFile("config/kicks.cfg"), text);
}

/// The project's motions with some changed, and a cache of its own.
class ChangedMotions : public testing::Test {
 protected:
  ChangedMotions() {
    std::filesystem::copy("motions", motions(), std::filesystem::copy_options::recursive);
    EXPECT_EQ(setenv("XDG_CACHE_HOME", (folder_.path() / "cache").c_str(), 1), 0);
  }
  ~ChangedMotions() override { unsetenv("XDG_CACHE_HOME"); }

  std::string motions() const { return folder_.path() / "motions"; }
  KickTable kicks() const {
    const auto net = loadMotionNet(motions());
    EXPECT_TRUE(net) << net.error().text();
    ConfigurationPaths paths;
    paths.motions = motions();
    auto kicks = kicksOfMotions(*net, paths, DataRoot{}, 2);
    EXPECT_TRUE(kicks) << kicks.error().text();
    return *std::move(kicks);
  }

  TemporaryFolder folder_;
};

TEST_F(ChangedMotions, AreTheTablesAsLongAsTheyDoTheSame) {
  KickTable table;
  ASSERT_TRUE(readConfig("config/kicks.cfg", table));
  const std::string file = motions() + "/kicks/pushStrong.mof";
  ASSERT_TRUE(writeFile(file, "// Another comment.\n" + *readFile(file)));
  EXPECT_EQ(kickTableText(kicks()), kickTableText(table));
}

// Here the project's tables are that of an earlier team alone, which plays with these motions.
TEST_F(ChangedMotions, AreKnownFromTheTableOfAnEarlierTeam) {
  const std::filesystem::path root = folder_.path() / "root";
  std::filesystem::create_directories(root / "config/opponents");
  std::filesystem::copy("config/kicks.cfg", root / "config/opponents/0123456789ab.cfg");
  const auto net = loadMotionNet(motions());
  ASSERT_TRUE(net) << net.error().text();
  ConfigurationPaths paths;
  paths.motions = motions();
  paths.config = root / "config";
  const auto kicks = kicksOfMotions(*net, paths, DataRoot{root}, 2);
  ASSERT_TRUE(kicks) << kicks.error().text();
  EXPECT_EQ(kickTableText(*kicks), *readFile("config/kicks.cfg"));
}

// The file names the commit whose robots play with these motions.
TEST(KickTables, OfEarlierTeamsAreKeptAsTheyAreWritten) {
  for (const auto& entry : std::filesystem::directory_iterator{"config/opponents"}) {
    KickTable table;
    ASSERT_TRUE(readConfig(entry.path(), table)) << entry.path();
    EXPECT_EQ(entry.path().stem().string().size(), 12) << entry.path();
    EXPECT_FALSE(table.kicks.empty()) << entry.path();
    EXPECT_EQ(*readFile(entry.path()), kickTableText(table)) << entry.path();
  }
}

TEST_F(ChangedMotions, ThatStandStillAreNoKicksAndAreMeasuredOnce) {
  const std::string file = motions() + "/kicks/pushStrong.mof";
  ASSERT_TRUE(writeFile(file,
                        "motion_id = pushStrong\nlabel start\nposture stand  1 150\n"
                        "transition allMotions extern start\n"));
  const KickTable made = kicks();
  EXPECT_EQ(made.kickOf("pushStrong"), nullptr);
  EXPECT_NE(made.kickOf("pushSoft"), nullptr);
  testing::internal::CaptureStderr();
  EXPECT_EQ(kickTableText(kicks()), kickTableText(made));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace gt
