#include "colors/ColorConfusion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gt {
namespace {

using testing::HasSubstr;

TEST(ColorConfusion, TellsPrecisionAndRecall) {
  ColorConfusion confusion;
  confusion.add(ColorClass::orange, ColorClass::orange, 6);
  confusion.add(ColorClass::orange, ColorClass::yellow, 2);
  confusion.add(ColorClass::yellow, ColorClass::orange, 4);
  confusion.add(ColorClass::noColor, ColorClass::noColor, 8);
  EXPECT_DOUBLE_EQ(confusion.precision(ColorClass::orange), 0.6);
  EXPECT_DOUBLE_EQ(confusion.recall(ColorClass::orange), 0.75);
  EXPECT_DOUBLE_EQ(confusion.recall(ColorClass::yellow), 0);
  EXPECT_DOUBLE_EQ(confusion.accuracy(), 0.7);
  EXPECT_THAT(confusion.text("truth", "table"), HasSubstr("60.0%     75.0%"));
  EXPECT_THAT(confusion.text("truth", "table"), testing::Not(HasSubstr("pink")));
  ColorTable64 table;
  table.classes[ColorTable64::index(4, 8, 12)] = ColorClass::pink;
  const ColorConfusion tables = compareTables(table, ColorTable64{});
  EXPECT_EQ(tables.count(ColorClass::pink, ColorClass::noColor), 1u);
  EXPECT_EQ(tables.total(), 64u * 64u * 64u);
}

}  // namespace
}  // namespace gt
