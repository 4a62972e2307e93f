#include "logs/NaoLog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/File.h"
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
  EXPECT_THAT(done.error().text(), HasSubstr("small.log: image 0 at 5.010 s: "));
}

/// The text of the first thing that is damaged in a log of which other things are whole.
std::string damageOf(const std::string& bytes) {
  const auto log = parseNaoLog(bytes, "a.log");
  EXPECT_TRUE(log) << log.error().text();
  return log && !log->damage.empty() ? log->damage.front().text() : "";
}

TEST(NaoLog, ReadsWhatIsWhole) {
  const std::string good = smallLog();
  EXPECT_EQ(damageOf(good), "");
  const std::size_t last = 4 + 160;  // of its messages, with its header
  for (const std::size_t missing : {std::size_t{1}, last - 4, last - 1}) {
    const auto log = parseNaoLog(good.substr(0, good.size() - missing), "a.log");
    ASSERT_TRUE(log) << log.error().text();
    EXPECT_EQ(log->motionFrames.size(), 1u);
    ASSERT_EQ(log->pictures.size(), 1u);
    EXPECT_DOUBLE_EQ(log->pictures[0].cameraMatrix.pose.translation.z(), 480);
    ASSERT_EQ(log->damage.size(), 1u);
    EXPECT_EQ(log->damage[0].text(),
              "a.log: message 5 after 5.010 s: the log is cut off; what followed is lost");
  }
  EXPECT_THAT(damageOf(good + "x"), HasSubstr("after 5.010 s: something follows"));
}

TEST(NaoLog, TellsItsFilesFromOthers) {
  const std::string path = testing::TempDir() + "NaoLog_test.log";
  const auto is = [&](const std::string& content) {
    std::ofstream{path, std::ios::binary} << content;
    return isNaoLog(path);
  };
  EXPECT_TRUE(is(smallLog()));
  EXPECT_TRUE(is(smallLog().substr(0, 100)));
  EXPECT_FALSE(is(""));
  EXPECT_FALSE(is("a text that somebody calls a log, longer than its header\n"));
  // An MCAP file: its first record, the header, has 20 bytes.
  EXPECT_FALSE(is(std::string{"\x89MCAP0\r\n\1\x14\0\0\0\0\0\0\0", 17} + std::string(20, 'x')));
  EXPECT_FALSE(isNaoLog("no/such.log"));
  std::filesystem::remove(path);
}

TEST(NaoLog, NamesTheMessageThatIsWrong) {
  EXPECT_EQ(parseNaoLog("", "a.log").error().text(), "a.log: the file ends within its header");
  LogBuilder shortJoints;
  shortJoints.put(1.0).end(5);
  EXPECT_THAT(parseNaoLog(shortJoints.log(), "a.log").error().text(),
              HasSubstr("a.log: joint angles must have 180 bytes"));
  LogBuilder noPose;
  noPose.put(std::uint32_t{320})
      .put(std::uint32_t{240})
      .put(std::uint32_t{1})
      .put(std::uint32_t{0})
      .end(4);
  noPose.fill(100).end(17);
  EXPECT_THAT(damageOf(noPose.log()),
              HasSubstr("message 1 after 0.001 s: a camera matrix that is no pose"));
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
