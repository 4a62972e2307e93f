#include "robot/Configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/File.h"
#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/motion/MotionNet.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// A copy of the repository's configuration, to break a file of.
class ConfigurationTest : public ::testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("gt2003-config-" + std::to_string(::getpid()));
    fs::remove_all(root);
    fs::create_directories(root);
    for (const char* folder : {"config", "motions", "behavior"})
      fs::copy(folder, root / folder, fs::copy_options::recursive);
    paths = {(root / "config").string(), (root / "motions").string(),
             (root / "behavior/GT2003.xabsl").string()};
  }
  void TearDown() override { fs::remove_all(root); }

  void write(const std::string& file, std::string_view content) {
    fs::create_directories((root / file).parent_path());
    ASSERT_TRUE(writeFile((root / file).string(), content));
  }
  std::string read(const std::string& file) { return *readFile((root / file).string()); }
  /// The error's one line, with the temporary folder cut off.
  std::string error() {
    const auto configuration = loadConfiguration(paths);
    if (configuration) return "no error";
    std::string text = configuration.error().text();
    EXPECT_EQ(text.find('\n'), text.npos);
    const std::string prefix = root.string() + "/";
    for (auto at = text.find(prefix); at != text.npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }

  fs::path root;
  ConfigurationPaths paths;
};

TEST_F(ConfigurationTest, TheRepositorysIsSound) {
  EXPECT_EQ(error(), "no error");
}

/// The color table is made of HSI ranges where these are nearer than a table (report B.4.1, J.6.2).
TEST_F(ConfigurationTest, MakesTheColorTableOfHsiRanges) {
  const auto table = [&] { return (*loadConfiguration(paths))->get<ColorTable64>().classes; };
  const auto own = table();
  write("config/coltable.hsi", "[green]\nhue 100 140\nsaturation 20 100\nintensity 10 90\n");
  const HsiColors ranges = (*loadConfiguration(paths))->get<HsiColors>();
  EXPECT_FALSE(ranges.ranges[ColorClass::green].empty());
  EXPECT_EQ(table(), ranges.table().classes);
  EXPECT_NE(table(), own);
  fs::remove(root / "config/coltable.c64");
  EXPECT_EQ(table(), ranges.table().classes);
  fs::create_directories(root / "config/Padua");
  fs::copy("config/coltable.c64", root / "config/Padua");
  write("config/location.cfg", "Padua");
  EXPECT_EQ(table(), own) << "the location's table wins over the common ranges";
  fs::remove(root / "config/location.cfg");
  write("config/coltable.hsi", "[green]\nhue 100 1400\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/coltable.hsi:2: "));
}

TEST_F(ConfigurationTest, MissingFolder) {
  paths.config = (root / "nowhere").string();
  EXPECT_EQ(error(), "nowhere: is not a folder");
}

TEST_F(ConfigurationTest, WrongConfigFiles) {
  write("config/field.cfg", "ballRadius 43\nballRadus 44\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/field.cfg:2: ballRadus: "));
  write("config/field.cfg", "ballRadius round\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/field.cfg:1: ballRadius: "));
  write("config/field.cfg", "ballRadius -5\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/field.cfg:1: ballRadius: "));
  write("config/field.cfg", std::string_view("\0\1\2\377\376", 5));
  EXPECT_THAT(error(), ::testing::StartsWith("config/field.cfg:1: "));
}

TEST_F(ConfigurationTest, CheckTellsAllErrorsOfAFile) {
  write("config/field.cfg", "ballRadus 44\nballRadius 44\nballRadius 45\n[nowhere]\nlength 1\n");
  write("config/robot.cfg",
        "bodyTiltOffset 9\n[red1]\nbodyTiltOffset 1\n[00022D1F626B]\n"
        "bodyTiltOffset 0.06\nbodyRollOfset 0\nbodyRollOffset x\n");
  write("config/player.cfg", "teamColor green\nplayerRole keeper\n");
  write("config/network.cfg", "robots x\naddress 12\n");
  fs::create_directories(root / "config/modules");
  write("config/modules/BallLocator.PIDSmoothed.cfg", "nothing 1\nnowhere 2\n");
  std::vector<std::string> reported;
  const Findings findings = checkConfiguration(paths, allModules());
  for (const Error& error : findings.list())
    reported.push_back(fs::path{error.file}.stem().string() + ":" + std::to_string(error.line) +
                       " " + error.field);
  EXPECT_THAT(reported, ::testing::UnorderedElementsAre(
                            "field:1 ballRadus", "field:3 ballRadius", "field:4 nowhere",
                            "robot:1 bodyTiltOffset", "robot:2 red1", "robot:6 bodyRollOfset",
                            "robot:7 bodyRollOffset", "player:1 teamColor", "player:2 playerRole",
                            "network:1 robots", "BallLocator.PIDSmoothed:1 nothing",
                            "BallLocator.PIDSmoothed:2 nowhere"));
}

