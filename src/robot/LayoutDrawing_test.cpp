#include "robot/LayoutDrawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "robot/Robot.h"
#include "streams/File.h"

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
  EXPECT_THAT(cmd, HasSubstr("  Platform -> Cognition, starts a cycle: Image, "));
  EXPECT_THAT(cmd, HasSubstr("  Cognition -> Motion: "));
  EXPECT_THAT(cmd, HasSubstr("  Motion -> Platform: LedValue, JointData, OdometryData"));
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
  EXPECT_FALSE(writeSvg("this is no graph", file.string()));
  EXPECT_FALSE(writeSvg(drawPlan(planOf("cmd.layout")), "/no/such/folder/x.svg"));
}

}  // namespace
}  // namespace gt
