#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "environments/Environments.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

std::unique_ptr<Environments> environmentsOf(const char* name, const char* actions,
                                             const char* observations = "state",
                                             const char* agents = "") {
  EnvironmentOptions options;
  options.agents = agents;
  options.environment = name;
  options.actions = actions;
  options.observations = observations;
  auto all = Environments::make(options, DataRoot{}, 1, 1);
  EXPECT_TRUE(all) << (all ? "" : all.error().text());
  return all ? std::move(*all) : nullptr;
}

std::size_t indexOf(const std::vector<Component>& components, const std::string& name) {
  const auto found = std::ranges::find(components, name, &Component::name);
  EXPECT_NE(found, components.end()) << name;
  return static_cast<std::size_t>(found - components.begin());
}

/// What the first agent observes by that name now.
double seen(Environments& all, const std::string& name) {
  const auto index = indexOf(all.first().observationSpace().components, name);
  return reinterpret_cast<const float*>(all.observations().data())[index];
}

/// Actions that choose a skill.
std::vector<float> choosing(const Environments& all, const std::string& skill) {
  const auto& components = all.first().actionSpace().components;
  std::vector<float> actions(components.size());
  actions[indexOf(components, "skill." + skill)] = 1;
  return actions;
}

/// The sums of the terms of an episode in which the agent decides.
std::map<std::string, double> sumsOfEpisode(Environments& all, std::uint64_t seed,
                                            const std::function<std::vector<float>()>& decide) {
  EXPECT_TRUE(all.reset(0, seed));
  std::map<std::string, double> sums;
  while (!all.terminated()[0] && !all.truncated()[0]) {
    EXPECT_TRUE(all.step(decide(), false));
    for (std::size_t i = 0; i < all.terms().size(); ++i)
      sums[all.first().terms()[i].name] += all.terms()[i];
    ++sums["steps"];
  }
  return sums;
}

TEST(Approach, IsDoneByTheSkillOfTheRobots) {
  const auto all = environmentsOf("Approach", "skills");
  for (const std::uint64_t seed : {1, 2}) {
    const auto sums = sumsOfEpisode(*all, seed, [&] {
      const double facing =
          seen(*all, "heading") + std::atan2(seen(*all, "goal.left") - seen(*all, "ball.left"),
                                             seen(*all, "goal.ahead") - seen(*all, "ball.ahead"));
      std::vector<float> actions = choosing(*all, "go_to_ball");
      actions.back() = static_cast<float>(normalize(facing) / pi);
      return actions;
    });
    EXPECT_EQ(sums.at("done"), 1);
    EXPECT_GT(sums.at("closer"), 0.2);
    EXPECT_NEAR(sums.at("time"), -0.1 * 0.04 * sums.at("steps"), 1e-9);
    EXPECT_NEAR(seen(*all, "ball.ahead"), 0.15, 0.03);
    EXPECT_NEAR(seen(*all, "ball.left"), 0, 0.03);
    EXPECT_LT(std::abs(std::atan2(seen(*all, "goal.left"), seen(*all, "goal.ahead"))),
              fromDegrees(20));
  }
}

TEST(Approach, RewardsNothingWhoStands) {
  const auto all = environmentsOf("Approach", "motion");
  const auto sums = sumsOfEpisode(*all, 1, [&] { return std::vector<float>(3); });
  EXPECT_EQ(sums.at("done"), 0);
  EXPECT_NEAR(sums.at("closer"), 0, 0.05);
  EXPECT_NEAR(sums.at("time"), -2, 1e-6);
}

