#include "base/Suggestion.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(Suggestion, NamesWhatIsSpelledMostAlike) {
  const std::vector<std::string> known{"SelfLocator", "BallLocator", "TeamBallLocator"};
  EXPECT_EQ(suggestion("BallLocater", known), "; did you mean 'BallLocator'?");
  EXPECT_EQ(suggestion("ballLocator", known), "; did you mean 'BallLocator'?");
  EXPECT_EQ(suggestion("TeamBalLocator", known), "; did you mean 'TeamBallLocator'?");
  EXPECT_EQ(suggestion("Planner", known), "");
  EXPECT_EQ(suggestion("x", {"y"}), "") << "half of the letters are no slip";
  EXPECT_EQ(suggestion("", known), "");
  EXPECT_EQ(suggestion(std::string(100, 'a'), {std::string(100, 'a') + "b"}), "");
}

}  // namespace
}  // namespace gt
