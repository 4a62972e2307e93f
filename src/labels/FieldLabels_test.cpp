#include "labels/FieldLabels.h"

#include <gmock/gmock.h>

#include <fstream>

#include "labels/BallLabels.h"

namespace gt {
namespace {

TEST(FieldLabels, CoverMostImages) {
  const auto labels = readFieldLabels("tests/real/nao2009-field.csv");
  ASSERT_TRUE(labels) << labels.error().text();
  EXPECT_GE(labels->size(), 60u);
  const auto balls = readLabels("tests/real/nao2009-labels.csv");
  for (const auto& [picture, label] : *labels)
    EXPECT_EQ(label.time, (*balls)[static_cast<std::size_t>(picture)].time) << picture;
}

TEST(FieldLabels, NameTheLineThatIsWrong) {
  const std::string file = testing::TempDir() + "field.csv";
  const auto errorOf = [&](const std::string& row) {
    std::ofstream{file} << "picture,time,what,x,y\n0,1,none,0,0\n" << row << "\n";
    const auto labels = readFieldLabels(file);
    EXPECT_FALSE(labels) << row;
    return labels ? std::string{} : labels.error().text();
  };
  EXPECT_THAT(errorOf("1,2,wall,0,0"), testing::HasSubstr("field.csv:3: what"));
  EXPECT_THAT(errorOf("1,two,none,0,0"), testing::HasSubstr("field.csv:3: time"));
  EXPECT_THAT(errorOf("1,2,line1,0,nan"), testing::HasSubstr("field.csv:3: x"));
  EXPECT_THAT(errorOf("1,2,line1"), testing::HasSubstr("field.csv:3: x"));
  EXPECT_THAT(errorOf("0,2,line1,1,1"), testing::HasSubstr("field.csv:3: time"));
  EXPECT_THAT(errorOf("1,2,flag.redAbovePink,1,1"), testing::HasSubstr("field.csv:3: what"));
  EXPECT_THAT(errorOf("1,2,player.red,1,1"), testing::HasSubstr("field.csv:3: what"));
  EXPECT_THAT(errorOf("1,2,goal.yellow,1,1"), testing::HasSubstr("goal.yellow: has one corner"));
  EXPECT_THAT(errorOf("1,2,goal.yellow,1,1\n1,2,goal.yellow,1,2\n1,2,goal.yellow,1,3"),
              testing::HasSubstr("field.csv:5: what"));
}

}  // namespace
}  // namespace gt
