#include "views/graphs/LayoutDrawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/File.h"
#include "robot/Robot.h"
#include "views/graphs/Graphviz.h"
#include "views/graphs/ModuleGraph.h"

namespace gt {
namespace {

using testing::HasSubstr;
using testing::Not;

Plan planOf(const std::string& layout) {
  const auto loaded = loadLayout("layouts/" + layout);
  EXPECT_TRUE(loaded);
  auto plan = robotPlan(*loaded, platformRepresentations());
  EXPECT_TRUE(plan) << plan.error().text();
  return std::move(*plan);
}

TEST(LayoutDrawing, TellsWhatRunsWhereAndWhatCrosses) {
  const std::string cmd = describePlan(planOf("cmd.layout"));
  EXPECT_THAT(cmd, HasSubstr("process Cognition on Image\n   1. SensorDataProcessor: "));
  EXPECT_THAT(cmd, HasSubstr("  Platform -> Cognition: Image, "));
  EXPECT_THAT(cmd, HasSubstr("; Image starts a cycle\n"));
  EXPECT_THAT(cmd, HasSubstr("  Cognition -> Motion: "));
  EXPECT_THAT(
      cmd,
      HasSubstr("  Motion -> Platform: LedValue, Speaker, JointData, JointGains, OdometryData"));
  EXPECT_THAT(cmd, HasSubstr("  Debug -> Motion: MessageQueue\n"));
  const std::string single = describePlan(planOf("single.layout"));
  EXPECT_THAT(single, HasSubstr(". BehaviorControl on Image: MotionRequest"));
  EXPECT_THAT(single, Not(HasSubstr("-> Motion")));
}

TEST(LayoutDrawing, GraphvizDrawsIt) {
  const auto file = std::filesystem::temp_directory_path() / "gt2003-layout.svg";
  const auto done = writeSvg(drawPlan(planOf("cmd.layout")), file.string());
  ASSERT_TRUE(done) << done.error().text();
  const std::string svg = *readFile(file.string());
  for (const char* part : {"Cognition", "Motion", "Platform", "ImageProcessor", "MotionRequest"})
    EXPECT_THAT(svg, HasSubstr(part));
  std::filesystem::remove(file);
  const auto wrong = writeSvg("this is no graph", file.string());
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().text(), HasSubstr("cannot be drawn: Error: "));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_FALSE(writeSvg(drawPlan(planOf("cmd.layout")), "/no/such/folder/x.svg"));
}

/// A locator that runs, one that is switched off, and a reader of both in another process.
std::vector<ProcessDescription> smallRobot() {
  const TaskDescription ball{"BallLocator", "Kalman", {"BallModel"}, {}};
  std::vector<ProcessDescription> robot(2);
  robot[0].process = "Cognition \"1\"";
  robot[0].tasks = {ball, {"SelfLocator", "disabled", {"RobotPose"}, {}}};
  robot[0].tasks[0].solutions = {{"Kalman", {"BallPercept", "RobotPose"}, {}},
                                 {"Other", {"OdometryData"}, {}}};
  robot[0].tasks[1].solutions = {{"Lines", {"LinesPercept"}, {}}};
  robot[1].process = "Motion";
  robot[1].tasks = {{"HeadControl", "GT2003", {"HeadMotionRequest"}, {}}};
  robot[1].tasks[0].solutions = {{"GT2003", {"BallModel"}, {}}};
  return robot;
}

TEST(ModuleGraph, TellsWhatRunsAndWhereItsInputsComeFrom) {
  EXPECT_EQ(describeModules(smallRobot()),
            "process Cognition \"1\"\n"
            "  BallLocator Kalman\n"
            "    <- BallPercept of outside\n"
            "    <- RobotPose of SelfLocator disabled\n"
            "    -> BallModel\n"
            "  SelfLocator disabled\n"
            "    -> RobotPose\n"
            "process Motion\n"
            "  HeadControl GT2003\n"
            "    <- BallModel of BallLocator Kalman\n"
            "    -> HeadMotionRequest\n");
}

TEST(ModuleGraph, DrawsModulesAndTheRepresentationsBetweenThem) {
  const std::string dot = drawModules(smallRobot());
  EXPECT_THAT(dot, HasSubstr("\"representation BallModel\" -> \"HeadControl\";"));
  EXPECT_THAT(dot, HasSubstr("\"SelfLocator\" -> \"representation RobotPose\" [style=dashed];"));
  EXPECT_THAT(dot, Not(HasSubstr("LinesPercept")));  // of a solution that does not run
  EXPECT_THAT(dot, Not(HasSubstr("OdometryData")));
  const auto file = std::filesystem::temp_directory_path() / "gt2003-modules.svg";
  const auto done = writeSvg(dot, file.string());
  ASSERT_TRUE(done) << done.error().text();
  for (const char* part : {"Kalman", "disabled", "BallPercept", "Cognition &quot;1&quot;"})
    EXPECT_THAT(*readFile(file.string()), HasSubstr(part));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gt
