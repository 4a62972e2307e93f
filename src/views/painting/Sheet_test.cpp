#include "views/painting/Sheet.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <array>

#include "streams/File.h"
#include "streams/TemporaryFolder.h"

namespace gt {
namespace {

using Rgb = std::array<int, 3>;

Rgb at(const RgbPicture& picture, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]};
}

constexpr Rgb white{255, 255, 255};

TEST(Sheet, PaintsInTheOrderOfItsStrokes) {
  Sheet sheet{60, 40};
  sheet.box({10, 10}, {20, 20}, colors::red);
  sheet.box({20, 20}, {20, 10}, colors::black);
  const RgbPicture page = sheet.pixels();
  ASSERT_EQ(page.pixels.size(), 3u * 60 * 40);
  EXPECT_EQ(at(page, 5, 5), white);
  EXPECT_EQ(at(page, 15, 15), (Rgb{colors::red.r, colors::red.g, colors::red.b}));
  EXPECT_EQ(at(page, 25, 25), (Rgb{0, 0, 0}));
  EXPECT_EQ(at(page, 45, 25), white);
  // It can be painted on afterwards.
  sheet.box({0, 0}, {60, 40}, colors::white);
  EXPECT_EQ(at(sheet.pixels(), 25, 25), white);
}

TEST(Sheet, EnlargesPicturesToSquares) {
  Sheet sheet{30, 30};
  sheet.paint(RgbPicture{2, 1, {10, 20, 30, 40, 50, 60}}, {4, 6}, 5);
  sheet.paint(RgbPicture{}, {0, 0});
  const RgbPicture page = sheet.pixels();
  EXPECT_EQ(at(page, 4, 6), (Rgb{10, 20, 30}));
  EXPECT_EQ(at(page, 8, 10), (Rgb{10, 20, 30}));
  EXPECT_EQ(at(page, 9, 6), (Rgb{40, 50, 60}));
  EXPECT_EQ(at(page, 14, 6), white);
  EXPECT_EQ(at(page, 4, 11), white);
}

TEST(Sheet, WritesPngAndSvgAndNothingElse) {
  const TemporaryFolder folder;
  Sheet sheet{50, 20};
  sheet.text({5, 15}, "\xffhello");
  sheet.line({0, 0}, {49, 19}, colors::blue);
  ASSERT_TRUE(sheet.write((folder.path() / "new/page.png").string()));
  EXPECT_EQ(readFile((folder.path() / "new/page.png").string())->substr(1, 3), "PNG");
  ASSERT_TRUE(sheet.write((folder.path() / "page.svg").string()));
  const std::string svg = *readFile((folder.path() / "page.svg").string());
  EXPECT_NE(svg.find("<svg"), svg.npos);
  EXPECT_NE(svg.find("</svg>"), svg.npos);
  const auto other = sheet.write((folder.path() / "page.gif").string());
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().text().find(".png or .svg"), std::string::npos);
}

TEST(Sheet, LeavesNothingBehind) {
  const TemporaryFolder folder;
  const auto writeSome = [&](int count) {
    for (int i = 0; i < count; ++i) {
      Sheet sheet{100, 100};
      for (int k = 0; k < 50; ++k) sheet.text({1, 2.0 * k}, "a line of text");
      ASSERT_TRUE(sheet.write((folder.path() / "page.svg").string()));
    }
  };
  writeSome(20);  // Cairo keeps some fonts
  const std::size_t before = mallinfo2().uordblks;
  writeSome(100);
  EXPECT_LT(mallinfo2().uordblks, before + 1'000'000);
}

}  // namespace
}  // namespace gt
