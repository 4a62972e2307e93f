#include "replay/NaoReplay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "modules/perception/ColorTableFile.h"

namespace gt {
namespace {

const std::string labelFile = "tests/real/nao2009-labels.csv";

TEST(Labels, CoverTheWholeLog) {
  const auto labels = readLabels(labelFile);
  ASSERT_TRUE(labels) << labels.error().text();
  EXPECT_EQ(labels->size(), 96u);
}

TEST(Labels, NameTheLineThatIsWrong) {
  const std::string file = testing::TempDir() + "labels.csv";
  const auto errorOf = [&](const std::string& row) {
    std::ofstream{file} << "picture,time,class,x,y,r\n0,1,none,0,0,0\n" << row << "\n";
    const auto labels = readLabels(file);
    EXPECT_FALSE(labels);
    return labels ? std::string{} : labels.error().text();
  };
  EXPECT_THAT(errorOf("1,2,hidden,0,0,0"), testing::HasSubstr("labels.csv:3: class"));
  EXPECT_THAT(errorOf("1,two,none,0,0,0"), testing::HasSubstr("labels.csv:3: time"));
  EXPECT_THAT(errorOf("1,2,none"), testing::HasSubstr("labels.csv:3: x"));
  EXPECT_FALSE(readLabels("no/such.csv"));
}

TEST(NaoReplay, BlamesByThePersonsCircle) {
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

TEST(NaoReplay, FindsTheBallInARealRobotsPictures) {
  const char* real = std::getenv("GT_REAL");
  const std::string folder = real ? real : "../shared/real";
  if (!std::filesystem::exists(folder + "/nao2009.log"))
    GTEST_SKIP() << "no real robot's log in " << folder;
  const auto log = readNaoLog(folder + "/nao2009.log");
  ASSERT_TRUE(log) << log.error().text();
  const auto colors = readColorTable(folder + "/coltable-field.c64", nao2009ColorOrder);
  ASSERT_TRUE(colors) << colors.error().text();
  const auto labels = readLabels(labelFile);
  ASSERT_TRUE(labels) << labels.error().text();
  ASSERT_EQ(labels->size(), log->pictures.size());

  NaoReplay replay{*log, *colors};
  NaoView view;
  int whole = 0, found = 0;
  for (const BallLabel& label : *labels) {
    const NaoPicture& picture = log->pictures[static_cast<std::size_t>(label.picture)];
    ASSERT_EQ(picture.cameraMatrix.time.ms, label.time);
    ASSERT_TRUE(replay.look(picture, view));
    if (label.view == BallView::none) {
      EXPECT_FALSE(view.ball.seen) << label.picture;
    }
    if (label.view != BallView::whole) continue;
    ++whole;
    if (!view.ball.seen) continue;
    ++found;
    EXPECT_NEAR((view.ball.centerInImage - label.center).norm(), 0, 4) << label.picture;
    EXPECT_NEAR(view.ball.radiusInImage / label.radius, 1, 0.1) << label.picture;
  }
  EXPECT_GE(whole, 40);
  EXPECT_GE(found, 0.9 * whole);
}

}  // namespace
}  // namespace gt
