#include "gtlog/SolutionErrors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/Statistics.h"
#include "base/TemporaryFolder.h"
#include "logs/LogTransfer.h"
#include "match/Match.h"

namespace gt {
namespace {

using testing::HasSubstr;

/// The errors of a robot of a match are those that its log shows with the solutions that it had.
TEST(SolutionErrors, AreThoseOfTheMatch) {
  const TemporaryFolder folder;
  MatchOptions options;
  options.logs = folder.path().string();
  options.seed = 3;
  auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  while ((*match)->time().ms < 4000) (*match)->step();
  ASSERT_TRUE((*match)->close());
  const auto summary = (*match)->summary();
  const std::string log = (folder.path() / "red2.mcap").string();
  const auto errors = compareSolutions({log}, "SelfLocator", {"Kalman", "MonteCarlo", "Oracled"});
  ASSERT_TRUE(errors) << errors.error().text();
  ASSERT_EQ(errors->size(), 3u);
  const SolutionErrors &recorded = (*errors)[0], &other = (*errors)[1], &oracled = (*errors)[2];
  EXPECT_EQ(summary.robots[1].name, "red2");
  const ErrorStatistics& truth = summary.robots[1].localizationError;
  EXPECT_GT(truth.count, 50);
  EXPECT_EQ(recorded.position.size(), static_cast<std::size_t>(truth.count));
  EXPECT_NEAR(mean(recorded.position), truth.mean, 1e-6);
  EXPECT_NEAR(mean(recorded.rotation), summary.robots[1].rotationError.mean, 1e-9);
  EXPECT_GT(std::abs(mean(other.position) - truth.mean), 1);
  EXPECT_NEAR(mean(oracled.position), 0, 1e-9);
  const std::string table = tableOf("SelfLocator", *errors);
  EXPECT_THAT(table, HasSubstr("\nMonteCarlo "));
  EXPECT_THAT(table, HasSubstr("0.0 / 0.0"));
  EXPECT_THAT(compareSolutions({log}, "SelfLocator", {"None"}).error().text(), HasSubstr("None"));
  const std::string unknown = (folder.path() / "unknown.mcap").string();
  Selection selection;
  selection.without = {"/OracledWorldState"};
  ASSERT_TRUE(cutLog(log, selection, unknown));
  EXPECT_THAT(compareSolutions({unknown}, "SelfLocator", {"Kalman"}).error().text(),
              HasSubstr("does not hold the truth"));
}

}  // namespace
}  // namespace gt
