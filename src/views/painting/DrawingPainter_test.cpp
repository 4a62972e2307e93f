#include "views/painting/DrawingPainter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "views/painting/Sheet.h"

namespace gt {
namespace {

using Rgb = std::array<int, 3>;

Image imageOf(Pixel pixel, int width = 40, int height = 30) {
  Image image;
  image.info.width = width;
  image.info.height = height;
  image.pixels.assign(static_cast<std::size_t>(width * height), pixel);
  return image;
}

/// An image as a page of squares, on which drawings are painted in the image's coordinates.
class Page {
 public:
  explicit Page(const Image& image, int scale = 2)
      : sheet_{imageSheet(image, scale)}, scale_{static_cast<double>(scale)} {}
  void paint(const Drawing& drawing) { sheet_.paint(drawing, {Vector2d::Zero(), scale_, false}); }
  int width() const { return sheet_.width(); }
  int height() const { return sheet_.height(); }
  std::vector<std::uint8_t> rgb() const { return sheet_.pixels().pixels; }

 private:
  Sheet sheet_;
  double scale_;
};

Rgb at(const Page& page, int x, int y) {
  const auto rgb = page.rgb();
  const auto i = static_cast<std::size_t>(3 * (y * page.width() + x));
  return {rgb[i], rgb[i + 1], rgb[i + 2]};
}

/// A black image of 40 x 30, doubled, with one element painted on it.
Page painted(DrawingElement element) {
  Page page{imageOf({0, 128, 128})};
  page.paint({"", DrawingSpace::image, {std::move(element)}});
  return page;
}

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

TEST(DrawingPainter, ConvertsFullRangeYCbCr) {
  // JFIF's pure colors, rounded to bytes, and back: at most one step off.
  const std::array<std::pair<Pixel, Rgb>, 6> colors{{{{0, 128, 128}, {0, 0, 0}},
                                                     {{255, 128, 128}, {255, 255, 255}},
                                                     {{76, 85, 255}, {254, 0, 0}},
                                                     {{150, 44, 21}, {0, 255, 1}},
                                                     {{29, 255, 107}, {0, 0, 254}},
                                                     {{128, 128, 128}, {128, 128, 128}}}};
  for (const auto& [pixel, rgb] : colors) EXPECT_EQ(at(Page{imageOf(pixel)}, 7, 5), rgb);
}

TEST(DrawingPainter, EnlargesPixelsToSquares) {
  Image image = imageOf({0, 128, 128}, 3, 2);
  image.at(1, 1).y = 255;
  const Page page{image, 3};
  EXPECT_EQ(page.width(), 9);
  EXPECT_EQ(page.height(), 6);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 9; ++x)
      EXPECT_EQ(at(page, x, y), x / 3 == 1 && y / 3 == 1 ? white : black) << x << ", " << y;
}

TEST(DrawingPainter, PaintsPointsAndDisksWhereTheyAre) {
  for (const ElementType type : {ElementType::point, ElementType::disk}) {
    const auto page = painted({type, {{10, 20}}, 3, colors::white, 1, ""});
    EXPECT_EQ(at(page, 20, 40), white);
    EXPECT_EQ(at(page, 24, 40), white);
    EXPECT_EQ(at(page, 27, 40), black);
    EXPECT_EQ(at(page, 20, 33), black);
  }
}

TEST(DrawingPainter, PaintsCirclesAsRings) {
  const auto page = painted({ElementType::circle, {{20, 15}}, 10, colors::white, 2, ""});
  EXPECT_EQ(at(page, 40, 30), black);
  for (int i = 0; i < 12; ++i) {
    const Vector2d onRing = Vector2d{40, 30} + direction(i * pi / 6) * 20;
    const Rgb rgb =
        at(page, static_cast<int>(onRing.x() - 0.01), static_cast<int>(onRing.y() - 0.01));
    EXPECT_GT(rgb[0], 120) << i;
  }
}

TEST(DrawingPainter, PaintsDashedAndDottedLines) {
  const auto covered = [](PenStyle style) {
    const auto page =
        painted({ElementType::line, {{2, 15}, {37, 15}}, 0, colors::white, 2, "", style});
    int bright = 0, gaps = 0;
    for (int x = 5; x < 74; ++x) {
      const bool on = at(page, x, 30)[0] > 127;
      bright += on;
      gaps += !on && at(page, x - 1, 30)[0] > 127;
    }
    EXPECT_EQ(gaps > 2, style != PenStyle::solid);
    return bright;
  };
  const int solid = covered(PenStyle::solid), dash = covered(PenStyle::dash),
            dot = covered(PenStyle::dot);
  EXPECT_EQ(solid, 69);
  EXPECT_LT(dash, 60);
  EXPECT_LT(dot, dash);
  EXPECT_GT(dot, 0);
}

TEST(DrawingPainter, PaintsLinesArrowsAndPolygons) {
  const auto line = painted({ElementType::line, {{5, 10}, {35, 10}}, 0, colors::white, 2, ""});
  EXPECT_EQ(at(line, 11, 20), white);
  EXPECT_EQ(at(line, 68, 19), white);
  EXPECT_EQ(at(line, 40, 23), black);
  EXPECT_EQ(at(line, 66, 17), black);
  EXPECT_EQ(at(line, 75, 20), black);

  const auto arrow = painted({ElementType::arrow, {{5, 10}, {35, 10}}, 0, colors::white, 2, ""});
  EXPECT_EQ(at(arrow, 40, 20), white);
  EXPECT_GT(at(arrow, 66, 17)[0], 100);
  EXPECT_GT(at(arrow, 66, 22)[0], 100);
  EXPECT_EQ(at(arrow, 12, 17), black);

  const auto polygon = painted(
      {ElementType::polygon, {{5, 5}, {35, 5}, {35, 25}, {5, 25}}, 0, colors::white, 2, ""});
  EXPECT_EQ(at(polygon, 10, 30), white);  // the side that closes it
  EXPECT_EQ(at(polygon, 40, 30), black);
}

TEST(DrawingPainter, PaintsTextAboveAndRightOfItsPlace) {
  const auto page = painted({ElementType::text, {{5, 20}}, 10, colors::white, 1, "H"});
  const auto rgb = page.rgb();
  int inside = 0, outside = 0;
  for (int i = 0; i < page.width() * page.height(); ++i) {
    const int x = i % page.width(), y = i / page.width();
    if (rgb[static_cast<std::size_t>(3 * i)] > 128)
      ++(x >= 9 && x < 30 && y >= 20 && y <= 41 ? inside : outside);
  }
  EXPECT_GT(inside, 30);
  EXPECT_EQ(outside, 0);
}

TEST(DrawingPainter, MixesWhatIsTransparent) {
  const auto page = painted({ElementType::disk, {{20, 15}}, 9, {255, 255, 255, 128}, 1, ""});
  EXPECT_NEAR(at(page, 40, 30)[1], 128, 2);
}

TEST(DrawingPainter, LeavesOutWhatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
  Drawing drawing{"", DrawingSpace::image, {}};
  for (std::size_t i = 0; i < enumCount<ElementType>; ++i) {
    const auto type = static_cast<ElementType>(i);
    drawing.elements.push_back({type, {}, 5, colors::white, 1, "x"});
    drawing.elements.push_back({type, {{nan, 3}, {4, 5}}, 5, colors::white, 1, "x"});
    drawing.elements.push_back({type, {{3, 3}, {4, 5}}, nan, colors::white, 1, "x"});
    drawing.elements.push_back({type, {{huge, huge}, {huge, -5}}, 5, colors::white, 1, "x"});
  }
  drawing.elements.push_back({ElementType::line, {{5, 5}}, 0, colors::white, 1, ""});
  drawing.elements.push_back({ElementType::circle, {{20, 15}}, -3, colors::black, 1, ""});
  Page page{imageOf({0, 128, 128})};
  page.paint(drawing);
  EXPECT_EQ(page.rgb(), Page{imageOf({0, 128, 128})}.rgb());

  // Text that is no UTF-8 keeps nothing else from being painted.
  page.paint({"",
              DrawingSpace::image,
              {{ElementType::text, {{5, 20}}, 8, colors::white, 1, "\xFF\xFE"},
               {ElementType::disk, {{35, 25}}, 3, colors::white, 1, ""}}});
  EXPECT_EQ(at(page, 70, 50), white);
}

TEST(DrawingPainter, TakesImagesWithTooFewPixels) {
  Image image = imageOf({255, 128, 128}, 4, 4);
  image.pixels.resize(8);
  const Page page{image, 1};
  EXPECT_EQ(at(page, 3, 1), white);
  EXPECT_EQ(at(page, 0, 2), black);
  EXPECT_TRUE(Page(Image{}, 2).rgb().size() == 352u * 288u * 3u);
}

}  // namespace
}  // namespace gt
