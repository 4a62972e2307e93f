#include "views/painting/PicturePainter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

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

Rgb at(const PicturePainter& painter, int x, int y) {
  const auto rgb = painter.rgb();
  const auto i = static_cast<std::size_t>(3 * (y * painter.width() + x));
  return {rgb[i], rgb[i + 1], rgb[i + 2]};
}

/// A black picture of 40 x 30, doubled, with one element painted on it.
PicturePainter painted(DrawingElement element) {
  PicturePainter painter{imageOf({0, 128, 128})};
  painter.paint({"", DrawingSpace::image, {std::move(element)}});
  return painter;
}

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

TEST(PicturePainter, ConvertsFullRangeYCbCr) {
  // JFIF's pure colours, rounded to bytes, and back: at most one step off.
  const std::array<std::pair<Pixel, Rgb>, 6> colors{{{{0, 128, 128}, {0, 0, 0}},
                                                     {{255, 128, 128}, {255, 255, 255}},
                                                     {{76, 85, 255}, {254, 0, 0}},
                                                     {{150, 44, 21}, {0, 255, 1}},
                                                     {{29, 255, 107}, {0, 0, 254}},
                                                     {{128, 128, 128}, {128, 128, 128}}}};
  for (const auto& [pixel, rgb] : colors) EXPECT_EQ(at(PicturePainter{imageOf(pixel)}, 7, 5), rgb);
}

TEST(PicturePainter, EnlargesPixelsToSquares) {
  Image image = imageOf({0, 128, 128}, 3, 2);
  image.at(1, 1).y = 255;
  const PicturePainter painter{image, 3};
  EXPECT_EQ(painter.width(), 9);
  EXPECT_EQ(painter.height(), 6);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 9; ++x)
      EXPECT_EQ(at(painter, x, y), x / 3 == 1 && y / 3 == 1 ? white : black) << x << ", " << y;
}

TEST(PicturePainter, PaintsPointsAndDisksWhereTheyAre) {
  for (const ElementType type : {ElementType::point, ElementType::disk}) {
    const auto painter = painted({type, {{10, 20}}, 3, colors::white, 1, ""});
    EXPECT_EQ(at(painter, 20, 40), white);
    EXPECT_EQ(at(painter, 24, 40), white);
    EXPECT_EQ(at(painter, 27, 40), black);
    EXPECT_EQ(at(painter, 20, 33), black);
  }
}

TEST(PicturePainter, PaintsCirclesAsRings) {
  const auto painter = painted({ElementType::circle, {{20, 15}}, 10, colors::white, 2, ""});
  EXPECT_EQ(at(painter, 40, 30), black);
  for (int i = 0; i < 12; ++i) {
    const Vector2d onRing = Vector2d{40, 30} + direction(i * pi / 6) * 20;
    const Rgb rgb =
        at(painter, static_cast<int>(onRing.x() - 0.01), static_cast<int>(onRing.y() - 0.01));
    EXPECT_GT(rgb[0], 120) << i;
  }
}

TEST(PicturePainter, PaintsDashedAndDottedLines) {
  const auto covered = [](PenStyle style) {
    const auto painter =
        painted({ElementType::line, {{2, 15}, {37, 15}}, 0, colors::white, 2, "", style});
    int bright = 0, gaps = 0;
    for (int x = 5; x < 74; ++x) {
      const bool on = at(painter, x, 30)[0] > 127;
      bright += on;
      gaps += !on && at(painter, x - 1, 30)[0] > 127;
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

TEST(PicturePainter, PaintsLinesArrowsAndPolygons) {
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

TEST(PicturePainter, PaintsTextAboveAndRightOfItsPlace) {
  const auto painter = painted({ElementType::text, {{5, 20}}, 10, colors::white, 1, "H"});
  const auto rgb = painter.rgb();
  int inside = 0, outside = 0;
  for (int i = 0; i < painter.width() * painter.height(); ++i) {
    const int x = i % painter.width(), y = i / painter.width();
    if (rgb[static_cast<std::size_t>(3 * i)] > 128)
      ++(x >= 9 && x < 30 && y >= 20 && y <= 41 ? inside : outside);
  }
  EXPECT_GT(inside, 30);
  EXPECT_EQ(outside, 0);
}

TEST(PicturePainter, MixesWhatIsTransparent) {
  const auto painter = painted({ElementType::disk, {{20, 15}}, 9, {255, 255, 255, 128}, 1, ""});
  EXPECT_NEAR(at(painter, 40, 30)[1], 128, 2);
}

TEST(PicturePainter, LeavesOutWhatMakesNoSense) {
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
  PicturePainter painter{imageOf({0, 128, 128})};
  painter.paint(drawing);
  EXPECT_EQ(painter.rgb(), PicturePainter{imageOf({0, 128, 128})}.rgb());

  // Text that is no UTF-8 keeps nothing else from being painted.
  painter.paint({"",
                 DrawingSpace::image,
                 {{ElementType::text, {{5, 20}}, 8, colors::white, 1, "\xFF\xFE"},
                  {ElementType::disk, {{35, 25}}, 3, colors::white, 1, ""}}});
  EXPECT_EQ(at(painter, 70, 50), white);
}

TEST(PicturePainter, TakesPicturesWithTooFewPixels) {
  Image image = imageOf({255, 128, 128}, 4, 4);
  image.pixels.resize(8);
  const PicturePainter painter{image, 1};
  EXPECT_EQ(at(painter, 3, 1), white);
  EXPECT_EQ(at(painter, 0, 2), black);
  EXPECT_TRUE(PicturePainter(Image{}, 2).rgb().size() == 352u * 288u * 3u);
}

}  // namespace
}  // namespace gt