TEST_F(ConfigurationTest, CheckTellsWrongAddresses) {
  write("config/network.cfg", "address 12\ntools 5\n");
  std::vector<std::string> reported;
  const Findings findings = checkConfiguration(paths, allModules());
  for (const Error& error : findings.list()) reported.push_back(error.field + ": " + error.what);
  EXPECT_THAT(reported, ::testing::ElementsAre(
                            "address: expected 12 digits, as 00022D1F626B",
                            ::testing::StartsWith("tools: network: 5: expected an endpoint")));
}

TEST_F(ConfigurationTest, WrongModules) {
  write("config/modules.cfg", "SelfLocator MonteCarlo\nSelfLocater MonteCarlo\n");
  EXPECT_EQ(error(),
            "config/modules.cfg:2: SelfLocater: there is no such task; did you "
            "mean 'SelfLocator'?");
  write("config/modules.cfg", "SelfLocator MontyCarlo\n");
  EXPECT_EQ(error(),
            "config/modules.cfg:1: SelfLocator: there is no solution 'MontyCarlo'; "
            "did you mean 'MonteCarlo'?");
  write("config/modules.cfg", "SelfLocator\n");
  EXPECT_EQ(error(), "config/modules.cfg:1: SelfLocator: expected a task and one solution");
  write("config/modules.cfg", "SelfLocator disabled // for a test\n");
  EXPECT_EQ(error(), "no error");
}

TEST_F(ConfigurationTest, WrongParameterFiles) {
  write("config/modules/SelfLocator.cfg", "");
  EXPECT_EQ(error(),
            "config/modules/SelfLocator.cfg: SelfLocator: expected a file name TASK.SOLUTION.cfg");
  fs::remove(root / "config/modules/SelfLocator.cfg");
  write("config/modules/SelfLocator.Unheard.cfg", "");
  EXPECT_EQ(error(),
            "config/modules/SelfLocator.Unheard.cfg: SelfLocator: there is no solution 'Unheard'");
}

TEST_F(ConfigurationTest, WrongColorTables) {
  const std::string table = read("config/coltable.c64");
  write("config/coltable.c64", table.substr(0, table.size() / 2));
  EXPECT_THAT(error(), ::testing::StartsWith("config/coltable.c64: "));
  write("config/coltable.c64", "garbage, not a color table at all");
  EXPECT_THAT(error(), ::testing::StartsWith("config/coltable.c64: "));
  fs::remove(root / "config/coltable.c64");
  EXPECT_THAT(error(), ::testing::StartsWith("config/coltable.c64: "));
}

TEST_F(ConfigurationTest, WrongMotions) {
  write("motions/postures/stand.mof", "garbage\n");
  EXPECT_THAT(error(), ::testing::StartsWith("motions/postures/stand.mof:1: "));
  fs::remove(root / "motions/postures/stand.mof");
  EXPECT_THAT(error(), ::testing::HasSubstr("stand"));
  fs::remove_all(root / "motions");
  EXPECT_THAT(error(), ::testing::StartsWith("motions"));
}