TEST(Approach, MovesTheRobotAsItIsTold) {
  const auto all = environmentsOf("Approach", "motion");
  ASSERT_TRUE(all->reset(0, 4));
  const double heading = seen(*all, "heading");
  for (int i = 0; i < 25; ++i) ASSERT_TRUE(all->step(std::vector<float>{0, 0, 0.5F}, false));
  EXPECT_NEAR(normalize(seen(*all, "heading") - heading), 0.9, 0.3);  // rad
  const Vector2d from{seen(*all, "pose.x"), seen(*all, "pose.y")};
  for (int i = 0; i < 25; ++i) ASSERT_TRUE(all->step(std::vector<float>{0.6F, 0, 0}, false));
  const Vector2d walked = Vector2d{seen(*all, "pose.x"), seen(*all, "pose.y")} - from;
  EXPECT_NEAR(walked.norm(), 0.13, 0.05);  // m
  EXPECT_NEAR(normalize(angleOf(walked) - seen(*all, "heading")), 0, 0.3);
}

TEST(Approach, TurnsByItsJointsInTheDynamicFidelity) {
  const auto all = environmentsOf("Approach", "joints");
  EXPECT_EQ(all->first().options().fidelity, "dynamic");
  ASSERT_TRUE(all->reset(0, 4));
  const auto& components = all->first().actionSpace().components;
  std::vector<float> actions(components.size());
  actions[indexOf(components, "headPan")] = 0.5F;
  for (int i = 0; i < 60; ++i) ASSERT_TRUE(all->step(actions, false));
  EXPECT_NEAR(seen(*all, "angle.headPan"), 0.5 * limitsOf(Joint::headPan).high, 0.1);
  EXPECT_NEAR(seen(*all, "angle.headPan"), seen(*all, "requested.headPan"), 0.1);
}

TEST(Approach, ObservesBeliefsThatAreNotTheTruthButNearIt) {
  const auto believes = environmentsOf("Approach", "skills", "beliefs"),
             knows = environmentsOf("Approach", "skills");
  ASSERT_TRUE(believes->reset(0, 6));
  for (int i = 0; i < 200; ++i)
    ASSERT_TRUE(believes->step(choosing(*believes, "search_ball"), false));
  EXPECT_LT(seen(*believes, "ballAge"), 5);
  ASSERT_TRUE(knows->reset(0, 6));
  EXPECT_EQ(seen(*knows, "ballAge"), 0);
  const Vector2d believed{seen(*believes, "ball.ahead"), seen(*believes, "ball.left")};
  EXPECT_GT(believed.norm(), 0.2);
  EXPECT_LT(believed.norm(), 3);
}

TEST(Penalty, IsScoredByTheSkillOfTheRobots) {
  const auto all = environmentsOf("Penalty", "skills");
  double goals = 0, ball = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto sums = sumsOfEpisode(*all, seed, [&] { return choosing(*all, "handle_ball"); });
    EXPECT_EQ(all->terminated()[0], sums.at("goal") != 0);
    goals += sums.at("goal") / 5;
    ball += sums.at("ball");
  }
  EXPECT_GE(goals, 1);
  EXPECT_GT(ball, 2);  // m
}

TEST(Penalty, KicksIfToldTo) {
  const auto all = environmentsOf("Penalty", "motion");
  ASSERT_TRUE(all->reset(0, 1));
  const auto& components = all->first().actionSpace().components;
  std::vector<float> kick(components.size());
  kick[indexOf(components, "kick.pushStrong")] = 1;
  constexpr double kicked = 0.6;  // m/s
  double fastest = 0;
  for (int i = 0; i < 300 && fastest < kicked; ++i) {
    std::vector<float> walk(components.size());
    const Vector2d ball{seen(*all, "ball.ahead") - 0.14, seen(*all, "ball.left")};
    walk[0] = static_cast<float>(4 * ball.x());
    walk[1] = static_cast<float>(5 * ball.y());
    ASSERT_TRUE(all->step(ball.norm() < 0.03 ? kick : walk, false));
    fastest =
        std::max(fastest, std::hypot(seen(*all, "ballSpeed.ahead"), seen(*all, "ballSpeed.left")));
  }
  EXPECT_GT(fastest, kicked);
}

TEST(Goalie, LosesWhoStandsAndSavesWhoGuards) {
  const auto all = environmentsOf("Goalie", "skills");
  double standing = 0, guarding = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    standing += sumsOfEpisode(*all, seed, [&] { return choosing(*all, "stand"); }).at("goal");
    EXPECT_EQ(all->truncated()[0], !all->terminated()[0]);
    guarding +=
        sumsOfEpisode(*all, seed, [&] { return choosing(*all, "goalie_playing"); }).at("goal");
  }
  EXPECT_LE(standing, -8);
  EXPECT_GT(guarding, standing);
}

