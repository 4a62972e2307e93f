#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "gtlog/Check.h"
#include "gtlog/Export.h"
#include "gtlog/LogList.h"
#include "observer/LogTransfer.h"
#include "representations/infrastructure/Image.h"
#include "representations/modeling/BallModel.h"
#include "robot/logs/ImportNaoLog.h"
#include "streams/File.h"
#include "streams/Json.h"

namespace gt {
namespace {

using testing::HasSubstr;

/// A folder for a test's logs, one message of each topic every 100 ms.
class GtLog : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path{testing::TempDir()} /
        ("gtlog_" + std::string{testing::UnitTest::GetInstance()->current_test_info()->name()});
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string makeLog(const std::string& name, int offset = 0) const {
    auto writer = McapWriter::open(path(name), {true, 1, 2000});
    writer->metadata("gt2003", {{"seed", "7"}, {"scene", "a, \"quoted\" one"}});
    const std::string note = "a note";
    writer->attachment("note.txt", "text/plain", Time{}, std::as_bytes(std::span{note}));
    for (int i = 0; i < 100; ++i) {
      BallModel ball;
      ball.position = {i * 1.5, -i * 0.25};
      writer->write("/BallModel", Time{i * 100 + offset}, ball);
      writer->write("/Text", Time{i * 100 + offset}, RosHeader{RosTime{i, 0}, "a,\"b\"\nc"});
    }
    EXPECT_TRUE(writer->close());
    return path(name);
  }

