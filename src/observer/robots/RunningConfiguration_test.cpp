#include "observer/robots/RunningConfiguration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "observer/robots/LocalLink.h"
#include "representations/perception/LearnedCalibration.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

using ::testing::HasSubstr;

/// A robot of this program that is asked by messages.
class Running {
 public:
  explicit Running(const std::string& config = "config") {
    ConfigurationPaths paths;
    paths.config = config;
    auto layout = loadLayout("layouts/cmd.layout");
    auto configuration = loadConfiguration(paths);
    EXPECT_TRUE(configuration) << configuration.error().text();
    RobotSetup setup;
    setup.configuration = std::move(*configuration);
    setup.layout = std::move(*layout);
    robot_ = std::move(*Robot::make(setup));
    robot_->provideSetup([]() -> Result<RecordedSetup> {
      RecordedSetup recorded;
      recorded.address = "00022D1F626B";
      return recorded;
    });
    observed_ = std::make_unique<ObservedRobot>("red1", std::make_unique<LocalLink>(*robot_));
  }
  ObservedRobot& operator*() { return *observed_; }
  ObservedRobot* operator->() { return observed_.get(); }
  template <typename T>
  T value() {
    const auto value = observed_->value<T>();
    EXPECT_TRUE(value) << value.error().text();
    return value ? **value : T{};
  }

 private:
  std::unique_ptr<Robot> robot_;
  std::unique_ptr<ObservedRobot> observed_;
};

class RunningConfiguration : public ::testing::Test {
 protected:
  std::string path(const std::string& file) const { return (folder.path() / file).string(); }
  std::string folderPath() const { return folder.path().string(); }
  TemporaryFolder folder;
};

HsiColors greenRanges() {
  HsiColors colors;
  colors.ranges[ColorClass::green] = {{100, 140}, {20, 100}, {10, 90}};
  return colors;
}

TslColors orangeThresholds() {
  TslColors colors;
  colors.classes[ColorClass::orange] = {1, {90, 120}, {10, 20}, {30, 40}};
  return colors;
}

constexpr CameraSettings dark{WhiteBalance::wb_fl_mode, Gain::gain_low, ShutterSpeed::shutter_fast};

/// Gives a robot another value of all that it reads from files.
void change(Running& robot) {
  ASSERT_TRUE(robot->request(SolutionRequest{"SelfLocator", "GT2003"}));
  ASSERT_TRUE(robot->set("ImageProcessor.GT2003.denseSpacing", "4"));
  ASSERT_TRUE(robot->set("FieldDimensions.ballRadius", "50"));
  ASSERT_TRUE(robot->send(RobotCalibration{0.1, -0.05}));
  ASSERT_TRUE(robot->send(dark));
  ASSERT_TRUE(robot->send(orangeThresholds()));
  ASSERT_TRUE(robot->send(greenRanges()));
}

void expectChanged(Running& robot) {
  EXPECT_EQ((*robot->task("SelfLocator"))->active, "GT2003");
  EXPECT_EQ(*robot->get("ImageProcessor.GT2003.denseSpacing"), "4");
  EXPECT_EQ(*robot->get("FieldDimensions.ballRadius"), "50");
  EXPECT_EQ(robot.value<RobotCalibration>().bodyTiltOffset, 0.1);
  EXPECT_EQ(robot.value<RobotCalibration>().bodyRollOffset, -0.05);
  EXPECT_EQ(robot.value<CameraSettings>(), dark);
  EXPECT_TRUE(robot.value<TslColors>() == orangeThresholds());
  EXPECT_TRUE(robot.value<HsiColors>() == greenRanges());
  EXPECT_EQ(robot.value<ColorTable64>().classes, greenRanges().table().classes);
}

TEST_F(RunningConfiguration, IsWrittenAndReadByRobotsThatRunOrStart) {
  Running changed;
  change(changed);
  expectChanged(changed);
  const auto saved = saveRunningConfiguration(*changed, folderPath());
  ASSERT_TRUE(saved) << saved.error().text();
  Running other;
  EXPECT_EQ((*other->task("SelfLocator"))->active, "Kalman");
  const auto loaded = loadRunningConfiguration(*other, folderPath(), DataRoot{});
  ASSERT_TRUE(loaded) << loaded.error().text();
  expectChanged(other);
  Running started{folderPath()};
  expectChanged(started);
}

