#include "console/Usage.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

Usage::Next next(std::string_view usage, std::vector<std::string> words) {
  return Usage{usage}.next(words);
}

TEST(Usage, AlternativesAndGroups) {
  constexpr auto usage = "? | KEY (off | on | NUMBER | every NUMBER [ms])";
  EXPECT_THAT(next(usage, {}).words, ElementsAre("?"));
  EXPECT_THAT(next(usage, {}).placeholders, ElementsAre("KEY"));
  EXPECT_THAT(next(usage, {"a"}).words, UnorderedElementsAre("off", "on", "every"));
  EXPECT_THAT(next(usage, {"a"}).placeholders, ElementsAre("NUMBER"));
  EXPECT_THAT(next(usage, {"a", "every"}).placeholders, ElementsAre("NUMBER"));
  EXPECT_THAT(next(usage, {"a", "every", "3"}).words, ElementsAre("ms"));
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"a", "on"}, {"?"}, {"a", "every", "3", "ms"}, {"a", "on", "on"}}) {
    EXPECT_THAT(next(usage, words).words, IsEmpty());
    EXPECT_THAT(next(usage, words).placeholders, IsEmpty());
  }
}

TEST(Usage, WhatMayBeMissingOrRepeated) {
  constexpr auto usage = "[gameManager] (A.B.C.D | A.B.C D {D}) [LAST]";
  EXPECT_THAT(next(usage, {}).words, ElementsAre("gameManager"));
  EXPECT_THAT(next(usage, {"gameManager"}).words, IsEmpty());
  EXPECT_THAT(next(usage, {"1.2.3", "4", "5"}).placeholders, UnorderedElementsAre("D", "LAST"));
  EXPECT_THAT(next("TASK[.SOLUTION].PATH VALUE", {}).placeholders,
              ElementsAre("TASK[.SOLUTION].PATH"));
}

TEST(Usage, ConditionsAndCommandsGoOn) {
  constexpr auto usage = "CONDITION [within SECONDS]";
  EXPECT_THAT(next(usage, {"a", "<", "3"}).words, ElementsAre("within"));
  EXPECT_THAT(next(usage, {"a", "<", "3"}).placeholders, ElementsAre("CONDITION"));
  EXPECT_THAT(next(usage, {}).words, IsEmpty());
  EXPECT_EQ(next("BUTTON COMMAND", {"1", "mr", "walk"}).command, 1u);
  EXPECT_FALSE(next("BUTTON COMMAND", {}).command);
}

bool matches(std::string_view usage, std::vector<std::string> words) {
  return Usage{usage}.matches(words);
}

TEST(Usage, MatchesSoManyWordsAtMost) {
  for (const char* usage : {"CONDITION [within SECONDS]", "{A}", "{A | b [c]}", "TEXT"}) {
    EXPECT_TRUE(matches(usage, std::vector<std::string>(Usage::mostWords, "not"))) << usage;
    EXPECT_FALSE(matches(usage, std::vector<std::string>(Usage::mostWords + 1, "not"))) << usage;
    EXPECT_FALSE(matches(usage, std::vector<std::string>(1'000'000, "not"))) << usage;
    EXPECT_THAT(next(usage, std::vector<std::string>(1'000'000, "not")).placeholders, IsEmpty());
  }
}

TEST(Usage, MatchesWholeLinesOnly) {
  constexpr auto usage = "? | KEY (off | every NUMBER [ms])";
  EXPECT_TRUE(matches(usage, {"?"}));
  EXPECT_TRUE(matches(usage, {"a", "off"}));
  EXPECT_TRUE(matches(usage, {"a", "every", "3"}));
  EXPECT_TRUE(matches(usage, {"a", "every", "3", "ms"}));
  for (const auto& words : std::vector<std::vector<std::string>>{{},
                                                                 {"a"},
                                                                 {"?", "off"},
                                                                 {"a", "on"},
                                                                 {"a", "every"},
                                                                 {"a", "every", "3", "s"},
                                                                 {"a", "off", "off"}})
    EXPECT_FALSE(matches(usage, words));
  EXPECT_TRUE(matches("", {}));
  EXPECT_FALSE(matches("", {"a"}));
}

TEST(Usage, TextsConditionsAndCommandsMatchAnyWords) {
  EXPECT_TRUE(matches("[TEXT]", {}));
  EXPECT_TRUE(matches("[TEXT]", {"what", "is", "?"}));
  EXPECT_FALSE(matches("CONDITION [within SECONDS]", {}));
  EXPECT_TRUE(matches("CONDITION [within SECONDS]", {"a", "<", "3", "within", "5"}));
  EXPECT_TRUE(matches("BUTTON COMMAND", {"1", "mr", "walk", "?"}));
  EXPECT_FALSE(matches("BUTTON COMMAND", {"1"}));
  EXPECT_TRUE(matches("AXIS VALUE {AXIS VALUE}", {"x", "1", "y", "2"}));
  EXPECT_FALSE(matches("AXIS VALUE {AXIS VALUE}", {"x", "1", "y"}));
}

}  // namespace
}  // namespace gt
