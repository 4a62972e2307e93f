#include "replay/Replay.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

namespace gt {
namespace {

std::string realFolder() {
  const char* real = std::getenv("GT_REAL");
  return real ? real : "../shared/real";
}

TEST(Replay, FindsTheBallInARealRobotsImages) {
  const std::string folder = realFolder();
  if (!std::filesystem::exists(folder + "/nao2009.log"))
    GTEST_SKIP() << "no real robot's log in " << folder;
  Comparison comparison;
  int pictures = 0, drawn = 0;
  const auto done = replay({{}, folder + "/nao2009.log", folder + "/coltable-field.c64"},
                           [&](const LogPlatform& platform, const BallPercept& ball,
                               const BallLabel* label) -> Result<void> {
                             const int number = platform.picture().number;
                             EXPECT_EQ(number, pictures++);
                             EXPECT_TRUE(label) << number;
                             comparison.add(ball, label);
                             drawn += !platform.drawings().empty();
                             if (!label || label->view != BallView::whole || !ball.seen) return {};
                             EXPECT_NEAR((ball.centerInImage - label->center).norm(), 0, 4)
                                 << number;
                             EXPECT_NEAR(ball.radiusInImage / label->radius, 1, 0.1) << number;
                             EXPECT_NE(compareDistances(ball, label), Verdict::visionIsOff);
                             return {};
                           });
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(pictures, 96);
  EXPECT_EQ(drawn, 96);
  EXPECT_GE(comparison.pictures(BallView::whole), 40);
  EXPECT_GE(comparison.found(BallView::whole), 0.9 * comparison.pictures(BallView::whole));
  EXPECT_EQ(comparison.found(BallView::none), 0);
}

}  // namespace
}  // namespace gt
