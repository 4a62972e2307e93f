#include "modules/perception/calibration/CheckerboardDetector.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnCheckerboard.h"

namespace gt {
namespace {

class CheckerboardDetectorTest : public testing::Test {
 protected:
  CheckerboardDetectorTest() { detector_.parameters.pictures = 4; }

  void look(double tilt, bool valid = true) {
    DrawnField scene{tilt};
    scene.matrix.valid = valid;
    scene.draw([&](const Vector3d& ray) { return drawn_.colorAt(ray, 600); }, 1, 1, random_);
    found_.lines.points[EdgeType::line] = {{1, 2}};
    found_.ball.seen = true;
    detector_.update(scene.image, scene.matrix, sensors_, robot_, {}, found_, found_.debug);
  }

  const DrawnCheckerboard drawn_;
  const SensorDataBuffer sensors_;
  const RobotDimensions robot_;
  CheckerboardDetector detector_;
  DrawnPercepts found_;
  Random random_{4};
};

TEST_F(CheckerboardDetectorTest, FindsTheBoardAndNothingElse) {
  look(-0.05);
  EXPECT_EQ(detector_.corners().size(), 24u);
  EXPECT_FALSE(found_.ball.seen);
  EXPECT_TRUE(found_.lines.points[EdgeType::line].empty());
}

TEST_F(CheckerboardDetectorTest, CalibratesAfterSoManyImagesFromDifferentDirections) {
  for (int i = 0; i < 10; ++i) look(-0.05);
  EXPECT_EQ(detector_.calibration().pictures, 0) << "all from one direction";
  for (int i = 0; i < 10; ++i) look(-0.05 + 0.02 * (i % 2), false);
  EXPECT_EQ(detector_.calibration().pictures, 0) << "nobody knows from where";
  for (const double tilt : {-0.08, -0.05, -0.02, 0.01}) look(tilt);
  EXPECT_EQ(detector_.calibration().pictures, 4);
}

TEST_F(CheckerboardDetectorTest, LooksForTheBoardThatItIsTold) {
  look(-0.05);
  ++detector_.parameters.board.rows;
  look(-0.05);
  EXPECT_TRUE(detector_.corners().empty());
  --detector_.parameters.board.rows;
  look(-0.05);
  EXPECT_EQ(detector_.corners().size(), 24u);
}

}  // namespace
}  // namespace gt
