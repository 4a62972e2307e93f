#include "modules/perception/processors/GT2003ImageProcessor.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"
#include "modules/perception/testing/DrawnLandmarks.h"

namespace gt {
namespace {

using GT2003ImageProcessorTest = DrawnLandmarks;
using OnTheGround = DrawnBoxes;

TEST_F(OnTheGround, AllPerceptsKnowTheirImagesTime) {
  image_.time = Time{1234};
  look(0, 0);
  for (const Time time :
       {percepts_.ball.time, percepts_.landmarks.time, lines_.time, players_.time, obstacles_.time})
    EXPECT_EQ(time, Time{1234});
}

TEST_F(OnTheGround, OnlyABallHasAPlaceWithoutACameraMatrix) {
  isLine_ = [](double x, double) { return x > 500 && x < 525; };
  look(0, -0.4);
  ASSERT_FALSE(obstacles_.lines.empty());
  ASSERT_FALSE(lines_.points[EdgeType::line].empty());
  image_.time = Time{1234};
  matrix_.valid = false;
  percepts_.lookWith(processor_, image_, matrix_, colors_, field_);
  EXPECT_TRUE(obstacles_.lines.empty());
  EXPECT_TRUE(lines_.points[EdgeType::line].empty());
  EXPECT_EQ(lines_.time, Time{1234});
}

TEST_F(OnTheGround, NoGroundIsFreeWhereNoneIsSeen) {
  look(0, 0.5);
  EXPECT_TRUE(obstacles_.lines.empty());
}

TEST_F(OnTheGround, FreeGroundEndsAtWhatStandsOnItButNotAtLines) {
  isLine_ = [](double x, double) { return x > 500 && x < 525; };
  boxes_ = {{{900, -80, 0}, {1000, 80, 200}, ColorClass::gray}};
  look(0, -0.4);
  ASSERT_GE(obstacles_.lines.size(), 10u);
  int blocked = 0;
  for (const FreeGround& line : obstacles_.lines) {
    const double side = std::abs(line.farPoint.y()) * 900 / line.farPoint.x();
    if (side < 65) {
      EXPECT_NEAR(line.farPoint.x(), 900, 60);
      EXPECT_FALSE(line.farOnBorder);
      ++blocked;
    } else if (side > 100) {
      EXPECT_GT(line.farPoint.x(), 1000);
    }
  }
  EXPECT_GE(blocked, 2);
}

TEST_F(OnTheGround, FreeGroundDoesNotEndAtALineSeenLengthwise) {
  isLine_ = [](double x, double y) { return x > 300 && y > 30 && y < 55; };
  look(0, -0.4);
  ASSERT_GE(obstacles_.lines.size(), 10u);
  for (const FreeGround& line : obstacles_.lines)
    EXPECT_GT(line.farPoint.x(), 1500) << line.nearPoint.y();
}

// At 1.2 m a pixel is 43 mm.
TEST_F(OnTheGround, FreeGroundEndsWithinAThirdOfAPixel) {
  for (const double distance : {600., 900., 1200.}) {
    boxes_ = {{{distance, -2000, 0}, {distance + 100, 2000, 100}, ColorClass::white}};
    look(0, -0.15);
    const double pixel =
        std::pow(distance - 90, 2) / matrix_.pose.translation.z() / matrix_.info.focalX;
    ASSERT_GE(obstacles_.lines.size(), 10u);
    for (const FreeGround& line : obstacles_.lines)
      EXPECT_NEAR(line.farPoint.x(), distance, pixel / 3) << line.farPoint.y();
  }
}

TEST_F(OnTheGround, GroundThatIsNotGreenIsUnknown) {
  boxes_ = {{{150, -500, 0}, {2000, 500, 5}, ColorClass::gray}};
  look(0, -0.4);
  for (const FreeGround& line : obstacles_.lines) EXPECT_EQ(line.nearPoint, line.farPoint);
}

TEST_F(GT2003ImageProcessorTest, SeesNothingWhereNothingIs) {
  random_ = Random{7};
  for (const double tilt : {-0.8, -0.3, 0.0, 0.3}) {
    look(0.2, tilt, 0.1);
    EXPECT_FALSE(percepts_.ball.seen);
    EXPECT_EQ(landmarks_.numberOfFlags, 0);
    EXPECT_EQ(landmarks_.numberOfGoals, 0);
  }
}

// Any image and any rotation of the camera, however absurd, is only looked at.
TEST_F(GT2003ImageProcessorTest, SurvivesNoise) {
  random_ = Random{12};
  for (int i = 0; i < 100; ++i) {
    matrix_.info.width = 1 + static_cast<int>(random_.index(200));
    matrix_.info.height = 1 + static_cast<int>(random_.index(150));
    image_.info = matrix_.info;
    image_.allocate();
    const bool coarse = random_.chance(0.5);
    Pixel pixel;
    for (Pixel& p : image_.pixels) {
      if (!coarse || random_.chance(0.05))
        pixel =
            random_.chance(0.5)
                ? palette().colors[random_.index(palette().colors.size())].second
                : Pixel{static_cast<std::uint8_t>(random_()), static_cast<std::uint8_t>(random_()),
                        static_cast<std::uint8_t>(random_()), 0};
      p = pixel;
    }
    matrix_.pose.rotation = rotationZ(random_.uniform(-pi, pi)) *
                            rotationY(random_.uniform(-pi, pi)) *
                            rotationX(random_.uniform(-pi, pi));
    matrix_.pose.translation.z() = random_.uniform(-50, 300);
    matrix_.valid = random_.chance(0.8);
    percepts_.lookWith(processor_, image_, matrix_, colors_, field_);
    EXPECT_LE(landmarks_.numberOfFlags, 6);
    EXPECT_TRUE(percepts_.ball.offset.allFinite());
  }
}

// What is drawn over an image lies where the thing is seen.
TEST_F(GT2003ImageProcessorTest, DrawsPerceptsWhereTheyAre) {
  ball_ = Vector3d{700, -80, field_.ballRadius};
  flag_ = Vector2d{1500, 250};
  goal_ = 2500;
  percepts_.debug.keys().set(*DebugKey::find("ImageProcessor/percepts"), {DebugKeyMode::always});
  look(0, -0.05, 0);
  Drawing drawing;
  percepts_.debug.out().handleAllMessages(
      [&](const Message& message) { EXPECT_TRUE(message.read(drawing)); });
  ASSERT_EQ(drawing.elements.size(), 3u);
  const auto seen = [&](const Vector3d& place) { return pointIn(matrix_, place - camera()); };
  EXPECT_EQ(drawing.elements[0].type, ElementType::circle);
  EXPECT_NEAR((drawing.elements[0].points[0] - seen(*ball_)).norm(), 0, 1);
  EXPECT_NEAR(drawing.elements[0].size, 160 * 43 / (*ball_ - camera()).norm(), 1);
  const auto& flag = drawing.elements[1].points;
  ASSERT_EQ(flag.size(), 4u);
  EXPECT_NEAR((flag[0] - seen({1500, 300, 410})).norm(), 0, 2) << "left and top first";
  EXPECT_NEAR((flag[2] - seen({1500, 200, 210})).norm(), 0, 2);
  EXPECT_NEAR((drawing.elements[2].points[2] - seen({2500, -300, 0})).norm(), 0, 2);
}

}  // namespace
}  // namespace gt
