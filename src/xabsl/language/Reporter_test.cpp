#include "xabsl/language/Reporter.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace xabsl {
namespace {

TEST(Reporter, SortsByFilesAndPlaces) {
  Reporter reporter;
  const std::string text = "one\ntwo\n";
  const int first = reporter.addFile("first", text), second = reporter.addFile("second");
  reporter.error({second, 1, 1}, "d");
  reporter.warning({first, 2, 3}, "c");
  reporter.error({first, 2, 1}, "b");
  reporter.fileError("third", "a");
  const std::vector<Diagnostic> all = reporter.take();
  ASSERT_EQ(all.size(), 4u);
  std::string order;
  for (const Diagnostic& diagnostic : all) order += diagnostic.message;
  EXPECT_EQ(order, "abcd");
  EXPECT_EQ(all[1].source, "two");
  EXPECT_EQ(all[3].source, "");
  EXPECT_TRUE(reporter.take().empty());
}

TEST(Reporter, KeepsAHundredErrorsAndAsManyWarnings) {
  Reporter reporter;
  const int file = reporter.addFile("file");
  for (int i = 1; i <= 150; ++i) reporter.warning({file, i, 1}, "w");
  EXPECT_FALSE(reporter.failed());
  EXPECT_FALSE(reporter.full());
  for (int i = 1; i <= 99; ++i) reporter.error({file, i, 2}, "e");
  EXPECT_FALSE(reporter.full());
  for (int i = 100; i <= 150; ++i) reporter.error({file, i, 2}, "e");
  EXPECT_TRUE(reporter.full());
  const std::vector<Diagnostic> all = reporter.take();
  EXPECT_EQ(all.size(), 200u);
  EXPECT_EQ(all.back().message, "e (no more are shown)");
}

TEST(Suggestion, OffersWhatIsSpelledAlike) {
  const auto suggested = [](const std::string& name, const std::vector<std::string>& candidates) {
    Suggestion suggestion(name);
    for (const std::string& candidate : candidates) suggestion.offer(candidate);
    return suggestion.text();
  };
  EXPECT_EQ(suggested("aproach", {"reach", "approach", "roach"}), "; did you mean 'approach'?");
  EXPECT_EQ(suggested("ab", {"xy", "completely"}), "");
  EXPECT_EQ(suggested("abcdefgh", {"abcdzzzz"}), "");
}

}  // namespace
}  // namespace xabsl
