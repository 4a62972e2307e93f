#include "streams/RecordedMessage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/Enum.h"
#include "base/Random.h"
#include "streams/Binary.h"
#include "streams/MessageQueue.h"
#include "streams/Schema.h"
#include "support/Samples.h"

namespace gt {

namespace then {
enum class Mood { calm, wild, asleep };
enum class Side { left, right };
struct Spot {
  float x = 0;
  int y = 0;
  static constexpr auto fields() { return Fields{field<&Spot::x>(), field<&Spot::y>()}; }
};
struct Report {
  Mood mood = Mood::calm;
  std::int64_t bigNumber = 0;
  double wide = 0;
  bool sure = false;
  std::string note;
  std::vector<Spot> spots;
  EnumArray<Side, int> scores{};
  std::array<std::array<int, 2>, 2> table{};
  int dropped = 0;
  static constexpr auto fields() {
    return Fields{field<&Report::mood>(),   field<&Report::bigNumber>(), field<&Report::wide>(),
                  field<&Report::sure>(),   field<&Report::note>(),      field<&Report::spots>(),
                  field<&Report::scores>(), field<&Report::table>(),     field<&Report::dropped>()};
  }
};
}  // namespace then

namespace now {
enum class Mood { asleep, curious, calm, wild };
enum class Side { right, middle, left };
struct Spot {
  double y = 7;
  double x = 7;
  double z = 7;
  static constexpr auto fields() {
    return Fields{field<&Spot::y>(), field<&Spot::x>(), field<&Spot::z>()};
  }
};
struct Report {
  std::string added = "kept";
  EnumArray<Side, double> scores{{5, 5, 5}};
  std::vector<Spot> spots;
  std::int8_t bigNumber = 0;
  int wide = 0;
  int sure = 0;
  Mood mood = Mood::asleep;
  std::string note;
  std::array<std::array<double, 2>, 3> table{};
  static constexpr auto fields() {
    return Fields{field<&Report::added>(),     field<&Report::scores>(), field<&Report::spots>(),
                  field<&Report::bigNumber>(), field<&Report::wide>(),   field<&Report::sure>(),
                  field<&Report::mood>(),      field<&Report::note>(),   field<&Report::table>()};
  }
};
}  // namespace now

namespace {

using testing::HasSubstr;

MessageDefinition definitionOf(const Schema& schema) {
  auto definition = MessageDefinition::parse(schema.name, schema.text);
  EXPECT_TRUE(definition) << definition.error().text() << "\n" << schema.text;
  return *definition;
}

template <typename T>
std::vector<std::byte> recorded(const T& value) {
  std::vector<std::byte> bytes;
  encode(value, bytes);
  return bytes;
}

then::Report sampleReport() {
  then::Report report;
  report.mood = then::Mood::wild;
  report.bigNumber = 1'000'000'000'000;
  report.wide = -2.6;
  report.sure = true;
  report.note = "as it was";
  report.spots = {{0.1f, 2}, {3, -4}};
  report.scores.values = {11, 22};
  report.table = {{{1, 2}, {3, 4}}};
  report.dropped = 99;
  return report;
}

TEST(RecordedMessage, FillsAChangedTypeByName) {
  now::Report report;
  const auto done =
      readRecorded(definitionOf(schemaOf<then::Report>()), recorded(sampleReport()), report);
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(report.added, "kept");
  EXPECT_EQ(report.mood, now::Mood::wild);
  EXPECT_EQ(report.bigNumber, 127);
  EXPECT_EQ(report.wide, -3);
  EXPECT_EQ(report.sure, 1);
  EXPECT_EQ(report.note, "as it was");
  ASSERT_EQ(report.spots.size(), 2u);
  EXPECT_EQ(report.spots[0].x, static_cast<double>(0.1f));
  EXPECT_EQ(report.spots[1].y, -4);
  EXPECT_EQ(report.spots[1].z, 7);
  EXPECT_EQ(report.scores[now::Side::left], 11);
  EXPECT_EQ(report.scores[now::Side::middle], 5);
  EXPECT_EQ(report.scores[now::Side::right], 22);
  EXPECT_EQ(report.table[1][0], 3);
  EXPECT_EQ(report.table[2][1], 0);
}

TEST(RecordedMessage, KeepsAnEnumerationWhoseValueIsGone) {
  then::Report old;
  old.mood = then::Mood::asleep;
  now::Report report;
  report.mood = now::Mood::curious;
  ASSERT_TRUE(readRecorded(definitionOf(schemaOf<then::Report>()), recorded(old), report));
  EXPECT_EQ(report.mood, now::Mood::asleep);
  now::Report newer;
  newer.mood = now::Mood::curious;
  then::Report older;
  older.mood = then::Mood::wild;
  ASSERT_TRUE(readRecorded(definitionOf(schemaOf<now::Report>()), recorded(newer), older));
  EXPECT_EQ(older.mood, then::Mood::wild);
}

TEST(RecordedMessage, ConvertsNumbersThatDoNotFit) {
  const auto wideOf = [](double wide) {
    then::Report old;
    old.wide = wide;
    now::Report report;
    EXPECT_TRUE(readRecorded(definitionOf(schemaOf<then::Report>()), recorded(old), report));
    return report.wide;
  };
  EXPECT_EQ(wideOf(1e300), std::numeric_limits<int>::max());
  EXPECT_EQ(wideOf(-INFINITY), std::numeric_limits<int>::min());
  EXPECT_EQ(wideOf(NAN), 0);
}

TEST(RecordedMessage, BecomesJson) {
  const auto json = recordedJson(definitionOf(schemaOf<then::Report>()), recorded(sampleReport()));
  ASSERT_TRUE(json) << json.error().text();
  EXPECT_EQ(json->dump(),
            R"({"mood":"WILD","big_number":1000000000000,"wide":-2.6,"sure":true,)"
            R"("note":"as it was","spots":[{"x":0.1,"y":2},{"x":3,"y":-4}],"scores":[11,22],)"
            R"("table":[{"values":[1,2]},{"values":[3,4]}],"dropped":99})");
}

TEST(RecordedMessage, GivesListsOfBytesAsBase64) {
  CompressedImage image;
  const auto dataOf = [&](std::string_view bytes) {
    image.data.assign(bytes.begin(), bytes.end());
    return recordedJson(definitionOf(CompressedImage::schema()), recorded(image))->at("data");
  };
  EXPECT_EQ(dataOf(""), "");
  EXPECT_EQ(dataOf("f"), "Zg==");
  EXPECT_EQ(dataOf("foobar"), "Zm9vYmFy");
  image.header.frameId = "camera";
  image.data.assign(5'000'000, 7);
  CompressedImage again;
  ASSERT_TRUE(readRecorded(definitionOf(CompressedImage::schema()), recorded(image), again));
  EXPECT_EQ(again.header.frameId, "camera");
  EXPECT_EQ(again.data, image.data);
}

TEST(RecordedMessage, ReadsSchemasOfOthers) {
  const auto definition = definitionOf(
      {"other_msgs/msg/Mixed",
       "# a comment\nint32 LIMIT=5\nstring<=10 name \"nobody\"\nfloat32[<=3] values\nEmpty "
       "nothing\n"
       "builtin_interfaces/Time[2] stamps # when\r\nuint8 last 3\n"
       "================\nMSG: other_msgs/Empty\n================\nMSG: builtin_interfaces/Time\n"
       "int32 sec\nuint32 nanosec\n"});
  std::vector<std::byte> bytes(cdr::header, cdr::header + 4);
  const unsigned char body[] = {3, 0, 0,    0, 'h', 'i', 0,   0,   1,   0,   0, 0, 0,
                                0, 0, 0x3f, 0, 0,   0,   0,   1,   0,   0,   0, 2, 0,
                                0, 0, 3,    0, 0,   0,   255, 255, 255, 255, 9};
  for (const unsigned char c : body) bytes.push_back(std::byte{c});
  const auto json = recordedJson(definition, bytes);
  ASSERT_TRUE(json) << json.error().text();
  EXPECT_EQ(json->dump(),
            R"({"name":"hi","values":[0.5],"nothing":{},"stamps":[{"sec":1,"nanosec":2},)"
            R"({"sec":3,"nanosec":4294967295}],"last":9})");
}

TEST(RecordedMessage, TellsWhatIsWrongWithASchema) {
  const auto wrong = [](const std::string& text) {
    const auto definition = MessageDefinition::parse("a_msgs/msg/A", text);
    return definition ? "" : definition.error().text();
  };
  EXPECT_THAT(wrong("int32 x\nB b\n"), HasSubstr("a_msgs/msg/A:2: the schema does not define B"));
  EXPECT_THAT(wrong("int32\n"), HasSubstr("a_msgs/msg/A:1: expected a type and a name"));
  EXPECT_THAT(wrong("int32[x] a\n"), HasSubstr("expected a number"));
  EXPECT_THAT(wrong("int32[3 a\n"), HasSubstr("expected TYPE[]"));
  EXPECT_THAT(wrong("int32[99999999999999999999] a\n"), HasSubstr("expected a number"));
  EXPECT_THAT(wrong("A a\nA b\n"), HasSubstr("nested too deeply"));
  EXPECT_THAT(wrong("B[200000000] b\n===\nMSG: a_msgs/B\nint64[200000000] x\n"),
              HasSubstr("too large"));
}

TEST(RecordedMessage, TellsWhichFieldEndsTooEarly) {
  auto bytes = recorded(sampleReport());
  bytes.resize(bytes.size() - 25);
  now::Report report;
  const auto done = readRecorded(definitionOf(schemaOf<then::Report>()), bytes, report);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().field.substr(0, 6), "scores");
}

/// A type with a range and with something between its fields.
struct Board {
  int width = 2;
  std::vector<int> cells;
  std::vector<samples::Inner> inners;