TEST_F(RunningConfiguration, HasWhatTheRobotLearned) {
  Running robot;
  ASSERT_TRUE(robot->send(RobotCalibration{0.1, -0.05}));
  ASSERT_TRUE(robot->send(LearnedCalibration{{0.12, -0.04, 3, 0.01}, {0.001, 0.001, 1, 0.002}}));
  ASSERT_TRUE(saveRunningConfiguration(*robot, folderPath()));
  Running started{folderPath()};
  EXPECT_EQ(started.value<RobotCalibration>(), (RobotCalibration{0.12, -0.04, 3, 0.01}));
}

TEST_F(RunningConfiguration, OfATableThatIsMadeOfNoRangesHasNone) {
  Running robot;
  ASSERT_TRUE(robot->send(greenRanges()));
  ASSERT_TRUE(saveRunningConfiguration(*robot, folderPath()));
  EXPECT_TRUE(std::filesystem::exists(path("coltable.hsi")));
  ColorTable64 pink;
  pink.classes.fill(ColorClass::pink);
  ASSERT_TRUE(robot->send(pink));
  EXPECT_TRUE(robot.value<HsiColors>() == HsiColors{});
  ASSERT_TRUE(saveRunningConfiguration(*robot, folderPath()));
  EXPECT_FALSE(std::filesystem::exists(path("coltable.hsi")));
  Running started{folderPath()};
  EXPECT_EQ(started.value<ColorTable64>().classes, pink.classes);
}

TEST_F(RunningConfiguration, ARangeThatIsSetByPathMakesTheTable) {
  Running robot;
  ASSERT_TRUE(robot->send(greenRanges()));
  ASSERT_TRUE(robot->set("HsiColors.ranges.green.hue", "90 150"));
  HsiColors wider = greenRanges();
  wider.ranges[ColorClass::green].hue = {90, 150};
  EXPECT_EQ(robot.value<ColorTable64>().classes, wider.table().classes);
}

TEST_F(RunningConfiguration, FilesThatAreMissingChangeNothing) {
  Running robot;
  change(robot);
  ASSERT_TRUE(writeFile(path("robot.cfg"),
                        "bodyTiltOffset 0.3\n[00022D1F626B]\nbodyTiltOffset 0.2 // this one\n"));
  const auto loaded = loadRunningConfiguration(*robot, folderPath(), DataRoot{});
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_EQ(robot.value<RobotCalibration>().bodyTiltOffset, 0.2) << "of its address";
  EXPECT_EQ(robot.value<CameraSettings>(), dark);
  EXPECT_TRUE(robot.value<HsiColors>() == greenRanges());
  EXPECT_EQ(*robot->get("ImageProcessor.GT2003.denseSpacing"), "4");
}

TEST_F(RunningConfiguration, ErrorsNameFileAndLine) {
  Running robot;
  const auto error = [&] {
    return loadRunningConfiguration(*robot, folderPath(), DataRoot{}).error().text();
  };
  ASSERT_TRUE(writeFile(path("camera.cfg"), "\ngain loud\n"));
  EXPECT_THAT(error(), HasSubstr("camera.cfg:2: "));
  std::filesystem::remove(path("camera.cfg"));
  std::filesystem::create_directories(path("modules"));
  ASSERT_TRUE(writeFile(path("modules/ImageProcessor.GT2003.cfg"),
                        "// spacing\ndenseSpacing = 3  # and more\nnonsense 4\n"));
  EXPECT_THAT(error(), HasSubstr("ImageProcessor.GT2003.cfg:3: "));
  EXPECT_EQ(*robot->get("ImageProcessor.denseSpacing"), "3");
  EXPECT_THAT(loadRunningConfiguration(*robot, path("nowhere"), DataRoot{}).error().text(),
              HasSubstr("nowhere"));
}

}  // namespace
}  // namespace gt
