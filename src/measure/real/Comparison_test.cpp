#include "measure/real/Comparison.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

TEST(Comparison, BlamesByThePersonsCircle) {
  BallPercept ball;
  ball.seen = true;
  ball.distanceByProjection = 1000;
  ball.distanceBySize = 1040;
  ball.radiusInImage = 16;
  BallLabel label{0, 0, BallView::whole, {100, 100}, 16.3};
  EXPECT_EQ(compareDistances(ball, &label), Verdict::agree);
  ball.distanceBySize = 1200;
  EXPECT_EQ(compareDistances(ball, &label), Verdict::cameraMatrixIsOff);
  EXPECT_EQ(compareDistances(ball, nullptr), Verdict::notKnown);
  label.radius = 19;
  EXPECT_EQ(compareDistances(ball, &label), Verdict::visionIsOff);
  ball.distanceBySize = ball.distanceByProjection = 1600;
  EXPECT_EQ(compareDistances(ball, &label), Verdict::notCompared);
}

TEST(Comparison, CountsWhatWasFound) {
  BallPercept seen;
  seen.seen = true;
  seen.distanceByProjection = 1008;
  seen.distanceBySize = 960;
  seen.centerInImage = {103, 104};
  seen.radiusInImage = 18;
  const BallLabel whole{0, 0, BallView::whole, {100, 100}, 18.5}, none{};
  Comparison comparison;
  comparison.add(seen, &whole);
  comparison.add(BallPercept{}, &whole);
  comparison.add(seen, &none);
  comparison.add(BallPercept{}, &none);
  comparison.add(BallPercept{}, nullptr);
  EXPECT_EQ(comparison.pictures(BallView::whole), 2);
  EXPECT_EQ(comparison.found(BallView::whole), 1);
  EXPECT_EQ(comparison.found(BallView::none), 1);
  EXPECT_EQ(comparison.pictures(BallView::partial), 0);
  EXPECT_THAT(comparison.text(), testing::HasSubstr("5.00 pixels in the center and 0.50"));
  EXPECT_THAT(comparison.text(), testing::HasSubstr("agree 2 "));
  EXPECT_THAT(comparison.text(), testing::HasSubstr("size 1.050 on average"));
}

}  // namespace
}  // namespace gt