  static std::vector<std::int64_t> timesOf(const std::string& log) {
    std::vector<std::int64_t> times;
    const auto done = Selection{}.forEach(log, [&](const auto&, const McapMessage& m) {
      times.push_back(m.time / 1'000'000);
      return Result<void>{};
    });
    EXPECT_TRUE(done) << done.error().text();
    return times;
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(GtLog, ListsWhatIsInALog) {
  const auto text = describeLog(makeLog("a.mcap"));
  ASSERT_TRUE(text) << text.error().text();
  EXPECT_THAT(*text, HasSubstr("200 messages, 0.000 s to 9.900 s\n"));
  EXPECT_THAT(*text, testing::ContainsRegex("/BallModel +gt2003_msgs/msg/BallModel +100 +10.00 "));
  EXPECT_THAT(*text, HasSubstr("    seed: 7\n"));
  EXPECT_THAT(*text, HasSubstr("  attachment note.txt (text/plain): 6 bytes\n"));
}

TEST_F(GtLog, CutsByTimeAndTopic) {
  const std::string log = makeLog("a.mcap");
  Selection selection;
  selection.topics = {"/BallModel"};
  selection.from = 2;
  selection.to = 3;
  const auto cut = cutLog(log, selection, path("b.mcap"));
  ASSERT_TRUE(cut) << cut.error().text();
  EXPECT_EQ(cut->messages, 10u);
  const auto times = timesOf(path("b.mcap"));
  EXPECT_EQ(times.front(), 2000);
  EXPECT_EQ(times.back(), 2900);
  const auto reader = McapReader::open(path("b.mcap"));
  ASSERT_EQ(reader->channels().size(), 1u);
  EXPECT_EQ(reader->metadata().size(), 1u);
  EXPECT_EQ(reader->attachments().size(), 1u);
  selection.topics = {"/NoSuchThing"};
  EXPECT_THAT(cutLog(log, selection, path("c.mcap")).error().text(),
              HasSubstr("/NoSuchThing: the log has no such topic"));
  EXPECT_FALSE(std::filesystem::exists(path("c.mcap")));
  EXPECT_THAT(cutLog(log, {}, log).error().text(), HasSubstr("is the log that is read"));
}

TEST_F(GtLog, CutsNoStretchOfTimeThatIsNone) {
  const std::string log = makeLog("a.mcap");
  Selection selection;
  selection.from = 5;
  selection.to = 1;
  EXPECT_THAT(cutLog(log, selection, path("b.mcap")).error().text(),
              HasSubstr("to: lies not behind"));
  selection.from = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(cutLog(log, selection, path("b.mcap")).error().text(), HasSubstr("from: is no time"));
  EXPECT_FALSE(std::filesystem::exists(path("b.mcap")));
}

TEST_F(GtLog, JoinsByTime) {
  const auto joined =
      joinLogs({makeLog("a.mcap", 5000), makeLog("b.mcap", 50)}, path("joined.mcap"));
  ASSERT_TRUE(joined) << joined.error().text();
  EXPECT_EQ(joined->messages, 400u);
  const auto times = timesOf(path("joined.mcap"));
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_EQ(times.front(), 50);
  EXPECT_EQ(times.back(), 14'900);
  const auto reader = McapReader::open(path("joined.mcap"));
  EXPECT_EQ(reader->channels().size(), 2u);
  ASSERT_EQ(reader->metadata().size(), 2u);
  EXPECT_EQ(reader->metadata()[0].name, "a/gt2003");
}

TEST_F(GtLog, TellsTheTopicsOfSeveralRobotsApart) {
  for (const char* robot : {"red1", "blue2"}) {
    auto writer = McapWriter::open(path(std::string{robot} + ".mcap"));
    writer->metadata("gt2003", {{"robot", robot}});
    writer->write("/BallModel", Time{40}, BallModel{});
    ASSERT_TRUE(writer->close());
  }
  ASSERT_TRUE(joinLogs({path("red1.mcap"), path("blue2.mcap")}, path("both.mcap")));
  const auto both = McapReader::open(path("both.mcap"));
  ASSERT_EQ(both->channels().size(), 2u);
  EXPECT_EQ(both->channels()[0].topic, "/red1/BallModel");
  EXPECT_EQ(both->channels()[1].topic, "/blue2/BallModel");
  ASSERT_TRUE(joinLogs({path("red1.mcap"), path("red1.mcap")}, path("same.mcap")));
  EXPECT_EQ(McapReader::open(path("same.mcap"))->channels()[0].topic, "/BallModel");
}

TEST_F(GtLog, ChecksAndRepairsALogThatIsCutOff) {
  const std::string log = makeLog("a.mcap");
  const auto good = checkLog(log);
  ASSERT_TRUE(good);
  EXPECT_EQ(good->messages, 200u);
  EXPECT_TRUE(good->problems.empty());

  std::string bytes = *readFile(log);
  ASSERT_TRUE(writeFile(path("cut.mcap"), bytes.substr(0, bytes.size() / 2)));
  const auto cut = checkLog(path("cut.mcap"));
  ASSERT_TRUE(cut);
  EXPECT_FALSE(cut->problems.empty());
  const auto repaired = repairLog(path("cut.mcap"), path("good.mcap"));
  ASSERT_TRUE(repaired) << repaired.error().text();
  EXPECT_EQ(repaired->messages, cut->messages);
  EXPECT_GT(repaired->messages, 50u);
  EXPECT_EQ(repaired->lost.size(), 1u);
  const auto again = checkLog(path("good.mcap"));
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->problems.empty());
  EXPECT_EQ(again->messages, cut->messages);
}

TEST_F(GtLog, ExportsJsonLines) {
  Selection selection;
  selection.topics = {"/BallModel"};
  const auto done = exportLog(makeLog("a.mcap"), selection, path("out.json"));
  ASSERT_TRUE(done) << done.error().text();
  const std::string text = *readFile(path("out.json"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 100);
  const auto line = parseJson(text.substr(0, text.find('\n')), "line");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->at("topic"), "/BallModel");
  const auto last = parseJson(text.substr(text.rfind('\n', text.size() - 2) + 1), "line");
  EXPECT_EQ(last->at("time"), 9'900'000'000);
  EXPECT_EQ(last->at("message").at("position").at("x"), 148.5);
}

TEST_F(GtLog, TellsThatTheLogIsDamagedBehindWhatItExports) {
  const std::string bytes = *readFile(makeLog("a.mcap"));
  ASSERT_TRUE(writeFile(path("cut.mcap"), bytes.substr(0, bytes.size() / 2)));
  const auto cut = exportLog(path("cut.mcap"), {}, path("cut.json"));
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().text(), HasSubstr("cut.mcap: "));
  EXPECT_THAT(cut.error().text(), HasSubstr("the log ends within a record"));
  EXPECT_THAT(*readFile(path("cut.json")), HasSubstr("/BallModel"));

  // A record behind the header that claims to be as long as can be.
  const std::size_t header = 8 + 1 + 8 + 4 + 4 + 4 + 6;
  ASSERT_TRUE(
      writeFile(path("long.mcap"), bytes.substr(0, header) + '\5' + std::string(8, '\xff')));
  EXPECT_FALSE(exportJson(path("long.mcap"), {}, stdout, "standard output", 0));
}

TEST_F(GtLog, ExportsCsv) {
  const std::string log = makeLog("a.mcap");
  ASSERT_TRUE(exportLog(log, {}, path("tables")));
  const std::string ball = *readFile(path("tables/BallModel.csv"));
  EXPECT_EQ(ball.substr(0, 27), "time,position.x,position.y,");
  EXPECT_THAT(ball, HasSubstr("\n9.900000000,148.5,-24.75,"));
  const std::string text = *readFile(path("tables/Text.csv"));
  EXPECT_THAT(text, testing::StartsWith("time,stamp.sec,stamp.nanosec,frame_id\n"
                                        "0.000000000,0,0,\"a,\"\"b\"\"\nc\"\n"));
  EXPECT_THAT(exportLog(log, {}, path("one.csv")).error().text(), HasSubstr("of one topic"));
}

TEST_F(GtLog, ExportsTablesOfAllThatMakesOne) {
  auto writer = McapWriter::open(path("wide.mcap"));
  Image image;
  image.allocate();
  writer->write("/Image", Time{40}, image);
  writer->write("/BallModel", Time{40}, BallModel{});
  ASSERT_TRUE(writer->close());
  const auto left = exportLog(path("wide.mcap"), {}, path("tables"));
  ASSERT_TRUE(left) << left.error().text();
  ASSERT_EQ(left->size(), 1u);
  EXPECT_THAT(left->front().text(), HasSubstr("/Image: would have more than 10000 columns"));
  EXPECT_TRUE(std::filesystem::exists(path("tables/BallModel.csv")));
  EXPECT_FALSE(std::filesystem::exists(path("tables/Image.csv")));
}

TEST_F(GtLog, TellsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  std::filesystem::create_symlink("/dev/full", path("full.json"));
  const auto done = exportLog(makeLog("a.mcap"), {}, path("full.json"));
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), HasSubstr("full.json: cannot be written: No space left"));
}

TEST_F(GtLog, ImportsTheRealRobotsLog) {
  const char* real = std::getenv("GT_REAL");
  const std::string file = std::string{real ? real : "../shared/real"} + "/nao2009.log";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real robot's log at " << file;
  const auto done = importNaoLog(file, path("nao.mcap"));
  ASSERT_TRUE(done) << done.error().text();
  const auto check = checkLog(path("nao.mcap"));
  ASSERT_TRUE(check);
  EXPECT_EQ(check->messages, 4u * 96 + 165);
  EXPECT_TRUE(check->problems.empty());
}

}  // namespace
}  // namespace gt
