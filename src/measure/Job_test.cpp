#include "measure/Job.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

TEST(Job, IsOneLineWhateverTheOrderOfItsWords) {
  const auto job = parseJob("match seed=7  minutes=10 commit=abc ceiling=true");
  ASSERT_TRUE(job) << job.error().text();
  EXPECT_EQ(job->text(), "match ceiling=true minutes=10 seed=7 commit=abc");
  EXPECT_EQ(*parseJob(job->text()), *job);
  EXPECT_EQ(job->number("minutes"), 10);
  EXPECT_TRUE(job->flag("ceiling"));
}

TEST(Job, SeedsAreOrderedAsNumbers) {
  EXPECT_LT(*parseJob("match seed=9"), *parseJob("match seed=10"));
  EXPECT_LT(*parseJob("match seed=10"), *parseJob("vision seed=1"));
}

TEST(Job, WhatIsNoneIsAnError) {
  EXPECT_EQ(parseJob("  ").error().what, "expected an experiment");
  EXPECT_EQ(parseJob("match minutes").error().what, "expected NAME=VALUE");
  EXPECT_EQ(parseJob("match =3").error().what, "expected NAME=VALUE");
  EXPECT_EQ(parseJob("match seed=-1").error().what, "expected a whole number");
  EXPECT_EQ(parseJob("match seed=99999999999999999999").error().what, "expected a whole number");
  EXPECT_EQ(parseJob("match a=1 a=2").error().what, "is given twice");
}

TEST(Job, AListIsLinesWithRemarks) {
  const auto jobs = parseJobs("# remark\n\nmatch seed=1\n  match seed=2\n", "list");
  ASSERT_TRUE(jobs);
  ASSERT_EQ(jobs->size(), 2u);
  EXPECT_EQ((*jobs)[1].seed, 2u);
  EXPECT_EQ(parseJobs("match seed=1\nmatch x\n", "list").error().text(),
            "list:2: x: expected NAME=VALUE");
}

TEST(Job, ListsAreReadAsOtherMachinesWriteThem) {
  const auto plain = parseJobs("match seed=1\n# remark\nmatch seed=2\n", "list");
  const auto other = parseJobs("\xEF\xBB\xBFmatch seed=1\r\n\t# remark\r\nmatch seed=2", "list");
  ASSERT_TRUE(other) << other.error().text();
  EXPECT_EQ(*other, *plain);
}

TEST(JobResult, IsOneLineThatReadsBackToTheBit) {
  JobResult result{*parseJob("match minutes=10 seed=7 commit=abc"), {}};
  result.measurement.add("match.error", "mm", 0.1 + 0.2, Aim::atMost(150));
  result.measurement.add("match.goals", "goals", 3);
  const std::string line = result.text();
  EXPECT_EQ(line.find('\n'), line.npos);
  const auto read = parseJobResult(line);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->job, result.job);
  EXPECT_EQ(read->measurement, result.measurement);
}

TEST(JobResult, HalfALineIsAnError) {
  JobResult result{*parseJob("match seed=7"), {}};
  result.measurement.add("match.error", "mm", 0.1, Aim::atMost(150));
  const std::string line = result.text();
  for (std::size_t size = 0; size < line.size(); ++size)
    EXPECT_FALSE(parseJobResult(line.substr(0, size))) << line.substr(0, size);
}

}  // namespace
}  // namespace gt
