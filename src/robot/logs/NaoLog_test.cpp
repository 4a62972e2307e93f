#include "robot/logs/NaoLog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/Random.h"
#include "support/TestLog.h"

namespace gt {
namespace {

using testing::HasSubstr;

std::string smallLog() {
  LogBuilder log;
  for (int i = 0; i < 22; ++i) log.put(0.1 * i);
  log.put(std::uint32_t{5000}).end(5);
  log.put(1.5f).fill(142).end(6);
  log.put(0.25).put(100.0).put(-50.0).end(8);
  log.put(std::uint32_t{320})
      .put(std::uint32_t{240})
      .put(std::uint32_t{5010})
      .put(std::uint32_t{7});
  for (const char c : {'n', 'o', ' ', 'J', 'P', 'E', 'G'}) log.put(c);
  log.end(4);
  for (int i = 0; i < 9; ++i) log.put(i % 4 == 0 ? 1.0 : 0.0);
  log.put(50.0).put(0.0).put(480.0).put(std::uint32_t{1}).end(17);
  log.put(1.0).put(0.0).fill(48).put(160.0).put(30.0).fill(80).end(18);
  return log.log();
}

std::string realFile() {
  const char* real = std::getenv("GT_REAL");
  return std::string{real ? real : "../shared/real"} + "/nao2009.log";
}

TEST(NaoLog, ReadsWhatAMessageTells) {
  const auto log = parseNaoLog(smallLog(), "small.log");
  ASSERT_TRUE(log) << log.error().text();
  ASSERT_EQ(log->motionFrames.size(), 1u);
  EXPECT_EQ(log->motionFrames[0].time.ms, 5000);
  EXPECT_DOUBLE_EQ(log->motionFrames[0].joints[3], 0.3);
  EXPECT_FLOAT_EQ(log->motionFrames[0].sensors[0], 1.5f);
  ASSERT_EQ(log->pictures.size(), 1u);
  const NaoImage& picture = log->pictures[0];
  EXPECT_EQ(picture.cameraMatrix.time.ms, 5010);
  EXPECT_EQ(picture.cameraMatrix.info.width, 320);
  EXPECT_DOUBLE_EQ(picture.cameraMatrix.pose.translation.z(), 480);
  EXPECT_TRUE(picture.cameraMatrix.valid);
  EXPECT_DOUBLE_EQ(picture.odometry.rotation, 0.25);
  EXPECT_DOUBLE_EQ(picture.horizon.y(), 30);
}

TEST(NaoLog, NamesTheImageThatCannotBeDecoded) {
  const auto log = parseNaoLog(smallLog(), "small.log");
  ASSERT_TRUE(log);
  Image image;
  const auto done = log->decode(log->pictures[0], image);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), HasSubstr("small.log: byte "));
}

TEST(NaoLog, NamesTheByteThatIsWrong) {
  const std::string good = smallLog();
  EXPECT_THAT(parseNaoLog("", "a.log").error().text(), HasSubstr("a.log: byte 0: the file ends"));
  EXPECT_THAT(parseNaoLog(good.substr(0, good.size() - 1), "a.log").error().text(),
              HasSubstr("the header promises"));
  EXPECT_THAT(parseNaoLog(good + "x", "a.log").error().text(), HasSubstr("the header promises"));
  LogBuilder shortJoints;
  shortJoints.put(1.0).end(5);
  EXPECT_THAT(parseNaoLog(shortJoints.log(), "a.log").error().text(),
              HasSubstr("byte 8: joint angles must have 180 bytes"));
  LogBuilder noPose;
  noPose.put(std::uint32_t{320})
      .put(std::uint32_t{240})
      .put(std::uint32_t{1})
      .put(std::uint32_t{0})
      .end(4);
  noPose.fill(100).end(17);
  EXPECT_THAT(parseNaoLog(noPose.log(), "a.log").error().text(), HasSubstr("no pose"));
  EXPECT_THAT(readNaoLog("no/such.log").error().text(), HasSubstr("no/such.log"));
}

TEST(NaoLog, SurvivesBrokenFiles) {
  const std::string good = smallLog();
  Random random{1};
  for (int i = 0; i < 3000; ++i) {
    std::string bad = good.substr(0, random.chance(0.2) ? random.index(good.size()) : good.size());
    for (std::size_t k = random.index(5); k > 0 && !bad.empty(); --k)
      bad[random.index(bad.size())] = static_cast<char>(random.index(256));
    const auto log = parseNaoLog(bad, "bad");
    if (!log) continue;
    Image image;
    for (const NaoImage& picture : log->pictures) (void)!log->decode(picture, image);
  }
}

TEST(NaoLog, ReadsTheRealRobotsLog) {
  if (!std::filesystem::exists(realFile())) GTEST_SKIP() << "no real robot's log at " << realFile();
  const auto log = readNaoLog(realFile());
  ASSERT_TRUE(log) << log.error().text();
  EXPECT_EQ(log->pictures.size(), 96u);
  EXPECT_EQ(log->motionFrames.size(), 165u);
  Image image;
  for (const NaoImage& picture : log->pictures) {
    const auto done = log->decode(picture, image);
    ASSERT_TRUE(done) << done.error().text();
    // The recorded horizon is that of the recorded camera matrix: our own axes fit that robot's.
    const Vector3d ray = picture.cameraMatrix.pose.rotation *
                         picture.cameraMatrix.info.ray(picture.horizon.x(), picture.horizon.y());
    EXPECT_NEAR(ray.z() / ray.norm(), 0, fromDegrees(0.5)) << picture.number;
  }
}

TEST(NaoLog, SurvivesARealLogWithErrors) {
  if (!std::filesystem::exists(realFile())) GTEST_SKIP() << "no real robot's log at " << realFile();
  std::ifstream stream(realFile(), std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(stream), {}};
  Random random{2};
  Image image;
  for (int i = 0; i < 20; ++i) {
    std::string bad = good;
    for (int k = 0; k < 200; ++k)
      bad[8 + random.index(bad.size() - 8)] = static_cast<char>(random.index(256));
    const auto log = parseNaoLog(bad, "bad");
    if (!log) continue;
    for (const NaoImage& picture : log->pictures) (void)!log->decode(picture, image);
  }
}

}  // namespace
}  // namespace gt
