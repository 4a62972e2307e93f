#include "measure/JobResults.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/File.h"
#include "base/Random.h"
#include "base/TemporaryFolder.h"

namespace gt {
namespace {

using testing::HasSubstr;

JobResult resultOf(const std::string& job, const std::string& figure, double value) {
  JobResult result{*parseJob(job), {}};
  result.measurement.add(figure, "mm", value, Aim::atMost(5));
  return result;
}

JobResults seeds(int count) {
  JobResults all;
  for (int seed = 1; seed <= count; ++seed)
    all.results.push_back(resultOf("walk seed=" + std::to_string(seed), "walk.error", seed / 7.0));
  return all;
}

std::string mergedJson(JobResults results) {
  const auto figures = merge(results);
  return figures ? figures->json() : figures.error().text();
}

TEST(JobResults, MergeToTheSameBytesInWhateverOrder) {
  JobResults results = seeds(40);
  const std::string expected = mergedJson(results);
  EXPECT_THAT(expected, HasSubstr("\"n\": 40"));
  Random random{1};
  for (int i = 0; i < 10; ++i) {
    for (std::size_t k = results.results.size(); k > 1; --k)
      std::swap(results.results[k - 1], results.results[random.index(k)]);
    EXPECT_EQ(mergedJson(results), expected);
  }
}

TEST(JobResults, AJobThatWasDoneTwiceCountsOnce) {
  JobResults results = seeds(3);
  results.results.push_back(results.results[1]);
  EXPECT_EQ(mergedJson(results), mergedJson(seeds(3)));
  EXPECT_TRUE(merge(results));
  EXPECT_TRUE(results.warnings.empty());
}

TEST(JobResults, DifferentResultsOfAJobAreWarnedOf) {
  JobResults results = seeds(2);
  results.results.push_back(resultOf("walk seed=2", "walk.error", 100));
  std::string merged = mergedJson(results);
  std::ranges::reverse(results.results);
  EXPECT_EQ(mergedJson(results), merged);
  EXPECT_TRUE(merge(results));
  ASSERT_EQ(results.warnings.size(), 1u);
  EXPECT_EQ(results.warnings.front().text(), "walk seed=2: was done twice with different results");
}

TEST(JobResults, RunsStandInTheOrderOfTheSeeds) {
  JobResults results = seeds(11);
  std::ranges::reverse(results.results);
  const auto figures = merge(results);
  EXPECT_EQ(figures->find("walk.error")->runs.front(), 1 / 7.0);
  EXPECT_EQ(figures->find("walk.error")->runs.back(), 11 / 7.0);
  EXPECT_EQ(figures->find("walk.error")->lowSeed, 1u);
  EXPECT_EQ(figures->find("walk.error")->highSeed, 11u);
  EXPECT_EQ(figures->find("walk.error")->aim, Aim::atMost(5));
}

TEST(JobResults, CommitsAndParametersDoNotMix) {
  JobResults commits;
  commits.results = {resultOf("walk seed=1 commit=a", "walk.error", 1),
                     resultOf("walk seed=2 commit=b", "walk.error", 1)};
  EXPECT_EQ(merge(commits).error().text(), "commit: results are of a and of b");
  JobResults parameters;
  parameters.results = {resultOf("walk minutes=1 seed=1", "walk.error", 1),
                        resultOf("walk minutes=2 seed=1", "walk.error", 1)};
  EXPECT_THAT(merge(parameters).error().text(), HasSubstr("walk.error: was measured by"));
}

TEST(JobResults, AFileIsContinuedBehindALineThatIsNotWhole) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "made/results.jsonl").string();
  const JobResults all = seeds(3);
  ASSERT_TRUE(JobResultWriter::open(path)->write(all.results[0]));
  const std::string half = all.results[1].text().substr(0, 30);
  ASSERT_TRUE(writeFile(path, *readFile(path) + half));
  ASSERT_TRUE(JobResultWriter::open(path)->write(all.results[2]));

  JobResults read;
  ASSERT_TRUE(read.read(path));
  ASSERT_EQ(read.results.size(), 2u);
  EXPECT_EQ(read.results[1].job.seed, 3u);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_EQ(read.warnings.front().line, 2);
  EXPECT_FALSE(read.read("/nowhere"));
}

TEST(JobResults, AreReadAsOtherMachinesWriteThem) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "results.jsonl").string();
  const JobResults all = seeds(3);
  ASSERT_TRUE(writeFile(path, "\xEF\xBB\xBF" + all.results[0].text() + "\r\n\r\n" +
                                  all.results[1].text() + "\r\n" + all.results[2].text()));
  JobResults read;
  ASSERT_TRUE(read.read(path));
  EXPECT_EQ(read.results.size(), 3u);
  EXPECT_TRUE(read.warnings.empty());
}

TEST(JobResults, MissingJobsAreThoseWithoutAResult) {
  const JobResults some = seeds(2);
  std::vector<Job> jobs;
  for (const JobResult& result : seeds(4).results) jobs.push_back(result.job);
  const std::vector<Job> missing = missingJobs(jobs, some.results);
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_EQ(missing[0].text(), "walk seed=3");
}

}  // namespace
}  // namespace gt
