#include "measure/RunJobs.h"

#include <gmock/gmock.h>

#include <atomic>
#include <limits>
#include <stdexcept>

#include "base/TemporaryFolder.h"

namespace gt {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

std::atomic<int> running = 0;
std::atomic<bool> wasAlone = true;

Result<Measurement> square(const Job& job, const DataRoot&) {
  ++running;
  Measurement measurement;
  const double x = job.number("x");
  const double more = job.parameter("kind") == "b" ? 100 : 0;
  measurement.add("test.square", "", x * x + static_cast<double>(job.seed) + more);
  --running;
  return measurement;
}

Result<Measurement> misbehave(const Job& job, const DataRoot&) {
  if (job.seed == 1) throw std::runtime_error{"thrown"};
  if (job.seed == 2) return Error{.file = "file", .line = 3, .what = "is wrong"};
  Measurement measurement;
  measurement.add("wrong.value", "",
                  job.seed == 3 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
  return measurement;
}

Result<Measurement> watch(const Job&, const DataRoot&) {
  if (running > 0) wasAlone = false;
  return Measurement{};
}

const Experiments experiments{{"test.square",
                               "",
                               {{"kind", "", Parameter::Kind::each, {"a", "b"}, true},
                                {"x", "", Parameter::Kind::number, {"2"}}},
                               square},
                              {"wrong", "", {}, misbehave},
                              {"watch", "", {}, watch, true, true}};

std::vector<std::string> textsOf(const Result<std::vector<Job>>& jobs) {
  if (!jobs) return {jobs.error().text()};
  std::vector<std::string> texts;
  for (const Job& job : *jobs) texts.push_back(job.text());
  return texts;
}

TEST(ListJobs, HasAJobForEachSeedAndValue) {
  EXPECT_THAT(textsOf(listJobs(experiments, {{3, 4}, {"test"}, {}}, "c")),
              ElementsAre("test.square kind=a x=2 seed=3 commit=c",
                          "test.square kind=b x=2 seed=3 commit=c",
                          "test.square kind=a x=2 seed=4 commit=c",
                          "test.square kind=b x=2 seed=4 commit=c"));
  EXPECT_THAT(textsOf(listJobs(experiments, {{3, 4}, {"watch"}, {}}, "")),
              ElementsAre("watch seed=3"));
}

TEST(ListJobs, SettingsReplaceValues) {
  EXPECT_THAT(textsOf(listJobs(experiments, {{1}, {"test.square"}, {"x=5", "kind=b"}}, "")),
              ElementsAre("test.square kind=b x=5 seed=1"));
}

TEST(ListJobs, UnknownNamesAndValuesAreErrors) {
  EXPECT_THAT(textsOf(listJobs(experiments, {{1}, {"nothing"}, {}}, "")),
              ElementsAre("nothing: is neither an experiment nor a group of: test.square wrong "
                          "watch"));
  EXPECT_THAT(textsOf(listJobs(experiments, {{1}, {}, {"y=5"}}, "")),
              ElementsAre("y: is a parameter of none of the experiments"));
  EXPECT_THAT(textsOf(listJobs(experiments, {{1}, {}, {"kind=c"}}, "")),
              ElementsAre("kind: 'c' is none of: a b"));
  EXPECT_THAT(textsOf(listJobs(experiments, {{1}, {}, {"x=many"}}, "")),
              ElementsAre("x: 'many' is not a number"));
}

TEST(ParseSeeds, TakesOneOrARange) {
  EXPECT_THAT(*parseSeeds("7"), ElementsAre(7));
  EXPECT_THAT(*parseSeeds("7..9"), ElementsAre(7, 8, 9));
  for (const char* wrong : {"", "x", "9..7", "1..2x", "1..", "1..20000"})
    EXPECT_FALSE(parseSeeds(wrong)) << wrong;
}

TEST(Completed, FillsInWhatAJobDoesNotName) {
  EXPECT_EQ(completed(*parseJob("test.square seed=3"), experiments, "c")->text(),
            "test.square kind=a x=2 seed=3 commit=c");
  EXPECT_EQ(completed(*parseJob("nothing"), experiments, "c").error().text(),
            "nothing: there is no such experiment");
  EXPECT_EQ(completed(*parseJob("wrong commit=d"), experiments, "c").error().text(),
            "d: is another commit than this program's, c");
  EXPECT_EQ(completed(*parseJob("wrong commit=c+1"), experiments, "c+2").error().text(),
            "c+1: is of other files of the project than there are now, c+2");
  EXPECT_EQ(completed(*parseJob("wrong commit=c"), experiments, "c+2")->commit, "c+2");
  EXPECT_EQ(completed(*parseJob("wrong commit=c+2"), experiments, "c+2")->commit, "c+2");
  EXPECT_EQ(completed(*parseJob("wrong x=1"), experiments, "c").error().text(),
            "x: is not a parameter of wrong");
}

/// The results of jobs and what was reported of those that failed.
struct Done {
  JobResults results;
  std::vector<std::string> errors;
  int failed = 0;
};

Done run(const std::vector<Job>& jobs, unsigned threads) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "results").string();
  auto writer = JobResultWriter::open(path);
  Done done;
  RunOptions options;
  options.threads = threads;
  options.report = [&](const Job& job, const Result<void>& result) {
    if (!result) done.errors.push_back(job.text() + ": " + result.error().text());
  };
  done.failed = *runJobs(jobs, experiments, {}, *writer, options);
  EXPECT_TRUE(done.results.read(path));
  return done;
}

TEST(RunJobs, MeasuresTheSameOnAnyNumberOfThreads) {
  const auto jobs = *listJobs(experiments, {*parseSeeds("1..20"), {"test"}, {}}, "c");
  Done one = run(jobs, 1), three = run(jobs, 3);
  EXPECT_EQ(one.results.results.size(), 40u);
  const auto figures = merge(one.results);
  EXPECT_EQ(figures->json(), merge(three.results)->json());
  EXPECT_EQ(figures->find("test.square")->runs[2], 7);
}

TEST(RunJobs, NamesTellAValueUnlessItIsTheFirst) {
  Done done = run(*listJobs(experiments, {{1}, {"test"}, {}}, ""), 1);
  const auto figures = merge(done.results);
  EXPECT_EQ(figures->all().size(), 2u);
  EXPECT_EQ(figures->find("test.square")->value, 5);
  EXPECT_EQ(figures->find("test.b.square")->value, 105);
}

TEST(RunJobs, AJobThatFailsDoesNotKeepTheOthersFromBeingDone) {
  const auto jobs = *listJobs(experiments, {*parseSeeds("1..5"), {"wrong"}, {}}, "");
  const Done done = run(jobs, 2);
  EXPECT_EQ(done.failed, 3);
  EXPECT_EQ(done.results.results.size(), 2u);
  EXPECT_THAT(done.errors, UnorderedElementsAre("wrong seed=1: exception: thrown",
                                                "wrong seed=2: file:3: is wrong",
                                                "wrong seed=3: wrong.value: is not a number"));
}

TEST(RunJobs, WhatMustBeAloneIsAlone) {
  const auto jobs = *listJobs(experiments, {*parseSeeds("1..50"), {"watch", "test"}, {}}, "");
  EXPECT_EQ(run(jobs, 3).failed, 0);
  EXPECT_TRUE(wasAlone);
}

}  // namespace
}  // namespace gt
