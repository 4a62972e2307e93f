#include "framework/Warnings.h"

#include <gtest/gtest.h>

#include "framework/Requests.h"

namespace gt {
namespace {

TEST(Warnings, AreTextsRefusalsAndDrops) {
  MessageQueue queue{300};
  queue.write({8}, Text{"hello"});
  queue.write({8}, Text{"no ball at all", Severity::warning});
  queue.write({16}, RequestAnswer{1, {8}, "Motion", RequestOutcome::refused, "too late"});
  queue.write({16}, RequestAnswer{1, {8}, "Cognition", RequestOutcome::notConcerned, ""});
  ASSERT_FALSE(queue.write({16}, Text{std::string(300, 'x')}));
  MessageQueue dropped;
  queue.moveAllMessages(dropped);
  queue.reportDropped({24});
  queue.copyAllMessages(dropped);
  const Findings findings = warningsIn(dropped, "red1");
  EXPECT_EQ(findings.text(),
            "red1 at 8 ms: warning: no ball at all\n"
            "red1 at 16 ms: warning: Motion: too late\n"
            "red1 at 24 ms: warning: Text: dropped 1 messages\n");
  EXPECT_TRUE(findings.fail(true));
  EXPECT_FALSE(findings.fail(false));
}

}  // namespace
}  // namespace gt