// A motion is named by its file only, and the table of kicks says what it does; nothing is built
// anew.
TEST_F(ConfigurationTest, ANewKickIsAFileAndRowsOfTheTable) {
  const std::string option = "behavior/options/ball/handle_ball.xabsl";
  std::string text = read(option);
  const std::string call = "kick(id = kick.now)";
  text.replace(text.find(call), call.size(), "kick(id = my_kick)");
  write(option, text);
  EXPECT_THAT(error(), ::testing::StartsWith(option + ":"));
  EXPECT_THAT(error(), ::testing::HasSubstr("my_kick"));
  std::string kick = read("motions/kicks/pushStrong.mof");
  const std::string name = "motion_id = pushStrong";
  kick.replace(kick.find(name), name.size(), "motion_id = myKick");
  write("motions/kicks/myKick.mof", kick);
  std::string table = read("config/kicks.cfg");
  const std::string row = "motion pushStrong";
  table.replace(table.find(row), row.size(), "motion myKick");
  write("config/kicks.cfg", table);
  EXPECT_EQ(error(), "no error");
  const auto configuration = loadConfiguration(paths);
  ASSERT_TRUE(configuration);
  const MotionNet& motions = (*configuration)->get<MotionNet>();
  ASSERT_GT(motions.find("myKick"), 0);
  EXPECT_TRUE(motions.motions[static_cast<std::size_t>(motions.find("myKick"))].isKick());
}

TEST_F(ConfigurationTest, WrongBehaviors) {
  const std::string agents = read("behavior/GT2003.xabsl");
  write("behavior/GT2003.xabsl", agents + "\nagent second(\"Second\", no_such_option);\n");
  EXPECT_THAT(error(), ::testing::HasSubstr("no_such_option"));
  write("behavior/GT2003.xabsl", agents.substr(0, agents.size() - 10));
  EXPECT_THAT(error(), ::testing::StartsWith("behavior/GT2003.xabsl:"));
  write("behavior/GT2003.xabsl", agents);
  write("behavior/symbols/math_symbols.xabsl",
        read("behavior/symbols/math_symbols.xabsl")
            .insert(read("behavior/symbols/math_symbols.xabsl").rfind('}'),
                    "  float input unregistered;\n"));
  EXPECT_THAT(error(), ::testing::HasSubstr("unregistered"));
  fs::remove(root / "behavior/GT2003.xabsl");
  EXPECT_THAT(error(), ::testing::StartsWith("behavior/GT2003.xabsl: "));
}

TEST_F(ConfigurationTest, FilesOfTheLocationWin) {
  write("config/field.cfg", "ballRadius 43\n");
  write("config/Padua/field.cfg", "ballRadius 50\n");
  write("config/Padua/modules.cfg", "SelfLocator disabled\n");
  write("config/Padua/modules/SelfLocator.MonteCarlo.cfg", "");
  const auto common = *loadConfiguration(paths);
  EXPECT_EQ(common->get<FieldDimensions>().ballRadius, 43) << "no location yet";
  write("config/location.cfg", "Padua\n");
  const auto padua = *loadConfiguration(paths);
  EXPECT_EQ(padua->get<FieldDimensions>().ballRadius, 50);
  ASSERT_EQ(padua->solutions.size(), 1u);
  EXPECT_EQ(padua->solutions[0].solution, "disabled");
  EXPECT_EQ(padua->parameters.size(), common->parameters.size() + 1)
      << "all common ones, and its own";
  EXPECT_FALSE(padua->log.representations.empty()) << "what it has not is the common one";
  write("config/location.cfg", " // nothing chosen\n");
  EXPECT_EQ((*loadConfiguration(paths))->get<FieldDimensions>().ballRadius, 43);
}

TEST_F(ConfigurationTest, WrongLocations) {
  write("config/location.cfg", "Lisbon\n");
  EXPECT_EQ(error(), "config/location.cfg: Lisbon: there is no such folder beside it");
  write("config/location.cfg", "../config\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/location.cfg:1: ../config: "));
  write("config/location.cfg", "nao2009\nmodules\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/location.cfg:2: modules: "));
}

