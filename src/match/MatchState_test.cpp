#include "match/MatchState.h"

#include <gtest/gtest.h>

#include "match/TestMatch.h"

namespace gt {
namespace {

using MatchStateTest = MatchTest;

TEST_F(MatchStateTest, ASavedMatchGoesOnWithTheSameBits) {
  const std::string file = (folder / "match.state").string();
  constexpr std::int64_t intervened = wholeMatches ? 1200 : 400,
                         savedAt = wholeMatches ? 2000 : 800, end = 2 * savedAt;
  for (const char* scene : {"scenes/match.scene", "scenes/dynamic.scene"}) {
    MatchOptions options;
    options.scene = scene;
    options.profile = "padova";
    options.seed = 11;
    auto made = Match::make(options);
    ASSERT_TRUE(made) << made.error().text();
    Match* const whole = made->get();
    const auto run = [](Match& match, std::int64_t ms) {
      while (match.time() < Time{ms}) match.step();
    };
    run(*whole, intervened);
    ASSERT_TRUE(putBall(*whole, "-250"));
    whole->note(InterventionKind::console, "-250");
    run(*whole, savedAt);
    const auto saved = whole->save(file);
    ASSERT_TRUE(saved) << saved.error().text();
    run(*whole, end);
    options.threads = 2;
    auto loaded = Match::load(file, options, putBall);
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ((*loaded)->time(), Time{savedAt});
    run(**loaded, end);
    EXPECT_EQ((*loaded)->simulation().fingerprint(), whole->simulation().fingerprint());
    EXPECT_TRUE(jsonText((*loaded)->summary()) == jsonText(whole->summary()));
    // The state of the loaded match is as good as the first one's.
    ASSERT_TRUE((*loaded)->save(file));
    EXPECT_TRUE(Match::load(file, options, putBall));
  }
}

TEST_F(MatchStateTest, AChallengeThatBeganAtRandomGoesOnAsItBegan) {
  const std::string file = (folder / "match.state").string();
  MatchOptions options;
  options.scene = "scenes/ball-challenge.scene";
  options.profile = "padova";
  options.seed = 12;
  options.randomChallenge = true;
  auto whole = Match::make(options);
  ASSERT_TRUE(whole) << whole.error().text();
  const auto run = [](Match& match, std::int64_t ms) {
    while (match.time() < Time{ms}) match.step();
  };
  run(**whole, 200);
  ASSERT_TRUE((*whole)->save(file));
  options.randomChallenge = false;
  auto loaded = Match::load(file, options, putBall);
  ASSERT_TRUE(loaded) << loaded.error().text();
  run(**whole, 400);
  run(**loaded, 400);
  EXPECT_EQ((*loaded)->simulation().fingerprint(), (*whole)->simulation().fingerprint());
}

TEST_F(MatchStateTest, StatesThatDoNotFitAreRefused) {
  const std::string file = (folder / "match.state").string();
  const auto match = make("match", 1, 1, 0.01);
  for (int i = 0; i < 25; ++i) match->step();
  ASSERT_TRUE(match->save(file));
  const std::string good = *readFile(file);
  const auto errorOf = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    EXPECT_TRUE(writeFile(file, text));
    const auto loaded = Match::load(file, {}, putBall);
    return loaded ? std::string{"no error"} : loaded.error().text();
  };
  EXPECT_NE(errorOf("\"seed\": 1", "\"seed\": 2").find("went another way"), std::string::npos);
  EXPECT_NE(errorOf("\"time\": 200", "\"time\": 201").find("time"), std::string::npos);
  EXPECT_NE(errorOf("\"time\": 200", "\"time\": 8000000").find("over before"), std::string::npos);
  EXPECT_NE(errorOf("\"profile\": \"\"", "\"profile\": \"pisa\"").find("pisa"), std::string::npos);
  EXPECT_NE(errorOf("match.scene", "no.scene").find("no.scene"), std::string::npos);
  EXPECT_NE(errorOf("\"history\": []", "\"history\": [{\"time\": 800}]").find("history"),
            std::string::npos);
  EXPECT_NE(errorOf("{", "").find("match.state"), std::string::npos);
  match->markIrreproducible("somebody was hasty");
  EXPECT_FALSE(match->save(file));
}

/// A state of an earlier version lacks what a match could not have then; one of a later version may
/// have what this one does not understand.
TEST_F(MatchStateTest, StatesOfEarlierVersionsAreRead) {
  const std::string file = (folder / "old.state").string();
  const std::string old =
      R"({"scene": "scenes/match.scene", "layout": "", "behavior": "behavior/GT2003.xabsl",
          "motions": "motions", "minutes": 4.0, "seed": 7, "time": 16, "history": [],
          "fingerprint": 3)";
  ASSERT_TRUE(writeFile(file, old + "}"));
  const auto state = readMatchState(file);
  ASSERT_TRUE(state) << state.error().text();
  EXPECT_EQ(state->seed, 7u);
  EXPECT_EQ(state->profile, "");
  EXPECT_TRUE(state->truth.empty());
  ASSERT_TRUE(writeFile(file, old + R"(, "weather": "rain"})"));
  const auto later = readMatchState(file);
  ASSERT_FALSE(later);
  EXPECT_EQ(later.error().text(), file + ": weather: unknown name");
}

TEST(MatchState, MessagesBecomeDigitsAndBack) {
  const std::vector<std::byte> bytes{std::byte{0}, std::byte{0x7f}, std::byte{0xa0}};
  EXPECT_EQ(hexOf(bytes), "007fa0");
  EXPECT_EQ(bytesOf(hexOf(bytes)), bytes);
  EXPECT_EQ(bytesOf("abc").size(), 1u) << "half a byte is none";
}

}  // namespace
}  // namespace gt
