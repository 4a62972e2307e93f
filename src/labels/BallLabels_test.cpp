#include "labels/BallLabels.h"

#include <gmock/gmock.h>

#include <fstream>

namespace gt {
namespace {

const std::string labelFile = "tests/real/nao2009-labels.csv";

TEST(Labels, CoverTheWholeLog) {
  const auto labels = readLabels(labelFile);
  ASSERT_TRUE(labels) << labels.error().text();
  EXPECT_EQ(labels->size(), 96u);
}

TEST(Labels, AreReadFromFilesOfOtherMachines) {
  const auto labels = parseLabels(
      "\xEF\xBB\xBFpicture,time,class,x,y,r\r\n0,1,none,0,0,0\r\n1,2,whole,3,4,5", "l.csv");
  ASSERT_TRUE(labels) << labels.error().text();
  ASSERT_EQ(labels->size(), 2u);
  EXPECT_EQ((*labels)[1].radius, 5);
}

TEST(Labels, NameTheLineThatIsWrong) {
  const std::string file = testing::TempDir() + "labels.csv";
  const auto errorOf = [&](const std::string& row) {
    std::ofstream{file} << "picture,time,class,x,y,r\n0,1,none,0,0,0\n" << row << "\n";
    const auto labels = readLabels(file);
    EXPECT_FALSE(labels);
    return labels ? std::string{} : labels.error().text();
  };
  EXPECT_THAT(errorOf("1,2,hidden,0,0,0"), testing::HasSubstr("labels.csv:3: class"));
  EXPECT_THAT(errorOf("1,two,none,0,0,0"), testing::HasSubstr("labels.csv:3: time"));
  EXPECT_THAT(errorOf("1,2,none"), testing::HasSubstr("labels.csv:3: x"));
  EXPECT_FALSE(readLabels("no/such.csv"));
}

}  // namespace
}  // namespace gt