TEST_F(ConfigurationTest, RobotsAreCalibratedByTheirAddresses) {
  // The report's example, B.4.5.
  write("config/robot.cfg", "[00022D1F626B]\nbodyTiltOffset 0.06\nbodyRollOffset 0\n");
  write("config/camera.cfg",
        "whiteBalance wb_fl_mode\n[00022D1F626B]\ngain gain_high\nshutterSpeed shutter_slow\n");
  const auto configuration = *loadConfiguration(paths);
  EXPECT_EQ(configuration->of<RobotCalibration>("00022D1F626B").bodyTiltOffset, 0.06);
  EXPECT_EQ(configuration->of<RobotCalibration>("00022D1F626C").bodyTiltOffset, 0);
  const CameraSettings& camera = configuration->of<CameraSettings>("00022D1F626B");
  EXPECT_EQ(camera.whiteBalance, WhiteBalance::wb_fl_mode) << "as for all robots";
  EXPECT_EQ(camera.gain, Gain::gain_high);
  EXPECT_EQ(configuration->of<CameraSettings>("").gain, Gain::gain_mid);
  Blackboard blackboard;
  configuration->share(blackboard, "00022D1F626B");
  EXPECT_EQ(blackboard.get<RobotCalibration>().bodyTiltOffset, 0.06);
}

TEST_F(ConfigurationTest, ColorsByThresholds) {
  write("config/coltable.tsl",
        "[orange]\npriority 1\ntint 110 140\nsaturation 60 255\nluminance 40 200\n");
  Blackboard blackboard;
  (*loadConfiguration(paths))->share(blackboard, "");
  const TslColors& colors = blackboard.get<TslColors>();
  EXPECT_EQ(colors.classOf({120, 100, 100}), ColorClass::orange);
  EXPECT_EQ(colors.classOf({10, 100, 100}), ColorClass::noColor);
  write("config/coltable.tsl", "[orange]\ntint 110 256\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/coltable.tsl:2: orange.tint: "));
}

TEST_F(ConfigurationTest, WrongRobots) {
  write("config/robot.cfg", "[00022D1F626B]\nbodyTiltOffset 0.06\n[red1]\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/robot.cfg:3: red1: "));
  write("config/robot.cfg", "[00022D1F626B]\n\n[00022D1F626B]\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/robot.cfg:3: 00022D1F626B: "));
  write("config/robot.cfg", "[00022D1F626B]\n[00022D1F626C]\nbodyTiltOffset 6\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/robot.cfg:3: bodyTiltOffset: "));
  fs::remove(root / "config/robot.cfg");
  write("config/camera.cfg", "gain loud\n");
  EXPECT_THAT(error(), ::testing::StartsWith("config/camera.cfg:1: gain: "));
}

TEST_F(ConfigurationTest, PlayerAndNetwork) {
  // The report's example, B.4.4.
  write("config/player.cfg",
        "// teamColor red | blue\nteamColor blue\n"
        "// playerRole goalie | defender | striker1 | striker2\nplayerRole striker2\n");
  EXPECT_EQ(loadPlayer(paths.config)->role, PlayerRole::striker2);
  write("config/player.cfg", "teamColor green\n");
  EXPECT_EQ(loadPlayer(paths.config).error().line, 1);
  EXPECT_EQ(loadNetwork(paths.config)->robot, "robot") << "the default";
  write("config/network.cfg",
        "robot blue4\nprocesses Motion=tcp://10.0.1.100:5001 Debug=tcp://10.0.1.100:5002\n");
  EXPECT_EQ(loadNetwork(paths.config)->processes.size(), 2u);
  write("config/network.cfg", "address 00:02:2D:1F:62:6B\n");
  EXPECT_EQ(loadNetwork(paths.config).error().field, "address");
}

TEST_F(ConfigurationTest, CheckTellsAllErrorsAtOnce) {
  EXPECT_TRUE(checkConfiguration(paths, allModules()).empty());
  write("config/modules.cfg", "SelfLocater MonteCarlo\nBallLocator Wrong\n");
  write("config/log.cfg", "representation BallMoodel\npictures often\n");
  write("config/camera.cfg", "gain loud\n");
  write("config/coltable.c64", "garbage, not a color table at all");
  write("config/modules/SelfLocator.MonteCarlo.cfg", "nonsense 1\n");
  write("motions/postures/stand.mof", "garbage\n");
  EXPECT_GE(checkConfiguration(paths, allModules()).errors(), 8u);
}

}  // namespace
}  // namespace gt
