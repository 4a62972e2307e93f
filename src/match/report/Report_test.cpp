#include "match/report/Report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/File.h"
#include "match/report/PageFiles.h"
#include "match/report/SampleMatch.h"
#include "streams/Json.h"
#include "views/painting/Sheet.h"

namespace gt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A folder for one test's files, removed afterwards.
class ReportTest : public testing::Test {
 protected:
  ReportTest()
      : folder_{std::filesystem::path{testing::TempDir()} /
                (std::string{"gt_report_"} +
                 testing::UnitTest::GetInstance()->current_test_info()->name())} {
    std::filesystem::create_directories(folder_);
  }
  ~ReportTest() override { std::filesystem::remove_all(folder_); }

  std::string path(const char* name) const { return folder_ / name; }
  std::string contentOf(const char* name) const {
    const auto content = readFile(path(name));
    EXPECT_TRUE(content);
    return content ? *content : "";
  }
  std::string report(const MatchSummary& match, const std::vector<ReportPicture>& pictures = {}) {
    EXPECT_TRUE(writeReport(path("report.html"), match, sampleTimes(), pictures));
    return contentOf("report.html");
  }

 private:
  std::filesystem::path folder_;
};

std::vector<std::string> namesOf(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

std::size_t occurrences(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// The data of a page, as its scripts read them.
Json dataOf(const std::string& page) {
  const std::string_view start = "<script type=\"application/json\" id=\"data\">";
  const auto begin = page.find(start) + start.size();
  const auto json = parseJson(page.substr(begin, page.find("</script>", begin) - begin), "page");
  EXPECT_TRUE(json);
  return json ? *json : Json();
}

TEST_F(ReportTest, MatchJsonIsReadBackAsItWas) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const MatchSummary match = sampleMatch(seed);
    ASSERT_TRUE(writeMatchJson(path("match.json"), match));
    const auto json = parseJson(contentOf("match.json"), "match.json");
    ASSERT_TRUE(json);
    MatchSummary back;
    ASSERT_TRUE(fromJson(*json, back));
    EXPECT_EQ(toJson(back), toJson(match));
    EXPECT_EQ(back.robots[5].samples[17].localizationError,
              match.robots[5].samples[17].localizationError);
  }
}

TEST_F(ReportTest, MatchJsonHasTheNamesThatOthersReadInTheirOrder) {
  ASSERT_TRUE(writeMatchJson(path("match.json"), sampleMatch(1)));
  const auto json = parseJson(contentOf("match.json"), "match.json");
  ASSERT_TRUE(json);
  EXPECT_THAT(namesOf(*json),
              ElementsAre("scene", "seed", "duration", "interrupted", "redScore", "blueScore",
                          "truth", "events", "broken", "play", "shots", "robots", "ball"));
  EXPECT_THAT(namesOf((*json)["events"][0]), ElementsAre("time", "kind", "text", "team", "player",
                                                         "ownGoal", "redScore", "blueScore"));
  EXPECT_THAT(namesOf((*json)["robots"][0]["localizationError"]),
              ElementsAre("count", "mean", "median", "percentile95", "maximum"));
}

TEST_F(ReportTest, TheSameMatchGivesTheSameBytesWithAnElementALine) {
  ASSERT_TRUE(writeMatchJson(path("a.json"), sampleMatch(5)));
  ASSERT_TRUE(writeMatchJson(path("b.json"), sampleMatch(5)));
  EXPECT_EQ(contentOf("a.json"), contentOf("b.json"));
  EXPECT_THAT(contentOf("a.json"), HasSubstr("\n \"seed\": 5,\n"));
  EXPECT_GT(occurrences(contentOf("a.json"), "\n"), 600u + 8u);
}

TEST_F(ReportTest, TimesJsonIsReadBackAsItWas) {
  ASSERT_TRUE(writeTimesJson(path("times.json"), sampleTimes()));
  const auto json = parseJson(contentOf("times.json"), "times.json");
  ASSERT_TRUE(json);
  MatchTimes back;
  ASSERT_TRUE(fromJson(*json, back));
  EXPECT_EQ(toJson(back), toJson(sampleTimes()));
}

