#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/File.h"
#include "gtlog/Check.h"
#include "gtlog/Export.h"
#include "gtlog/LogList.h"
#include "logs/ImportNaoLog.h"
#include "logs/LogTransfer.h"
#include "representations/infrastructure/Image.h"
#include "representations/modeling/BallModel.h"
#include "streams/Json.h"
#include "support/McapConformance.h"
#include "support/McapVariants.h"

namespace gt {
namespace {

using testing::ElementsAre;
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

  static std::vector<std::uint64_t> timesOf(const std::string& log) {
    std::vector<std::uint64_t> times;
    std::vector<Error> damage;
    const auto done = Selection{}.forEach(
        log,
        [&](const auto&, const McapMessage& m) {
          times.push_back(m.time / 1'000'000);
          return Result<void>{};
        },
        damage);
    EXPECT_TRUE(done) << done.error().text();
    EXPECT_TRUE(damage.empty());
    return times;
  }
  /// All that is in a log.
  static std::string contentOf(const std::string& log) {
    auto reader = McapReader::open(log);
    EXPECT_TRUE(reader) << reader.error().text();
    return variants::textOf(variants::readContent(*reader));
  }
  /// What was left out, without the logs' folder.
  std::vector<std::string> textsOf(const std::vector<Error>& left) const {
    std::vector<std::string> texts;
    for (const Error& error : left)
      texts.push_back(error.text().substr(folder_.string().size() + 1));
    return texts;
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(GtLog, ListsWhatIsInALog) {
  std::vector<Error> damage;
  const auto text = describeLog(makeLog("a.mcap"), damage);
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
  ASSERT_TRUE(cut) << cut.error().text();
  EXPECT_THAT(textsOf(*cut), ElementsAre(testing::MatchesRegex(
                                 "cut.mcap: after [0-9.]+ s: the log is cut off; what followed "
                                 "is lost")));
  EXPECT_THAT(*readFile(path("cut.json")), HasSubstr("/BallModel"));

  // A record behind the header that claims to be as long as can be.
  const std::size_t header = 8 + 1 + 8 + 4 + 4 + 4 + 6;
  ASSERT_TRUE(
      writeFile(path("long.mcap"), bytes.substr(0, header) + '\5' + std::string(8, '\xff')));
  const auto left = exportJson(path("long.mcap"), {}, stdout, "standard output", 0);
  ASSERT_TRUE(left);
  EXPECT_THAT(textsOf(*left), ElementsAre("long.mcap: the log is cut off; what followed is lost"));
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

/// Whatever form a log has, what is made of it holds the same.
TEST_F(GtLog, KeepsAllThatALogHolds) {
  const std::string log = path("variant.mcap"), copy = path("copy.mcap");
  for (const unsigned features : variants::allVariants()) {
    std::filesystem::remove(log);  // to replace a file may take its time
    ASSERT_TRUE(writeFile(log, variants::logWith(features)));
    const std::string expected = variants::textOf(variants::contentOf(features));
    const std::size_t lost = (features & variants::endMagic) != 0 ? 0 : 1;
    for (int way = 0; way < 3; ++way) {
      std::filesystem::remove(copy);
      const auto done = way == 0   ? cutLog(log, {}, copy)
                        : way == 1 ? joinLogs({log}, copy)
                                   : repairLog(log, copy);
      ASSERT_TRUE(done) << features << done.error().text();
      ASSERT_EQ(done->messages, 16u) << features;
      ASSERT_EQ(done->lost.size(), lost) << features << done->lost.front().text();
      ASSERT_EQ(contentOf(copy), expected) << features;
    }
    const auto check = checkLog(log);
    ASSERT_TRUE(check) << features;
    ASSERT_EQ(check->messages, 16u) << features;
    ASSERT_EQ(check->problems.size(), lost) << features << check->problems.front().text();
    ASSERT_EQ(check->unchecked.size(), 2u) << features;
    std::vector<Error> damage;
    const auto list = describeLog(log, damage);
    ASSERT_TRUE(list) << features;
    ASSERT_EQ(damage.size(), lost) << features;
    ASSERT_THAT(*list, HasSubstr(" bytes, 16 messages, 1.000 s to 18446744073.709 s")) << features;
    ASSERT_THAT(*list, HasSubstr("attachment note.txt (text/plain): 6 bytes")) << features;
    ASSERT_THAT(*list, HasSubstr("metadata second")) << features;
  }
}

TEST_F(GtLog, KeepsAllThatTheLogsOfTheConformanceTestsHold) {
  const std::string log = path("conformance.mcap"), copy = path("copy.mcap");
  for (const variants::ConformanceLog& one : variants::conformanceLogs()) {
    std::filesystem::remove(log);
    ASSERT_TRUE(writeFile(log, one.bytes));
    for (int way = 0; way < 3; ++way) {
      std::filesystem::remove(copy);
      const auto done = way == 0   ? cutLog(log, {}, copy)
                        : way == 1 ? joinLogs({log}, copy)
                                   : repairLog(log, copy);
      ASSERT_TRUE(done) << one.name << done.error().text();
      ASSERT_THAT(done->lost, testing::IsEmpty()) << one.name << done->lost.front().text();
      ASSERT_EQ(contentOf(copy), variants::textOf(one.content)) << one.name;
    }
    for (const std::string& file : {log, copy}) {
      const auto check = checkLog(file);
      ASSERT_TRUE(check) << one.name;
      ASSERT_THAT(check->problems, testing::IsEmpty())
          << one.name << check->problems.front().text();
    }
    std::vector<Error> damage;
    ASSERT_TRUE(describeLog(log, damage)) << one.name;
    ASSERT_THAT(damage, testing::IsEmpty()) << one.name;
  }
}

TEST_F(GtLog, ShowsAndExportsWhatCanBeReadOfEachLog) {
  const std::string log = path("variant.mcap");
  std::string shown;
  for (const unsigned features : variants::allVariants()) {
    std::filesystem::remove(log);
    std::filesystem::remove(path("shown.json"));
    ASSERT_TRUE(writeFile(log, variants::logWith(features)));
    const auto left = exportLog(log, {}, path("shown.json"));
    ASSERT_TRUE(left) << features << left.error().text();
    auto texts = textsOf(*left);
    if ((features & variants::endMagic) == 0) {
      EXPECT_THAT(texts.front(), HasSubstr("the last bytes of the log are missing"));
      texts.erase(texts.begin());
    }
    ASSERT_THAT(texts,
                ElementsAre("variant.mcap: /json: 4 messages from 1.000 s to 18446744073.709 s "
                            "cannot be read: the encoding is json with a schema in jsonschema, not "
                            "cdr with one in ros2msg",
                            "variant.mcap: /plain: 4 messages from 1.000 s to 18446744073.709 s "
                            "cannot be read: the encoding is text with no schema, not cdr with one "
                            "in ros2msg"))
        << features;
    if (shown.empty()) shown = *readFile(path("shown.json"));
    ASSERT_EQ(*readFile(path("shown.json")), shown) << features;
  }
  EXPECT_EQ(std::count(shown.begin(), shown.end(), '\n'), 8);
  EXPECT_THAT(shown, HasSubstr("\"time\":18446744073709551614"));
}

TEST_F(GtLog, OrdersTimesOfAll64Bits) {
  ASSERT_TRUE(writeFile(path("far.mcap"), variants::logWith(variants::allFeatures)));
  Selection selection;
  selection.to = 4;
  const auto cut = cutLog(path("far.mcap"), selection, path("near.mcap"));
  ASSERT_TRUE(cut) << cut.error().text();
  EXPECT_EQ(cut->messages, 12u);
  selection.from = 1e10;
  selection.to.reset();
  const auto rest = cutLog(path("far.mcap"), selection, path("rest.mcap"));
  ASSERT_TRUE(rest) << rest.error().text();
  EXPECT_EQ(rest->messages, 4u);
}

TEST_F(GtLog, JoinsWhatLogsDescribeInTheSameWords) {
  ASSERT_TRUE(writeFile(path("a.mcap"), variants::logWith(variants::allFeatures)));
  ASSERT_TRUE(writeFile(path("b.mcap"), variants::logWith(variants::endMagic | variants::pads)));
  const auto joined = joinLogs({path("a.mcap"), path("b.mcap")}, path("c.mcap"));
  ASSERT_TRUE(joined) << joined.error().text();
  EXPECT_EQ(joined->messages, 32u);
  EXPECT_TRUE(joined->lost.empty());
  const auto reader = McapReader::open(path("c.mcap"));
  EXPECT_EQ(reader->channels().size(), 4u) << "two of /a, as each of the logs has";
  EXPECT_EQ(reader->schemas().size(), 2u);
  EXPECT_EQ(reader->header().profile, "a profile");
  ASSERT_TRUE(McapWriter::open(path("ours.mcap"))->close());
  const auto mixed = joinLogs({path("a.mcap"), path("ours.mcap")}, path("d.mcap"));
  ASSERT_TRUE(mixed) << mixed.error().text();
  EXPECT_EQ(McapReader::open(path("d.mcap"))->header().library, "a library 1.0; gt2003");
  ASSERT_EQ(mixed->lost.size(), 1u);
  EXPECT_THAT(mixed->lost[0].text(), HasSubstr("ours.mcap: header: differs from that of "));
}

TEST_F(GtLog, ADamagedChunkLosesItselfOnly) {
  std::string bytes = variants::logWith(variants::allFeatures & ~variants::outside);
  const auto second = bytes.find(variants::number(1));
  bytes[second + 4] = static_cast<char>(bytes[second + 4] + 1);
  ASSERT_TRUE(writeFile(path("bad.mcap"), bytes));
  const std::string line =
      "bad.mcap: 2.000 s: the chunk's checksum is wrong; its messages are lost";
  Selection numbers;
  numbers.topics = {"/a"};
  const auto left = exportLog(path("bad.mcap"), numbers, path("bad.json"));
  ASSERT_TRUE(left) << left.error().text();
  EXPECT_THAT(textsOf(*left), ElementsAre(line));
  const std::string json = *readFile(path("bad.json"));
  EXPECT_EQ(std::count(json.begin(), json.end(), '\n'), 6);
  const auto tables = exportLog(path("bad.mcap"), numbers, path("tables"));
  ASSERT_TRUE(tables) << tables.error().text();
  EXPECT_THAT(textsOf(*tables), ElementsAre(line)) << "once, though it is read twice";
  const auto cut = cutLog(path("bad.mcap"), {}, path("cut.mcap"));
  ASSERT_TRUE(cut) << cut.error().text();
  EXPECT_EQ(cut->messages, 12u);
  EXPECT_THAT(textsOf(cut->lost), ElementsAre(line));
  const auto check = checkLog(path("bad.mcap"));
  ASSERT_TRUE(check);
  EXPECT_THAT(textsOf(check->problems), ElementsAre(line));
  std::vector<Error> damage;
  ASSERT_TRUE(describeLog(path("bad.mcap"), damage));
  EXPECT_THAT(textsOf(damage), ElementsAre(line));
}

TEST_F(GtLog, AnUnreadableChannelLosesItselfOnly) {
  auto writer = McapWriter::open(path("mixed.mcap"));
  const auto add = [&](const char* topic, const char* text) {
    McapChannel channel;
    channel.topic = topic;
    channel.messageEncoding = "cdr";
    channel.schema = writer->addSchema({0, "own_msgs/msg/Some", "ros2msg", text});
    return writer->addChannel(channel);
  };
  const auto unknown = add("/unknown", "foo/Bar b\n"), good = add("/good", "int32 data\n"),
             big = add("/big", "int32 other\n");
  for (int i = 0; i < 3; ++i) {
    const std::string data = variants::number(i);
    const auto time = nanoseconds(Time{1000 * (i + 1)});
    writer->write(unknown, time, std::as_bytes(std::span{data}));
    writer->write(good, time, std::as_bytes(std::span{data}));
    writer->write(big, time, std::as_bytes(std::span{"\0\0\0\0\0\0\0\1", 8}));
  }
  ASSERT_TRUE(writer->close());
  const auto left = exportLog(path("mixed.mcap"), {}, path("mixed.json"));
  ASSERT_TRUE(left) << left.error().text();
  EXPECT_THAT(textsOf(*left),
              ElementsAre(HasSubstr("mixed.mcap: /unknown: 3 messages from 1.000 s to 3.000 s "
                                    "cannot be read: "),
                          "mixed.mcap: /big: 3 messages from 1.000 s to 3.000 s cannot be read: "
                          "begins with 00 00 00 00; expected little endian CDR, which begins with "
                          "00 01 00 00"));
  const std::string json = *readFile(path("mixed.json"));
  EXPECT_EQ(std::count(json.begin(), json.end(), '\n'), 3);
  const auto tables = exportLog(path("mixed.mcap"), {}, path("tables"));
  ASSERT_TRUE(tables) << tables.error().text();
  EXPECT_EQ(tables->size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(path("tables/good.csv")));
  EXPECT_FALSE(std::filesystem::exists(path("tables/big.csv")));
  const auto check = checkLog(path("mixed.mcap"));
  ASSERT_TRUE(check);
  EXPECT_EQ(check->problems.size(), 2u);
}

TEST_F(GtLog, LeavesNoHalfFiles) {
  const std::string log = makeLog("a.mcap");
  ASSERT_TRUE(writeFile(path("old.csv"), "what was there"));
  Selection selection;
  selection.topics = {"/NoSuchThing"};
  EXPECT_FALSE(exportLog(log, selection, path("new.json")));
  EXPECT_FALSE(exportLog(log, selection, path("old.csv")));
  EXPECT_EQ(*readFile(path("old.csv")), "what was there");
  for (const auto& entry : std::filesystem::directory_iterator{path("")})
    EXPECT_THAT(entry.path().filename(), testing::AnyOf("a.mcap", "old.csv"));
}

TEST_F(GtLog, ExportsTopicsOfTheSameFileNameOnce) {
  auto writer = McapWriter::open(path("names.mcap"));
  writer->write("/a/b", Time{1}, BallModel{});
  writer->write("/a.b", Time{1}, BallModel{});
  ASSERT_TRUE(writer->close());
  const auto left = exportLog(path("names.mcap"), {}, path("tables"));
  ASSERT_TRUE(left) << left.error().text();
  EXPECT_THAT(textsOf(*left), ElementsAre("names.mcap: /a.b: a.b.csv is that of another topic"));
}

TEST_F(GtLog, ImportsTheRealRobotsLog) {
  const char* real = std::getenv("GT_REAL");
  const std::string file = std::string{real ? real : "../shared/real"} + "/nao2009.log";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real robot's log at " << file;
  const auto done = importNaoLog(file, path("nao.mcap"));
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_TRUE(done->empty());
  const auto check = checkLog(path("nao.mcap"));
  ASSERT_TRUE(check);
  EXPECT_EQ(check->messages, 4u * 96 + 165);
  EXPECT_TRUE(check->problems.empty());
}

}  // namespace
}  // namespace gt
