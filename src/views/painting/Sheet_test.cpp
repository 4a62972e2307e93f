#include "views/painting/Sheet.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <array>

#include "base/File.h"
#include "base/TemporaryFolder.h"

namespace gt {
namespace {

using Rgb = std::array<int, 3>;

Rgb pixelAt(const RgbImage& picture, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]};
}

constexpr Rgb paper{255, 255, 255};

TEST(Sheet, PaintsInTheOrderOfItsStrokes) {
  Sheet sheet{60, 40};
  sheet.box({10, 10}, {20, 20}, colors::red);
  sheet.box({20, 20}, {20, 10}, colors::black);
  const RgbImage page = sheet.pixels();
  ASSERT_EQ(page.pixels.size(), 3u * 60 * 40);
  EXPECT_EQ(pixelAt(page, 5, 5), paper);
  EXPECT_EQ(pixelAt(page, 15, 15), (Rgb{colors::red.r, colors::red.g, colors::red.b}));
  EXPECT_EQ(pixelAt(page, 25, 25), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixelAt(page, 45, 25), paper);
  // It can be painted on afterwards.
  sheet.box({0, 0}, {60, 40}, colors::white);
  EXPECT_EQ(pixelAt(sheet.pixels(), 25, 25), paper);
}

TEST(Sheet, EnlargesImagesToSquares) {
  Sheet sheet{30, 30};
  sheet.paint(RgbImage{2, 1, {10, 20, 30, 40, 50, 60}}, {4, 6}, 5);
  sheet.paint(RgbImage{}, {0, 0});
  const RgbImage page = sheet.pixels();
  EXPECT_EQ(pixelAt(page, 4, 6), (Rgb{10, 20, 30}));
  EXPECT_EQ(pixelAt(page, 8, 10), (Rgb{10, 20, 30}));
  EXPECT_EQ(pixelAt(page, 9, 6), (Rgb{40, 50, 60}));
  EXPECT_EQ(pixelAt(page, 14, 6), paper);
  EXPECT_EQ(pixelAt(page, 4, 11), paper);
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
  EXPECT_TRUE(svg.starts_with("<svg")) << svg;
  EXPECT_TRUE(svg.ends_with("</svg>\n")) << svg;
  const auto other = sheet.write((folder.path() / "page.gif").string());
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().text().find(".png or .svg"), std::string::npos);
}

TEST(Sheet, TextStaysTextInSvg) {
  Sheet sheet{200, 60};
  sheet.text({5, 15},
             "Gr\xc3\xbc\xc3\x9f"
             "e: 30\xc2\xb0 < 40 & \xff\n",
             colors::red, 11);
  sheet.paint(
      {"", DrawingSpace::image, {{ElementType::text, {{5, 40}}, 12, colors::black, 1, "X"}}});
  const std::string svg = sheet.svg();
  EXPECT_NE(svg.find("<text x=\"5\" y=\"15\" font-size=\"11\" fill=\"#dc1e1e\">"
                     "Gr\xc3\xbc\xc3\x9f"
                     "e: 30\xc2\xb0 &lt; 40 &amp; ?"
                     "?</text>"),
            svg.npos)
      << svg;
  EXPECT_NE(svg.find(">X</text>"), svg.npos) << svg;
  EXPECT_LT(svg.size(), 1000u);
}

TEST(Sheet, SvgHasEveryElementAndPictures) {
  Sheet sheet{100, 100};
  Drawing drawing;
  for (std::size_t i = 0; i < enumCount<ElementType>; ++i)
    drawing.elements.push_back({static_cast<ElementType>(i),
                                {{20, 20}, {40, 20}, {20, 40}},
                                5,
                                {1, 2, 3, 51},
                                2,
                                "t",
                                PenStyle::dash});
  sheet.paint(drawing);
  sheet.paint(RgbImage{1, 1, {1, 2, 3}}, {3, 4}, 5);
  const std::string svg = sheet.svg();
  const auto count = [&](const std::string& tag) {
    int found = 0;
    for (std::size_t at = svg.find(tag); at != svg.npos; at = svg.find(tag, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<circle"), 3);    // point, disk and circle
  EXPECT_EQ(count("<polyline"), 4);  // line, path, arrow and its head
  EXPECT_EQ(count("<polygon"), 4);   // the page, ellipse, polygon, area
  EXPECT_EQ(count("<path"), 1);      // sector
  EXPECT_EQ(count("-opacity=\"0.2\""), 12);
  EXPECT_EQ(count("stroke-dasharray=\"8 6\""), 6);
  EXPECT_EQ(count("<image x=\"3\" y=\"4\" width=\"5\" height=\"5\""), 1);
  EXPECT_EQ(count("data:image/png;base64,iVBORw0KGgo"), 1);
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