  std::string_view validationError() const {
    return static_cast<int>(cells.size()) % width == 0 ? "" : "its last row is not whole";
  }
  static constexpr auto fields() {
    return Fields{field<&Board::width>({1, 9}), field<&Board::cells>(), field<&Board::inners>()};
  }
};

TEST(Checked, RefusesWhatATypeDoesNotAllow) {
  const auto wrongIn = [](const Board& board) {
    const auto byName = [&] {
      Board read;
      return readRecorded(definitionOf(schemaOf<Board>()), recorded(board), read);
    }();
    MessageQueue queue;
    queue.write({1}, board);
    Result<void> asMessage;
    queue.handleAllMessages([&](const Message& message) {
      Board read;
      asMessage = message.read(read);
    });
    EXPECT_EQ(byName ? "" : byName.error().text(), asMessage ? "" : asMessage.error().text());
    return asMessage ? "" : asMessage.error().text();
  };
  EXPECT_EQ(wrongIn({}), "");
  EXPECT_EQ(wrongIn({3, {1, 2, 3}, {{true, "", 100}}}), "");
  EXPECT_EQ(wrongIn({2, {1, 2, 3}, {}}), "its last row is not whole");
  EXPECT_EQ(wrongIn({0, {1}, {}}), "width: must be from 1 to 9 instead of 0");
  EXPECT_EQ(wrongIn({1, {}, {{}, {true, "", 100.5}}}),
            "inners.1.value: must be from -100 to 100 instead of 100.5");
  EXPECT_EQ(wrongIn({1, {}, {{true, "", std::nan("")}}}),
            "inners.0.value: must be from -100 to 100 instead of nan");
}

TEST(RecordedMessage, BoundsWhatAMessageBecomes) {
  const auto definition = definitionOf({"a_msgs/msg/A", "B[] many\n===\nMSG: a_msgs/B\n"});
  std::vector<std::byte> bytes(cdr::header, cdr::header + 4);
  const std::uint32_t count = 50'000'000;
  bytes.resize(8 + count);
  std::memcpy(bytes.data() + 4, &count, 4);
  const auto json = recordedJson(definition, bytes);
  ASSERT_FALSE(json);
  EXPECT_THAT(json.error().text(), HasSubstr("too many elements"));
}

}  // namespace
}  // namespace gt