TEST(Localize, KnowsMoreWhoLooksForLandmarksThanWhoLooksAtTheGround) {
  const auto looking = environmentsOf("Localize", "skills"),
             blind = environmentsOf("Localize", "joints");
  double saw = 0, guessed = 0;
  for (const std::uint64_t seed : {1, 2}) {
    const auto sums = sumsOfEpisode(*looking, seed, [] {
      return std::vector<float>{1, 0, 0, 0, 0};
    });
    EXPECT_EQ(sums.at("steps"), 750);
    EXPECT_LT(std::abs(seen(*looking, "believed.x") - seen(*looking, "pose.x")), 0.3);
    EXPECT_LT(std::abs(seen(*looking, "believed.y") - seen(*looking, "pose.y")), 0.3);
    saw += sums.at("place");
    guessed += sumsOfEpisode(*blind, seed, [] { return std::vector<float>{-1, 0, 0}; }).at("place");
  }
  EXPECT_LT(guessed, 2 * saw);
  EXPECT_LT(saw, 0);
}

TEST(Soccer, IsPlayedByTheRobotsThemselvesIfToldTo) {
  const auto all = environmentsOf("Soccer", "skills", "state", "all");
  ASSERT_EQ(all->agents(), 8);
  const std::size_t numbers = all->first().actionSpace().count();
  std::vector<float> play(8 * numbers);
  for (std::size_t agent = 0; agent < 8; ++agent) play[agent * numbers] = 1;
  ASSERT_TRUE(all->reset(0, 1));
  std::vector<double> sums(all->terms().size());
  while (!all->terminated()[0] && !all->truncated()[0]) {
    ASSERT_TRUE(all->step(play, false));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += all->terms()[i];
    for (std::size_t agent = 0; agent < 8; ++agent)
      EXPECT_EQ(all->rewards()[agent], all->rewards()[agent / 4 * 4]);
    EXPECT_NEAR(all->terms()[1], -all->terms()[4 * 3 + 1], 1e-12);
    EXPECT_EQ(all->terms()[2], -all->terms()[4 * 3 + 2]);
  }
  EXPECT_GT(std::abs(sums[0]) + std::abs(sums[12]), 0.02);
  EXPECT_GT(std::abs(sums[1]), 0.1);  // the ball was played
}

TEST(Soccer, ShowsBothTeamsTheFieldFromTheirOwnSide) {
  const auto all = environmentsOf("Soccer", "motion", "state", "all");
  ASSERT_TRUE(all->reset(0, 3));
  const Space& space = all->first().observationSpace();
  const auto* numbers = reinterpret_cast<const float*>(all->observations().data());
  const auto of = [&](std::size_t agent, const std::string& name) {
    return numbers[agent * space.count() + indexOf(space.components, name)];
  };
  for (std::size_t agent = 0; agent < 8; ++agent) {
    EXPECT_LT(of(agent, "pose.x"), 1) << "most of them in the own half";
    EXPECT_EQ(of(agent, "number." + std::to_string(agent % 4 + 1)), 1);
    // Where the robot, its heading, and the goal that it plays to put the middle of the goal.
    const Pose2D self{of(agent, "heading"), of(agent, "pose.x"), of(agent, "pose.y")};
    const Vector2d goal = self * Vector2d{of(agent, "goal.ahead"), of(agent, "goal.left")};
    EXPECT_NEAR((goal - Vector2d{2.1, 0}).norm(), 0, 1e-5);
    EXPECT_EQ(of(agent, "teammate3.validity"), 1);
  }
  EXPECT_LT(of(0, "pose.x"), -1.5) << "the goalie";
  EXPECT_LT(of(4, "pose.x"), -1.5) << "the other one";
}

}  // namespace
}  // namespace gt
