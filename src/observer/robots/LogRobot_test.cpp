#include "observer/robots/LogRobot.h"

#include <gtest/gtest.h>

#include <string>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "support/TestLog.h"

namespace gt {
namespace {

/// A robot runs on a log of 2009 as on a log of ours, which it becomes in a temporary folder.
TEST(LogRobot, NamesTheFileInErrorsOfItsRobot) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "joints.log").string();
  LogBuilder log;
  for (int i = 0; i < 22; ++i) log.put(0.1);
  log.put(std::uint32_t{5000}).end(5);
  ASSERT_TRUE(writeFile(path, log.log()));
  const auto robot = LogRobot::open(path, {});
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.error().text(), path + ": /input/: the log does not hold what its robot sensed");
}

}  // namespace
}  // namespace gt
