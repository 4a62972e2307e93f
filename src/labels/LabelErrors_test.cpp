#include "labels/LabelErrors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gt {
namespace {

/// An image of a camera 200 mm above the ground that looks 20 degrees down.
class LabelErrorsTest : public ::testing::Test {
 protected:
  LabelErrorsTest() {
    seen.time = seen.matrix.time = Time{500};
    seen.matrix.pose.translation = {0, 0, 200};
    seen.matrix.pose.rotation = rotationY(fromDegrees(20));
    seen.matrix.info.rowTime = 0;
  }
  Vector2d inImage(const Vector3d& place) const {
    return seen.matrix.info.project(seen.matrix.pose.rotation.transpose() *
                                    (place - seen.matrix.pose.translation));
  }
  /// A rectangle around something that stands on the ground.
  BoxLabel boxAround(const Vector2d& place, double width, double height) const {
    const Vector2d across = width / 2 * Vector2d{-place.y(), place.x()}.normalized();
    const Vector2d left = inImage({place.x() + across.x(), place.y() + across.y(), height});
    const Vector2d right = inImage({place.x() - across.x(), place.y() - across.y(), 0});
    return {left, right};
  }
  std::vector<LabelError> errors() const { return errorsIn(labels, 2, seen, 43); }

  SeenInImage seen;
  ImageLabels labels;
};

TEST_F(LabelErrorsTest, OfTheBallAreAnglesAndItsDistanceFollowsFromItsSize) {
  const CameraInfo& info = seen.matrix.info;
  const double radius = info.focalX * std::tan(std::asin(43.0 / 800));
  labels.balls[2] = {2, 500, BallView::whole, {info.centerX, info.centerY}, radius};
  seen.ball.seen = true;
  seen.ball.centerInImage = {info.centerX + info.focalX * std::tan(fromDegrees(3)), info.centerY};
  ASSERT_EQ(errors().size(), 1u);
  EXPECT_EQ(errors()[0].what, "ball");
  EXPECT_TRUE(errors()[0].labeled && errors()[0].found);
  EXPECT_NEAR(errors()[0].degrees, 3, 1e-9);
  EXPECT_NEAR(errors()[0].distance, 800, 1e-6);
  // Where nobody saw one, it is false; where nobody looked, it is nothing.
  labels.balls[2].view = BallView::none;
  ASSERT_EQ(errors().size(), 1u);
  EXPECT_FALSE(errors()[0].labeled);
  labels.balls[2].time = 501;
  EXPECT_TRUE(errors().empty());
}

TEST_F(LabelErrorsTest, OfFlagsAreThoseOfTheirSides) {
  const Vector2d place{1500, 300};
  const BoxName flag{BoxName::Kind::flag, static_cast<int>(FlagType::greenAbovePink)};
  labels.fields[2].time = 500;
  labels.fields[2].boxes[flag] = boxAround(place, 100, 0);
  auto found = errors();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].what, "flag.greenAbovePink");
  EXPECT_FALSE(found[0].found);
  // Aside, the nearer corner of what stands there lies lower in the image than its middle.
  EXPECT_NEAR(found[0].distance, place.norm(), 15);
  // As seen, but two degrees too far left; the right side is hidden.
  const double half = std::atan2(50, place.norm()), middle = std::atan2(place.y(), place.x());
  seen.landmarks.numberOfFlags = 1;
  seen.landmarks.flags[0].type = FlagType::greenAbovePink;
  ConditionalBoundary& boundary = seen.landmarks.flags[0].boundary;
  boundary.left = middle + half + fromDegrees(2);
  boundary.right = -1;
  boundary.rightOnBorder = true;
  found = errors();
  EXPECT_TRUE(found[0].found);
  EXPECT_NEAR(found[0].degrees, 2, 0.01);
  boundary.rightOnBorder = false;
  boundary.right = middle - half;
  EXPECT_NEAR(errors()[0].degrees, 1, 0.01);
  seen.landmarks.flags[0].type = FlagType::pinkAboveGreen;
  EXPECT_FALSE(errors()[0].found);
}

TEST_F(LabelErrorsTest, OfPlayersAreThoseOfTheNearestOneOfTheirColor) {
  const BoxName player{BoxName::Kind::player, static_cast<int>(TeamColor::blue), 1};
  const Vector2d place{900, -200};
  labels.fields[2].time = 500;
  labels.fields[2].boxes[player] = boxAround(place, 150, 0);
  seen.players.players[TeamColor::red] = {place};
  EXPECT_FALSE(errors()[0].found);
  const double direction = std::atan2(place.y(), place.x()) + fromDegrees(4);
  seen.players.players[TeamColor::blue] = {{500, 500}, {std::cos(direction), std::sin(direction)}};
  EXPECT_NEAR(errors()[0].degrees, 4, 0.15);
}

TEST_F(LabelErrorsTest, OfLinesAndPostsAreFromTheNearest) {
  labels.fields[2].time = 500;
  labels.fields[2].lines = {
      {inImage({800, -100, 0}), inImage({800, 0, 0}), inImage({800, 100, 0})}};
  labels.fields[2].leftPost = inImage({1200, 250, 0});
  seen.lines.points[EdgeType::line] = {{800, 50}, {400, 0}};
  seen.landmarks.numberOfGoals = 1;
  seen.landmarks.goals[0].boundary.left = std::atan2(250, 1200) - fromDegrees(1);
  seen.landmarks.goals[0].boundary.right = -0.3;
  const auto found = errors();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].what, "lines");
  EXPECT_TRUE(found[0].found);
  EXPECT_NEAR(found[0].degrees, 0, 0.1);
  EXPECT_EQ(found[1].what, "post");
  EXPECT_NEAR(found[1].degrees, 1, 1e-6);
  EXPECT_NEAR(found[1].distance, std::hypot(1200, 250), 1e-6);
}

}  // namespace
}  // namespace gt
