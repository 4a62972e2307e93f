#include "colors/ColorOrder.h"

#include <gtest/gtest.h>

#include "colors/ColorTableFile.h"

namespace gt {
namespace {

/// The bytes of a file with one color of each of some class numbers.
std::string fileWith(const std::string& numbers) {
  std::string bytes;
  for (const char number : numbers) bytes += std::string{"\1\0\0\0", 4} + number;
  const auto left = static_cast<unsigned>(64 * 64 * 64 - numbers.size());
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(left >> shift & 255);
  return bytes + std::string(5, '\0');
}

TEST(ColorOrder, IsDoubtedIfTheFieldHasNoColor) {
  // Orange, yellow, skyblue, white, green and black, as a real robot's table of 2009 numbers them.
  const std::string nao = fileWith("\1\2\3\4\5\6");
  EXPECT_EQ(
      doubtOfOrder(*parseColorTable(nao, "nao.c64"), "nao.c64", false, "--other"),
      "nao.c64: has no green, white and gray, so its classes are probably those of a robot of "
      "2009: --other");
  const auto doubt = [](const Result<ColorTable64>& table) {
    return doubtOfOrder(*table, "file", true, "--other");
  };
  EXPECT_EQ(doubt(parseColorTable(nao, "nao.c64", nao2009ColorOrder)), "");
  EXPECT_EQ(doubt(parseColorTable(nao, "nao.c64")),
            "file: has no green, white and gray, so its classes are probably those of the report: "
            "--other");
  // Orange and the flags' colors alone, and a table of nothing.
  EXPECT_EQ(doubt(parseColorTable(fileWith("\1\2\3\4\7"), "own.c64")), "");
  EXPECT_EQ(doubt(ColorTable64{}), "");
  EXPECT_EQ(doubt(readColorTable("config/coltable.c64")), "");
}

}  // namespace
}  // namespace gt