TEST_F(ReportTest, WhatCannotBeWrittenIsAnErrorThatNamesTheFile) {
  const auto result = writeReport(path("missing/report.html"), {}, {}, {});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text(), HasSubstr("report.html"));
}

TEST_F(ReportTest, ThePageHoldsTheMatch) {
  const MatchSummary match = sampleMatch(7);
  const std::string page = report(match, samplePictures(7, 2));
  EXPECT_THAT(page, HasSubstr("<title>Red 3 : 2 Blue"));
  const Json data = dataOf(page);
  EXPECT_EQ(data["match"]["seed"], "7");
  EXPECT_EQ(data["match"]["events"], toJson(match)["events"]);
  ASSERT_EQ(data["match"]["robots"].size(), 8u);
  const Json& samples = data["match"]["robots"][6]["samples"];
  ASSERT_EQ(samples["x"].size(), 600u);
  EXPECT_EQ(samples["x"][99], std::llround(match.robots[6].samples[99].pose.translation.x()));
  EXPECT_EQ(samples["error"][99], std::llround(match.robots[6].samples[99].localizationError));
  EXPECT_EQ(data["match"]["ball"]["y"][5], std::llround(match.ball[5].y()));
  ASSERT_EQ(data["pictures"].size(), 2u);
  EXPECT_EQ(data["pictures"][0]["width"], 352);
  EXPECT_EQ(data["field"]["xGroundline"], 2100);
  EXPECT_EQ(occurrences(page, std::string{page::chartLibrary().substr(0, 200)}), 1u);
}

TEST_F(ReportTest, ThePageShowsHowTheTeamsPlayed) {
  const MatchSummary match = sampleMatch(7);
  const std::string page = report(match);
  EXPECT_EQ(dataOf(page)["match"]["play"], toJson(match)["play"]);
  EXPECT_EQ(dataOf(page)["match"]["shots"], toJson(match)["shots"]);
  for (const PlayFigure& figure : match.play) {
    if (!figure.name.starts_with("ball.")) continue;
    EXPECT_THAT(page, HasSubstr("  " + figure.name.substr(5) + ": '")) << "words for it";
  }
}

TEST_F(ReportTest, ThePageNamesRobotsThatWereGivenTheTruth) {
  MatchSummary match = sampleMatch(7);
  EXPECT_TRUE(dataOf(report(match))["match"]["truth"].empty());
  match.truth = {"red2", "blue1"};
  const std::string page = report(match);
  EXPECT_EQ(dataOf(page)["match"]["truth"], (Json{"red2", "blue1"}));
  EXPECT_THAT(page, HasSubstr("<p id=\"truth\" hidden></p>"));
  EXPECT_THAT(page, HasSubstr("Given the truth by the simulator: ${match.truth.join(', ')}"));
}

