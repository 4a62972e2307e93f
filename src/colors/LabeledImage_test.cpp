#include "colors/LabeledImage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gt {
namespace {

using testing::HasSubstr;

TEST(ImageRegions, AreReadFromATable) {
  const std::string heading = "picture,class,left,top,right,bottom\n";
  const auto regions = parseRegions(heading + "12,orange,3,4,5,6\r\n\na.jpg,white,0,0,0,0", "t");
  ASSERT_TRUE(regions) << regions.error().text();
  ASSERT_EQ(regions->size(), 2u);
  EXPECT_EQ((*regions)[0].picture, "12");
  EXPECT_EQ((*regions)[0].region.bottom, 6);
  EXPECT_EQ((*regions)[1].colorClass, ColorClass::white);
  EXPECT_EQ(parseRegions("\xEF\xBB\xBF" + heading + "12,orange,3,4,5,6", "t")->size(), 1u);
  const auto errorOf = [&](const std::string& row) {
    const auto read = parseRegions(heading + row, "t.csv");
    EXPECT_FALSE(read) << row;
    return read ? std::string{} : read.error().text();
  };
  EXPECT_THAT(errorOf("1,orange,3,4,5"), HasSubstr("t.csv:2: expected picture,class"));
  EXPECT_THAT(errorOf("1,purple,3,4,5,6"), HasSubstr("t.csv:2: class"));
  EXPECT_THAT(errorOf("1,pink,3,4,2,6"), HasSubstr("t.csv:2: right"));
  EXPECT_THAT(errorOf("1,pink,3,-4,5,6"), HasSubstr("t.csv:2: top"));
  EXPECT_THAT(errorOf("1,pink,3,4,5,99999999999"), HasSubstr("t.csv:2: bottom"));
  EXPECT_THAT(errorOf(",pink,3,4,5,6"), HasSubstr("t.csv:2: picture"));
  EXPECT_THAT(errorOf(""), HasSubstr("t.csv:1: expected a table"));
}

}  // namespace
}  // namespace gt
