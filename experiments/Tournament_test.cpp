#include "Tournament.h"

#include <gmock/gmock.h>

#include <set>

#include "Experiments.h"
#include "base/File.h"
#include "base/TemporaryFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

class TournamentTest : public ::testing::Test {
 protected:
  std::string team(const std::string& name, const std::string& modules) const {
    const fs::path config = folder.path() / name / "config";
    fs::create_directories(config);
    EXPECT_TRUE(writeFile((config / "modules.cfg").string(), modules));
    return (folder.path() / name).string();
  }
  static std::string errorOf(const std::vector<std::string>& teams,
                             const std::vector<std::string>& settings = {}) {
    const auto jobs = listTournament(teams, {1}, settings, {});
    return jobs ? "" : jobs.error().text();
  }

  TemporaryFolder folder;
};

TEST_F(TournamentTest, EveryTwoTeamsPlayInBothColorsOnTheSameSeeds) {
  const auto jobs = listTournament({"GT2003", team("a", ""), team("b", "SelfLocator GT2003\n")},
                                   {3, 4}, {"minutes=1"}, {});
  ASSERT_TRUE(jobs) << jobs.error().text();
  ASSERT_EQ(jobs->size(), 12u);
  std::map<std::uint64_t, std::set<std::pair<std::string, std::string>>> games;
  for (const Job& job : *jobs) {
    EXPECT_EQ(job.experiment, "match");
    EXPECT_EQ(job.parameter("minutes"), "1");
    EXPECT_EQ(job.parameter("profile"), "padova");
    games[job.seed].emplace(job.parameter("red"), job.parameter("blue"));
    const auto read = parseJob(job.text());
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, job);
  }
  EXPECT_EQ(games[3].size(), 6u);
  EXPECT_EQ(games[3], games[4]);
  for (const auto& [red, blue] : games[3]) EXPECT_TRUE(games[3].contains({blue, red}));
}

TEST_F(TournamentTest, MistakesAreToldInOneLine) {
  const std::string one = team("a", "");
  EXPECT_EQ(errorOf({one}), "tournament: expected two teams or more");
  EXPECT_THAT(errorOf({one, "nowhere"}), ::testing::HasSubstr("nowhere: is no team"));
  EXPECT_EQ(errorOf({"GT2003", one, "GT2003"}), "GT2003: is given twice");
  EXPECT_EQ(errorOf({"GT2003", one}, {"red=GT2003"}), "red=GT2003: is what the tournament sets");
  EXPECT_THAT(errorOf({"GT2003", one}, {"minuets=1"}), ::testing::HasSubstr("minuets"));
  EXPECT_EQ(errorOf({"GT2003", one}, {"oracled=red"}),
            "oracled=red: no team of a tournament is given the truth");
}

/// A team that asks for the truth is refused by its file and line; an experiment may give it.
TEST_F(TournamentTest, ATeamThatAsksForTheTruthIsRefused) {
  const std::string asking = team("asks", "BallLocator PIDSmoothed\nSelfLocator Oracled\n");
  auto jobs = listTournament({"GT2003", asking}, {1}, {"minutes=0.02"}, {});
  ASSERT_TRUE(jobs) << jobs.error().text();
  const Experiment* match = findExperiment(experiments(), "match");
  for (Job& job : *jobs) {
    const auto refused = match->measure(job, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().text(),
              asking +
                  "/config/modules.cfg:2: SelfLocator: 'Oracled' reads OracledWorldState, "
                  "which this robot does not get");
  }
  Job& given = jobs->front();
  given.parameters["oracled"] = given.parameter("red").starts_with("GT2003") ? "blue" : "red";
  const auto played = match->measure(given, {});
  EXPECT_TRUE(played) << played.error().text();
}

/// A job names the files that its teams had: with others it does not give another result, but none.
TEST_F(TournamentTest, AMatchOfATeamThatHasChangedIsRefused) {
  const std::string other = team("a", "WalkingEngine disabled\n");
  const auto jobs = listTournament({"GT2003", other}, {1}, {"minutes=0.02"}, {});
  ASSERT_TRUE(jobs);
  const Experiment* match = findExperiment(experiments(), "match");
  const auto played = match->measure(jobs->front(), {});
  EXPECT_TRUE(played) << played.error().text();
  team("a", "WalkingEngine InvKin\n");
  const auto refused = match->measure(jobs->front(), {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), ::testing::HasSubstr("has changed since"));
}

}  // namespace
}  // namespace gt
