#include "motionnet/Parser.h"

#include <gtest/gtest.h>

namespace motionnet {
namespace {

const Rules hipAndKnee{{{"hip", -2000, 2000}, {"knee", 0, 1000}}};

struct Parsed {
  Motion motion;
  std::vector<Diagnostic> errors;
};

Parsed parsed(std::string_view text) {
  Parsed result;
  result.motion = parse(text, "a.mof", hipAndKnee, result.errors);
  return result;
}

/// The first error of a description that is correct but for one line, the third.
Diagnostic errorOf(const std::string& line) {
  const auto result = parsed("motion_id = a\nlabel start\n" + line + "\n~ 10 0 1\n");
  return result.errors.empty() ? Diagnostic{} : result.errors.front();
}

TEST(Parser, ReadsAllKindsOfLines) {
  const auto [motion, errors] = parsed(
      "// a comment\n"
      "motion_id = kick\n"
      "group others = a b\n"
      "label start\n"
      "~ 500 1 25 // there\n"
      "-1500 0 0 3\n"
      "pid knee 22 4 8\n"
      "odometry 100 -20 300\n"
      "label end\r\n"
      "transition others extern start\n");
  ASSERT_TRUE(errors.empty()) << errors.front().text();
  EXPECT_EQ(motion.name, "kick");
  ASSERT_EQ(motion.statements.size(), 5u);
  const auto& first = motion.statements[0].node;
  EXPECT_FALSE(first.angles[0]);
  EXPECT_EQ(first.angles[1], 500);
  EXPECT_TRUE(first.interpolate);
  EXPECT_EQ(first.frames, 25);
  EXPECT_EQ(first.line, 5);
  EXPECT_FALSE(motion.statements[1].node.interpolate);
  EXPECT_EQ(motion.statements[2].node.joint, 1);
  EXPECT_EQ(motion.statements[2].node.d, 8);
  EXPECT_EQ(motion.statements[3].node.rotation, 300);
  EXPECT_EQ(motion.statements[4].requested, "others");
  EXPECT_EQ(motion.labels.at("end").statement, 4);
  EXPECT_EQ(motion.groups.at("others").members.size(), 2u);
}

TEST(Parser, ReadsFilesOfOtherMachines) {
  const auto [motion, errors] =
      parsed("\xEF\xBB\xBFmotion_id = kick\r\n\tlabel\tstart\r\n~ 500 1 25");
  EXPECT_TRUE(errors.empty()) << errors.front().text();
  EXPECT_EQ(motion.name, "kick");
  EXPECT_EQ(motion.statements.size(), 1u);
}

TEST(Parser, TellsWhereWhatIsWrong) {
  EXPECT_EQ(
      errorOf("~ 10 0").text(),
      "a.mof:3: data: expected 2 angles, the interpolation and the count; there are 3 values");
  EXPECT_EQ(errorOf("~ 10x 0 1").text(), "a.mof:3: knee: \"10x\" is no whole number");
  EXPECT_EQ(errorOf("~ 1001 0 1").text(), "a.mof:3: knee: 1001 is not within 0 and 1000");
  EXPECT_EQ(errorOf("~ 10 2 1").field, "interpolation");
  EXPECT_EQ(errorOf("~ 10 1 0").field, "count");
  EXPECT_EQ(errorOf("~ 99999999999999999999 1 1").field, "knee");
  EXPECT_EQ(errorOf("jump start").field, "\"jump\"");
  EXPECT_EQ(errorOf("label start").message, "\"start\" is defined twice");
  EXPECT_EQ(errorOf("label 7up").field, "label");
  EXPECT_EQ(errorOf("transition allMotions extern").field, "transition");
  EXPECT_EQ(errorOf("pid elbow 1 2 3").field, "pid");
  EXPECT_EQ(errorOf("pid knee 1 2 300").field, "d");
  EXPECT_EQ(errorOf("odometry 1 2").field, "odometry");
  EXPECT_EQ(errorOf("motion_id = b").message, "given twice");
  EXPECT_EQ(errorOf("group g").field, "group");
}

TEST(Parser, ValuesStandForNumbers) {
  const auto [motion, errors] = parsed(
      "motion_id = a\nvalue bent = 700\nvalue slowly = 60\nlabel start\nbent bent 1 slowly\n"
      "odometry slowly 0 bent\n");
  ASSERT_TRUE(errors.empty()) << errors.front().text();
  EXPECT_EQ(motion.statements[0].node.angles[0], 700);
  EXPECT_EQ(motion.statements[0].node.angles[1], 700);
  EXPECT_EQ(motion.statements[0].node.frames, 60);
  EXPECT_EQ(motion.statements[1].node.x, 60);
  EXPECT_EQ(motion.statements[1].node.rotation, 700);
  EXPECT_EQ(errorOf("value bent 3").message, "expected: value NAME = NUMBER");
  EXPECT_EQ(errorOf("value bent = far").text(), "a.mof:3: value: \"far\" is no whole number");
  EXPECT_EQ(errorOf("value 7up = 7").field, "value");
  EXPECT_EQ(errorOf("~ straight 0 1").text(), "a.mof:3: knee: \"straight\" is no whole number");
  EXPECT_EQ(errorOf("value far = 1001\n~ far 0 1").text(),
            "a.mof:4: knee: 1001 is not within 0 and 1000");
  EXPECT_EQ(errorOf("value far = 1\nvalue far = 2").text(),
            "a.mof:4: value: \"far\" is defined twice");
}

TEST(Parser, WantsANameAndAStart) {
  EXPECT_EQ(parsed("").errors.front().field, "motion_id");
  EXPECT_EQ(parsed("label start\n").errors.front().line, 1);
  EXPECT_EQ(parsed("motion_id = a\n").errors.front().field, "label start");
}

TEST(Parser, TellsOfGarbageBriefly) {
  std::string garbage = "motion_id = a\nlabel start\n";
  for (int i = 0; i < 10000; ++i) garbage += "\x01\xff nonsense\n";
  EXPECT_LT(parsed(garbage).errors.size(), 30u);
}

}  // namespace
}  // namespace motionnet
