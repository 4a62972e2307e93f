#include "streams/Config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "streams/Binary.h"
#include "support/Samples.h"

namespace gt {
namespace {

using samples::Everything;
using samples::Inner;
using testing::HasSubstr;

template <typename T>
std::string errorOf(std::string_view text, T value = {}) {
  const auto result = parseConfig(text, "test.cfg", value);
  return result ? "none" : result.error().text();
}

enum class Role { goalie, defender, striker1, striker2 };
enum class Team { red, blue };

struct PlayerFile {
  Team teamColor = Team::red;
  Role playerRole = Role::goalie;
  static constexpr auto fields() {
    return Fields{field<&PlayerFile::teamColor>(), field<&PlayerFile::playerRole>()};
  }
};

struct BodyOffsets {
  double bodyTiltOffset = 0, bodyRollOffset = 1;
  static constexpr auto fields() {
    return Fields{field<&BodyOffsets::bodyTiltOffset>(), field<&BodyOffsets::bodyRollOffset>()};
  }
};

TEST(Config, ReadsPlayerCfgAsPrinted) {
  PlayerFile player;
  ASSERT_TRUE(
      parseConfig("// teamColor red | blue\nteamColor blue\n"
                  "// playerRole goalie | defender | striker1 | striker2\n"
                  "playerRole striker2\n",
                  "player.cfg", player));
  EXPECT_EQ(player.teamColor, Team::blue);
  EXPECT_EQ(player.playerRole, Role::striker2);
}

TEST(Config, ReadsOneSectionOfRobotCfg) {
  const std::string text =
      "[00022D1F626A]\nbodyTiltOffset 1\n[00022D1F626B]\nbodyTiltOffset 0.06\nbodyRollOffset 0\n";
  BodyOffsets offsets;
  ASSERT_TRUE(parseConfig(text, "robot.cfg", offsets, {"00022D1F626B"}));
  EXPECT_EQ(offsets.bodyTiltOffset, 0.06);
  EXPECT_EQ(offsets.bodyRollOffset, 0);
  const auto result = parseConfig(text, "robot.cfg", offsets, {"000000000000"});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().text(), "robot.cfg: [000000000000]: there is no such section");
}

TEST(Config, ReadsAllForms) {
  Everything e;
  const auto result = parseConfig(
      "# comment\r\n"
      "int32 = -3 // minus three\n"
      "float64 1e-3# no comment begins inside a word\n",
      "test.cfg", e);
  EXPECT_FALSE(result);
  const auto good = parseConfig(
      "int32 = -3 // minus three\n"
      "uint8=200\n\n"
      "color skyblue\n"
      "text tcp://localhost:1 and more   # the address\n"
      "doubles 1 2 +3\n"
      "ints 1 2 3 4\n"
      "points 1 2 3  4 5 6\n"
      "pose2 0.5 100 -100\n"
      "texts \"one word\" two \"\"\n"
      "byColor.green 0.7\n"
      "inners.1.text \"a \\\"b\\\" // c\"\n"
      "list.0.value 1\n"
      "list.1.value 2\n"
      "[inner]\n"
      "value 5\n"
      "flag true\n",
      "test.cfg", e);
  ASSERT_TRUE(good) << good.error().text();
  EXPECT_EQ(e.int32, -3);
  EXPECT_EQ(e.uint8, 200);
  EXPECT_EQ(e.color, samples::Color::skyblue);
  EXPECT_EQ(e.text, "tcp://localhost:1 and more");
  EXPECT_EQ(e.doubles, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(e.ints, (std::vector<int>{1, 2, 3, 4}));
  ASSERT_EQ(e.points.size(), 2u);
  EXPECT_EQ(e.points[1], Vector3d(4, 5, 6));
  EXPECT_EQ(e.pose2.translation, Vector2d(100, -100));
  EXPECT_EQ(e.texts, (std::vector<std::string>{"one word", "two", ""}));
  EXPECT_EQ(e.byColor[samples::Color::green], 0.7);
  EXPECT_EQ(e.inners[1].text, "a \"b\" // c");
  ASSERT_EQ(e.list.size(), 2u);
  EXPECT_EQ(e.list[1].value, 2);
  EXPECT_EQ(e.inner.value, 5);
  EXPECT_TRUE(e.inner.flag);
}

TEST(Config, TellsEveryKindOfError) {
  EXPECT_EQ(errorOf<Inner>("flag true\nvlaue 1"),
            "test.cfg:2: vlaue: unknown name; Inner has flag, text, value");
  EXPECT_EQ(errorOf<Inner>("value x"), "test.cfg:1: value: expected a number instead of x");
  EXPECT_EQ(errorOf<Inner>("value"), "test.cfg:1: value: its value is missing");
  EXPECT_EQ(errorOf<Inner>("value 1 2"), "test.cfg:1: value: expected 1 value instead of 2");
  EXPECT_EQ(errorOf<Inner>("value 101"),
            "test.cfg:1: value: must be from -100 to 100 instead of 101");
  EXPECT_THAT(errorOf<Inner>("value nan"), HasSubstr("must be from -100 to 100"));
  EXPECT_EQ(errorOf<Inner>("value 1\nvalue 2"), "test.cfg:2: value: is given twice");
  EXPECT_THAT(errorOf<Inner>("flag maybe"), HasSubstr("flag: expected true | false"));
  EXPECT_THAT(errorOf<Everything>("color blue"),
              HasSubstr("color: expected red | skyblue | green instead of blue"));
  EXPECT_THAT(errorOf<Everything>("int32 1.5"), HasSubstr("int32: expected a whole number"));
  EXPECT_THAT(errorOf<Everything>("uint8 256"), HasSubstr("uint8: is too large a number"));
  EXPECT_THAT(errorOf<Everything>("inner 1"), HasSubstr("inner: is a group of fields"));
  EXPECT_THAT(errorOf<Everything>("[iner]\nvalue 1"), HasSubstr("test.cfg:1: iner: unknown name"));
  EXPECT_THAT(errorOf<Everything>("[inner\nvalue 1"), HasSubstr("expected [section]"));
  EXPECT_THAT(errorOf<Everything>("points 1 2"), HasSubstr("points: expected a multiple of 3"));
  EXPECT_THAT(errorOf<Everything>("inners.2.flag 1"), HasSubstr("there is no element 2, only 2"));
  EXPECT_THAT(errorOf<Everything>("list.1.flag 1"), HasSubstr("there is no element 1, only 0"));
  EXPECT_THAT(errorOf<Everything>("int32.x 1"), HasSubstr("not a group"));
  EXPECT_THAT(errorOf<Inner>("text \"a"), HasSubstr("text: the closing quote is missing"));
  EXPECT_THAT(errorOf<Inner>("= 5"), HasSubstr("expected a name"));
}

// A section that is wrong is one error, not one for each of its lines.
TEST(Config, CollectsAllErrors) {
  Everything value;
  const Findings findings = collectConfig(
      "int32 x\nuint8 3\n[iner]\nvalue 1\nflag true\n[inner]\nvalue 1000\nflag true\n", "test.cfg",
      value);
  EXPECT_EQ(findings.errors(), 3u) << findings.text();
  EXPECT_THAT(findings.text(), HasSubstr("test.cfg:1: int32: "));
  EXPECT_THAT(findings.text(), HasSubstr("test.cfg:3: iner: "));
  EXPECT_THAT(findings.text(), HasSubstr("test.cfg:7: inner.value: "));
  EXPECT_EQ(value.uint8, Everything{}.uint8);
}

// What stands before the first section is common to all.
TEST(Config, ReadsWhatIsCommon) {
  Inner inner;
  EXPECT_TRUE(
      collectConfig("value 5\n[other]\nnonsense 1\n", "test.cfg", inner, {.common = true}).empty());
  EXPECT_EQ(inner.value, 5);
}

TEST(Config, LeavesTheLastGoodStateStanding) {
  Inner inner{true, "old", 3};
  EXPECT_FALSE(parseConfig("text new\nvalue 1000\n", "test.cfg", inner));
  EXPECT_EQ(inner.text, "old");
  EXPECT_FALSE(setByPath(inner, "value", "1000"));
  EXPECT_EQ(inner.value, 3);
}

TEST(Config, ReadsWhatItWrote) {
  Random random{4};
  for (int i = 0; i < 300; ++i) {
    Everything value, read;
    samples::randomize(valueOf(value), random);
    const std::string text = writeConfig(value);
    const auto result = parseConfig(text, "test.cfg", read);
    ASSERT_TRUE(result) << result.error().text() << '\n' << text;
    std::vector<std::byte> a, b;
    encode(value, a);
    encode(read, b);
    ASSERT_EQ(a, b) << text;
  }
}

TEST(Config, SurvivesMutatedText) {
  Random random{5};
  Everything value;
  samples::randomize(valueOf(value), random);
  const std::string good = writeConfig(value);
  int failures = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string bad = good.substr(0, random.index(good.size() + 1));
    for (int k = 0; k < 3 && !bad.empty(); ++k)
      bad[random.index(bad.size())] = static_cast<char>(random());
    Everything read;
    failures += parseConfig(bad, "test.cfg", read) ? 0 : 1;
  }
  EXPECT_GT(failures, 1000);
}

TEST(Config, ReadsFiles) {
  const std::string path = testing::TempDir() + "Config_test.cfg";
  ASSERT_TRUE(writeFile(path, "value 7\n"));
  Inner inner;
  ASSERT_TRUE(readConfig(path, inner));
  EXPECT_EQ(inner.value, 7);
  std::filesystem::remove(path);
  const auto result = readConfig(path, inner);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().text(), path + ": there is no such file");
  EXPECT_FALSE(readConfig("/dev/zero", inner));
  EXPECT_FALSE(readConfig(testing::TempDir(), inner));
}

TEST(Paths, ListGetAndSet) {
  Everything e;
  ASSERT_TRUE(setByPath(e, "inner.value", " 0.25 "));
  EXPECT_EQ(*getByPath(e, "inner.value"), "0.25");
  ASSERT_TRUE(setByPath(e, "vector3", "1 2 3"));
  EXPECT_EQ(*getByPath(e, "vector3"), "1 2 3");
  EXPECT_EQ(*getByPath(e, "vector3.y"), "2");
  EXPECT_FALSE(getByPath(e, "inner"));
  EXPECT_FALSE(getByPath(e, "nothing"));
  EXPECT_FALSE(setByPath(e, "list.0.value", "1"));

  const auto all = paths(e);
  const auto value = std::find_if(all.begin(), all.end(),
                                  [](const PathInfo& p) { return p.path == "inner.value"; });
  ASSERT_NE(value, all.end());
  EXPECT_EQ(value->info.unit, "mm");
  EXPECT_EQ(value->info.doc, "a length");
  EXPECT_EQ(value->info.range.high, 100);
  EXPECT_EQ(all[0].path, "flag");
}

}  // namespace
}  // namespace gt