TEST_F(ReportTest, ThePageNamesWhenTheMatchWasInterrupted) {
  MatchSummary match = sampleMatch(7);
  EXPECT_THAT(report(match), Not(HasSubstr("Blue, interrupted at")));
  match.interrupted = true;
  match.duration = {192'500};
  const std::string page = report(match);
  EXPECT_THAT(page, HasSubstr("<title>Red 3 : 2 Blue, interrupted at 3:12 "));
  EXPECT_EQ(dataOf(page)["match"]["interrupted"], true);
  match.duration = {65'000};
  EXPECT_THAT(report(match), HasSubstr("interrupted at 1:05"));
}

TEST_F(ReportTest, ThePageNamesRobotsWhoseProgramsFailed) {
  MatchSummary match = sampleMatch(7);
  match.broken.push_back(
      {Time{8}, Time{16}, Severity::error, "apart", "red1", "34 mm inside blue2"});
  match.events.push_back({.time = {192'500},
                          .kind = "failure",
                          .text = "blue2: its program was ended by signal 9",
                          .team = TeamColor::blue,
                          .player = 2});
  const std::string page = report(match);
  EXPECT_EQ(dataOf(page)["match"]["events"].back()["text"], match.events.back().text);
  EXPECT_THAT(page, HasSubstr("<p id=\"failures\" hidden></p>"));
  EXPECT_THAT(page, HasSubstr("events.filter((event) => event.kind === 'failure')"));
  EXPECT_EQ(dataOf(page)["match"]["broken"][0]["text"], "34 mm inside blue2");
  EXPECT_THAT(page, HasSubstr("byId('broken').hidden = match.broken.length === 0"));
}

TEST_F(ReportTest, ThePageLoadsNothingFromElsewhere) {
  std::string page = report(sampleMatch(7), samplePictures(7, 3));
  // The library's head and comments name addresses that nothing loads.
  page.erase(page.find(page::chartLibrary()), page::chartLibrary().size());
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_EQ(occurrences(page, "http:"), occurrences(page, "'http://www.w3.org/2000/svg'"));
  for (const char* load : {" src=", "<link", " href=", "@import", "url(", "fetch(", "import("})
    EXPECT_THAT(page, Not(HasSubstr(load)));
  EXPECT_THAT(page, Not(testing::ContainsRegex("@[A-Z_]+@")));
}

TEST_F(ReportTest, TenMinutesWithADozenImagesAreLessThanTwoMegabytes) {
  const std::string page = report(sampleMatch(7), samplePictures(7, 12));
  EXPECT_LT(page.size(), 2'000'000u);
  // To look at a page in a browser: GT_REPORT=page.html gt_match_report_test
  if (const char* file = std::getenv("GT_REPORT")) {
    EXPECT_TRUE(writeFile(file, page));
  }
}

TEST_F(ReportTest, NoTextLeavesItsPlaceInThePage) {
  MatchSummary match = sampleMatch(1);
  const std::string evil =
      "</script><script>alert(1)</script><!-- & \xE2\x80\xA8 @STYLE@ \" \\ \xFF";
  match.scene = match.events[1].text = match.robots[0].name = evil;
  const std::string plain = report(sampleMatch(1)), page = report(match);
  EXPECT_EQ(occurrences(page, "</script>"), occurrences(plain, "</script>"));
  EXPECT_EQ(occurrences(page, "<!--"), occurrences(plain, "<!--"));
  EXPECT_THAT(page, Not(HasSubstr("\xE2\x80\xA8")));
  const std::string scene = dataOf(page)["match"]["scene"];
  EXPECT_THAT(scene,
              HasSubstr("</script><script>alert(1)</script><!-- & \xE2\x80\xA8 @STYLE@ \" \\ "));
}

TEST_F(ReportTest, OddMatchesGiveAPageToo) {
  MatchSummary match = sampleMatch(1);
  match.robots[0].samples[3].pose.translation.x() = std::numeric_limits<double>::quiet_NaN();
  match.robots[1].samples.clear();
  match.seed = std::numeric_limits<std::uint64_t>::max();
  const Json data = dataOf(report(match, {{"broken", 10, 10, {1, 2, 3}}}));
  EXPECT_TRUE(data["match"]["robots"][0]["samples"]["x"][3].is_null());
  EXPECT_EQ(data["match"]["seed"], "18446744073709551615");
  EXPECT_TRUE(data["pictures"].empty());
  EXPECT_TRUE(dataOf(report({}))["match"]["robots"].empty());
}

TEST_F(ReportTest, LongMatchesAreThinnedAndKeepTheirLargestErrors) {
  MatchSummary match = sampleMatch(1);
  std::vector<RobotSample>& samples = match.robots[0].samples;
  samples.assign(7200, {Pose2D{}, 100});
  samples[4001].localizationError = 1234;
  const Json data = dataOf(report(match));
  EXPECT_EQ(data["sampleSeconds"], 4);
  const Json& errors = data["match"]["robots"][0]["samples"]["error"];
  ASSERT_EQ(errors.size(), 1800u);
  EXPECT_EQ(errors[1000], 1234);
  EXPECT_EQ(errors[1001], 100);
}

TEST(SampleMatch, ImagesShowTheBallWhereTheySay) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto [width, height, rgb] = rgbOf(sampleImage(seed, {60, 90}, 10));
    const auto* ball = &rgb[static_cast<std::size_t>(3 * (90 * width + 60))];
    const auto* carpet = &rgb[static_cast<std::size_t>(3 * (120 * width + 60))];
    EXPECT_GT(ball[0], ball[2] + 60);
    EXPECT_GT(carpet[1], carpet[0] + 20);
  }
}

}  // namespace
}  // namespace gt
