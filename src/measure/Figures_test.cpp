#include "measure/Figures.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "streams/Json.h"

namespace gt {
namespace {

using testing::ElementsAre;

TEST(Figures, AFigureIsTheMeanOfItsRunsAndTellsTheirSpread) {
  Figures figures;
  figures.add("group.error", "mm", {3, 1, 8}, Aim::atMost(5));
  const Figure& figure = *figures.find("group.error");
  EXPECT_EQ(figure.value, 4);
  EXPECT_EQ(figure.n, 3u);
  EXPECT_EQ(figure.low, 1);
  EXPECT_EQ(figure.high, 8);
  EXPECT_EQ(figure.median, 3);
  EXPECT_THAT(figure.runs, ElementsAre(3, 1, 8));
  EXPECT_TRUE(figure.aim.met(figure.value));
}

TEST(Figures, TheSeedsOfTheLowestAndTheHighestRunAreNamed) {
  Figures figures;
  figures.add("group.error", "mm", {3, 1, 8}, {}, {21, 23, 22});
  EXPECT_EQ(figures.all().front().lowSeed, 23u);
  EXPECT_EQ(figures.all().front().highSeed, 22u);
  const Json json = *parseJson(figures.json(), "");
  EXPECT_EQ(json[0]["lowSeed"], 23);
  EXPECT_EQ(json[0]["highSeed"], 22);
}

/// A kick has some hundred of them.
TEST(Figures, ThoseOfSinglePlacesAreCountedNotPrinted) {
  Figures figures;
  figures.add("kicks.push.at.100.-20.hit", "", {1, 0});
  figures.add("kicks.push.at.100.0.hit", "", {1, 1});
  figures.add("kicks.push.seconds", "s", {2, 2});
  testing::internal::CaptureStdout();
  figures.print();
  const std::string printed = testing::internal::GetCapturedStdout();
  EXPECT_THAT(printed, testing::HasSubstr("kicks.push.seconds "));
  EXPECT_THAT(printed, testing::Not(testing::HasSubstr("at.100")));
  EXPECT_THAT(printed, testing::EndsWith("\nkicks.push.at.*: 2 figures of single places, which the "
                                         "file holds\n"));
}

TEST(Figures, WithoutRunsThereIsNoFigure) {
  Figures figures;
  figures.add("group.error", "mm", {});
  EXPECT_EQ(figures.find("group.error"), nullptr);
}

TEST(Figures, ARatioReachesFromTheLeastToTheLargest) {
  Figures figures;
  figures.add("a", "us", {2, 4});
  figures.add("b", "us", {1, 2});
  figures.addRatio("ratio", "a", "b", Aim::atLeast(3));
  figures.addRatio("nothing", "a", "c");
  const Figure& ratio = *figures.find("ratio");
  EXPECT_EQ(ratio.value, 2);
  EXPECT_EQ(ratio.low, 1);
  EXPECT_EQ(ratio.high, 4);
  EXPECT_FALSE(ratio.aim.met(ratio.value));
  EXPECT_EQ(figures.find("nothing"), nullptr);
}

TEST(Figures, TheFileHoldsNamesUnitsRunsAndAims) {
  Figures figures;
  figures.add("group.a", "mm", {1, 2}, Aim::atMost(1));
  figures.add("group.b", "s", {3});
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "made/figures.json").string();
  ASSERT_TRUE(figures.write(path));
  const Json json = *parseJson(*readFile(path), path);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["name"], "group.a");
  EXPECT_EQ(json[0]["runs"], Json::array({1.0, 2.0}));
  EXPECT_EQ(json[0]["aim"], 1);
  EXPECT_EQ(json[0]["met"], false);
  EXPECT_FALSE(json[1].contains("met"));
  EXPECT_FALSE(json[1].contains("lowSeed"));
}

}  // namespace
}  // namespace gt
