#include "colors/ColorTableFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/Random.h"

namespace gt {
namespace {

using testing::HasSubstr;

ColorTable64 someTable(std::uint64_t seed) {
  Random random{seed};
  ColorTable64 table;
  for (std::size_t i = 0; i < table.classes.size();) {
    const auto c = static_cast<ColorClass>(random.index(enumCount<ColorClass>));
    for (std::size_t n = 1 + random.index(5000); n > 0 && i < table.classes.size(); --n)
      table.classes[i++] = c;
  }
  return table;
}

std::string run(std::uint32_t length, char c) {
  std::string s;
  for (int shift = 0; shift < 32; shift += 8)
    s.push_back(static_cast<char>(length >> shift & 0xff));
  s.push_back(c);
  return s;
}

TEST(ColorTableFile, KeepsATable) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ColorTable64 table = someTable(seed);
    const auto read = parseColorTable(colorTableBytes(table), "t");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->classes, table.classes);
  }
}

TEST(ColorTableFile, TranslatesClasses) {
  const std::string bytes = run(64 * 64 * 64, 4) + std::string(4, '\0');
  EXPECT_EQ(parseColorTable(bytes, "t")->classes[77], ColorClass::pink);
  EXPECT_EQ(parseColorTable(bytes, "t", nao2009ColorOrder)->classes[77], ColorClass::white);
}

TEST(ColorTableFile, NamesTheByteThatIsWrong) {
  const auto errorOf = [](const std::string& bytes) {
    const auto read = parseColorTable(bytes, "t.c64");
    EXPECT_FALSE(read);
    return read ? std::string{} : read.error().text();
  };
  const std::string end(4, '\0');
  EXPECT_THAT(errorOf(""), HasSubstr("t.c64: byte 0: the file ends"));
  EXPECT_THAT(errorOf(run(100, 1)), HasSubstr("byte 5: the file ends"));
  EXPECT_THAT(errorOf(run(100, 1) + end), HasSubstr("byte 5: the table ends after 100"));
  EXPECT_THAT(errorOf(run(100, 1) + run(262144, 1) + end), HasSubstr("byte 5: a run of 262144"));
  EXPECT_THAT(errorOf(run(0xffffffff, 1) + end), HasSubstr("byte 0: a run of -1"));
  EXPECT_THAT(errorOf(run(262144, 11) + end), HasSubstr("byte 0: unknown color class 11"));
  EXPECT_THAT(errorOf(run(262144, 1) + end + "x"), HasSubstr("byte 9: something follows"));
  EXPECT_THAT(readColorTable("no/such.c64").error().text(), HasSubstr("no/such.c64"));
}

TEST(ColorTableFile, SurvivesBrokenFiles) {
  const std::string good = colorTableBytes(someTable(3));
  Random random{7};
  for (int i = 0; i < 500; ++i) {
    std::string bad = good.substr(0, random.chance(0.3) ? random.index(good.size()) : good.size());
    for (int k = 0; k < 3 && !bad.empty(); ++k)
      bad[random.index(bad.size())] = static_cast<char>(random.index(256));
    const auto read = parseColorTable(bad, "bad");
    if (!read) {
      EXPECT_FALSE(read.error().field.empty());
    }
  }
}

TEST(ColorTableFile, ReadsTheSimulatorsTable) {
  const auto table = readColorTable("config/coltable.c64");
  ASSERT_TRUE(table) << table.error().text();
  for (const ColorClass c :
       {ColorClass::orange, ColorClass::yellow, ColorClass::skyblue, ColorClass::pink,
        ColorClass::red, ColorClass::blue, ColorClass::green, ColorClass::white})
    EXPECT_GT(std::count(table->classes.begin(), table->classes.end(), c), 500) << enumName(c);
}

TEST(ColorTableFile, ReadsTheRealRobotsTables) {
  const char* real = std::getenv("GT_REAL");
  const std::string folder = real ? real : "../shared/real";
  if (!std::filesystem::exists(folder + "/coltable-field.c64"))
    GTEST_SKIP() << "no real robot's color table in " << folder;
  for (const char* name : {"/coltable-field.c64", "/coltable-simulator.c64"}) {
    const auto table = readColorTable(folder + name, nao2009ColorOrder);
    ASSERT_TRUE(table) << table.error().text();
    // The carpet and the orange of the ball as they are in those images.
    if (std::string{name} == "/coltable-field.c64") {
      EXPECT_EQ(table->classes[ColorTable64::index(105, 112, 118)], ColorClass::green);
      EXPECT_EQ(table->classes[ColorTable64::index(126, 87, 176)], ColorClass::orange);
    }
  }
}

}  // namespace
}  // namespace gt
