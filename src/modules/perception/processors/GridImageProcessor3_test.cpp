#include "modules/perception/processors/GridImageProcessor3.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

class GridImageProcessor3Test : public testing::Test {
 protected:
  /// A ball with a black spot in the middle lies 450 mm ahead.
  void draw(const Vector3d& color) {
    constexpr double radius = 43;
    scene_.draw(
        [&](const Vector3d& ray) {
          const Vector3d to = Vector3d{450, 0, radius} - scene_.matrix.pose.translation;
          const double along = to.dot(ray), off = (to - ray * along).norm();
          if (off > radius) return fieldAt(ray);
          return color == fieldWhite && off < 0.5 * radius ? fieldBlack : color;
        },
        1, 2, random_);
  }
  void look(const ColorTable64& colors) {
    processor_.update(scene_.image, scene_.matrix, colors, field_, found_, random_, found_.debug);
  }

  const FieldDimensions field_{};
  DrawnField scene_;
  DrawnPercepts found_;
  GridImageProcessor3 processor_;
  Random random_{3};
};

TEST_F(GridImageProcessor3Test, FindsABlackAndWhiteBallAndTheLinesThatGT2003Finds) {
  draw(fieldWhite);
  look(blackWhiteTable());
  ASSERT_TRUE(found_.ball.seen);
  EXPECT_NEAR(found_.ball.offset.x(), 450, 60);
  DrawnPercepts all;
  GT2003ImageProcessor gt2003;
  all.lookWith(gt2003, scene_.image, scene_.matrix, blackWhiteTable(), field_);
  EXPECT_FALSE(all.ball.seen);
  for (const EdgeType type : {EdgeType::line, EdgeType::border})
    EXPECT_EQ(found_.lines.points[type], all.lines.points[type]);
}

TEST_F(GridImageProcessor3Test, AnOrangeBallIsNone) {
  const Vector3d orange{129, 59, 214};
  draw(orange);
  ColorTable64 colors = blackWhiteTable();
  for (int y = 2; y < 256; y += 4)
    for (int cb = 2; cb < 100; cb += 4)
      for (int cr = 170; cr < 256; cr += 4)
        colors.classes[ColorTable64::index(static_cast<std::uint8_t>(y),
                                           static_cast<std::uint8_t>(cb),
                                           static_cast<std::uint8_t>(cr))] = ColorClass::orange;
  look(colors);
  EXPECT_FALSE(found_.ball.seen);
  DrawnPercepts all;
  GT2003ImageProcessor gt2003;
  all.lookWith(gt2003, scene_.image, scene_.matrix, colors, field_);
  EXPECT_TRUE(all.ball.seen);
}

}  // namespace
}  // namespace gt
