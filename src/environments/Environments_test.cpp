#include "environments/Environments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/Hash.h"
#include "base/Random.h"

namespace gt {
namespace {

using Options = EnvironmentOptions;

Options optionsOf(std::string_view name) {
  Options options;
  options.environment = name;
  options.seconds = 0.2;
  return options;
}

std::unique_ptr<Environments> made(const Options& options, std::size_t count = 1,
                                   std::size_t threads = 1) {
  auto all = Environments::make(options, DataRoot{}, count, threads);
  EXPECT_TRUE(all) << (all ? "" : all.error().text());
  return all ? std::move(*all) : nullptr;
}

std::string errorOf(const Options& options) {
  const auto all = Environments::make(options, DataRoot{}, 1, 1);
  return all ? "" : all.error().text();
}

std::vector<float> drawn(Random& random, std::size_t count) {
  std::vector<float> numbers(count);
  for (float& number : numbers) number = static_cast<float>(random.symmetric());
  return numbers;
}

std::size_t actionsOf(const Environments& all) {
  return all.agents() * all.first().actionSpace().count();
}

std::uint64_t sumOf(Environments& all, std::size_t world) {
  Fingerprint sum;
  const std::size_t bytes = all.observations().size() / all.count();
  sum.addBytes(all.observations().subspan(world * bytes).data(), bytes);
  const std::size_t rewards = all.rewards().size() / all.count();
  sum.add(all.rewards().subspan(world * rewards).data(), rewards);
  sum.add(static_cast<double>(all.terminated()[world]));
  sum.add(static_cast<double>(all.truncated()[world]));
  return sum.value();
}

/// The steps of so many episodes that last to their ends.
int stepsOf(const Environments& all, double episodes) {
  const Environment& first = all.first();
  return static_cast<int>(episodes * first.options().seconds / first.secondsPerStep());
}

/// What each world of several gives in each step; some episodes end meanwhile.
std::vector<std::uint64_t> played(const Options& options, std::size_t count, std::size_t threads) {
  const auto all = made(options, count, threads);
  const int steps = stepsOf(*all, 1.6);
  EXPECT_TRUE(all->resetAll(5));
  std::vector<Random> random;
  for (std::size_t world = 0; world < count; ++world) random.emplace_back(world);
  std::vector<std::uint64_t> sums;
  for (int step = 0; step < steps; ++step) {
    std::vector<float> actions;
    for (Random& own : random)
      for (const float number : drawn(own, actionsOf(*all))) actions.push_back(number);
    EXPECT_TRUE(all->step(actions, true));
    for (std::size_t world = 0; world < count; ++world) sums.push_back(sumOf(*all, world));
  }
  return sums;
}

class EveryEnvironment : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryEnvironment, DoesTheSameWithAnyNumberOfThreads) {
  Options options = optionsOf(GetParam());
  options.randomize = {
      {"dynamics.friction", 0.5, 1.5}, {"dynamics.mass", 0.8, 1.2}, {"noise.joints", 0, 2}};
  const auto alone = played(options, 3, 1);
  EXPECT_EQ(alone, played(options, 3, 2));
  EXPECT_NE(alone[0], alone[1]) << "different seeds";
}

/// All that an environment offers: each kind of actions with its first kind of observations, and
/// the other way round.
std::vector<Options> everyOptions(std::string_view name) {
  std::vector<Options> all;
  for (const EnvironmentDescription& described : environments()) {
    if (described.name != name) continue;
    for (const ObservationKind observations : described.observations)
      for (const ActionKind actions : described.actions) {
        if (observations != described.observations.front() && actions != described.actions.front())
          continue;
        all.push_back(optionsOf(name));
        all.back().observations = enumName(observations);
        all.back().actions = enumName(actions);
      }
  }
  return all;
}

TEST_P(EveryEnvironment, ContinuesASavedEpisodeWithTheSameBits) {
  for (Options options : everyOptions(GetParam())) {
    const bool slow = options.actions == "parameters";
    if (slow) options.seconds = 8;
    const auto first = made(options), second = made(options);
    Random random{3};
    const auto steps = [&](int count) {
      for (int i = 0; i < count; ++i)
        ASSERT_TRUE(first->step(drawn(random, actionsOf(*first)), true));
    };
    ASSERT_TRUE(first->reset(0, 8));
    const int more = slow ? 4 : stepsOf(*first, 1.4);
    steps(2);  // which the next episode does not know of
    ASSERT_TRUE(first->reset(0, {}));
    steps(3);
    ASSERT_TRUE(second->load(0, first->save(0)));
    ASSERT_EQ(sumOf(*first, 0), sumOf(*second, 0)) << options.observations << options.actions;
    for (int i = 0; i < more; ++i) {  // into the next episode
      const auto actions = drawn(random, actionsOf(*first));
      ASSERT_TRUE(first->step(actions, true) && second->step(actions, true));
      ASSERT_EQ(sumOf(*first, 0), sumOf(*second, 0)) << i;
    }
  }
}

TEST_P(EveryEnvironment, NamesAllThatItGives) {
  for (const Options& options : everyOptions(GetParam())) {
    const auto all = made(options);
    ASSERT_TRUE(all);
    EXPECT_EQ(all->first().observationSpace().isImage(), options.observations == "image");
    EXPECT_FALSE(all->first().actionSpace().components.empty());
    EXPECT_EQ(all->terms().size(), all->agents() * all->first().terms().size());
    Random random{1};
    EXPECT_TRUE(all->step(drawn(random, actionsOf(*all)), true));
  }
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const EnvironmentDescription& described : environments()) all.push_back(described.name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, EveryEnvironment, testing::ValuesIn(names()),
                         [](const auto& info) { return std::string{info.param}; });

TEST(Environments, BeginWithRobotsThatStandUnlessTheyShallGetUp) {
  for (const EnvironmentDescription& description : environments()) {
    if (description.name == "GetUp") continue;
    for (const ActionKind actions : description.actions)
      for (const Fidelity fidelity : description.fidelities) {
        if (actions == ActionKind::joints && fidelity == Fidelity::kinematic) continue;
        Options options = optionsOf(description.name);
        options.actions = enumName(actions);
        options.fidelity = enumName(fidelity);
        const auto environment = makeEnvironment(options, DataRoot{});
        ASSERT_TRUE(environment) << environment.error().text();
        for (const std::uint64_t seed : {1, 2, 3, 4}) {
          ASSERT_TRUE((*environment)->reset(seed));
          const World& world = std::as_const(**environment).world();
          for (std::size_t i = 0; i < world.robotCount(); ++i)
            EXPECT_EQ(world.robot(i).posture, Posture::standing)
                << description.name << ' ' << options.actions << ' ' << options.fidelity
                << " robot " << i << " seed " << seed;
        }
      }
  }
}

TEST(Environments, ReportOptionsThatAreWrong) {
  EXPECT_NE(errorOf(optionsOf("Fly")), "");
  Options options = optionsOf("Walk");
  options.actions = "skills";
  EXPECT_EQ(errorOf(options), "actions: there is no 'skills'; expected joints, parameters");
  options = optionsOf("Walk");
  options.fidelity = "kinematic";
  EXPECT_EQ(errorOf(options), "fidelity: there is no 'kinematic'; expected dynamic");
  options = optionsOf("Approach");
  options.actions = "joints";
  options.fidelity = "kinematic";
  EXPECT_EQ(errorOf(options), "fidelity: there is no 'kinematic'; expected dynamic");
  options = optionsOf("Approach");
  options.agents = "all";
  EXPECT_EQ(errorOf(options), "agents: there is no 'all'; expected red");
  options = optionsOf("Walk");
  options.seconds = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(errorOf(options), "");
  for (const RandomizedNumber& number : {RandomizedNumber{"dynamics.frictoin", 1, 2},
                                         {"dynamics.friction", 2, 1},
                                         {"dynamics.friction", 0, 1},
                                         {"noise.joints", 0, 91},
                                         {"noise", 0, 1},
                                         {"joints", 0, 1},
                                         {"camera.shadows", 0.2, 0.8}}) {
    options = optionsOf("Walk");
    options.randomize = {number};
    EXPECT_NE(errorOf(options), "") << number.name;
  }
}

TEST(Environments, RefuseActionsThatAreNoNumbersAndStepsAfterTheEnd) {
  const auto all = made(optionsOf("Walk"));
  std::vector<float> actions(12);
  const std::uint64_t before = sumOf(*all, 0);
  EXPECT_FALSE(all->step(std::vector<float>(11), false));
  actions[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(all->step(actions, false));
  EXPECT_EQ(sumOf(*all, 0), before);
  actions[3] = 0;
  for (int i = 0; i < 25; ++i) ASSERT_TRUE(all->step(actions, false));
  EXPECT_TRUE(all->truncated()[0]);
  EXPECT_FALSE(all->step(actions, false));
  ASSERT_TRUE(all->step(actions, true));
  EXPECT_FALSE(all->truncated()[0]);
  EXPECT_EQ(all->rewards()[0], 0);
}

TEST(Environments, RefuseStatesThatAreNone) {
  const auto all = made(optionsOf("Walk")), other = made(optionsOf("Kick"));
  const std::uint64_t before = sumOf(*all, 0);
  std::string state = all->save(0);
  EXPECT_FALSE(all->load(0, other->save(0)));
  EXPECT_FALSE(all->load(0, state.substr(0, state.size() / 2)));
  EXPECT_FALSE(all->load(0, ""));
  EXPECT_EQ(sumOf(*all, 0), before);
  state.replace(state.find("\"fingerprint\":") + 14, 1, "1");
  EXPECT_FALSE(all->load(0, state));
}

/// The sum of each term over an episode in which the agent does the same all the time.
std::vector<double> episode(const Options& options, float action, bool* terminated = nullptr) {
  const auto all = made(options);
  const std::vector<float> actions(actionsOf(*all), action);
  std::vector<double> sums(all->first().terms().size());
  while (!all->terminated()[0] && !all->truncated()[0]) {
    EXPECT_TRUE(all->step(actions, false));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += all->terms()[i];
  }
  if (terminated) *terminated = all->terminated()[0];
  return sums;
}

TEST(Walk, RewardsTheWalkOfTheRobotsAndNotStanding) {
  Options options = optionsOf("Walk");
  options.seconds = 8;
  bool fallen = true;
  const auto standing = episode(options, 0, &fallen);
  EXPECT_FALSE(fallen);
  EXPECT_NEAR(standing[0] / 1000, 0, 0.01);  // m/s
  EXPECT_NEAR(standing[2], 100, 1);
  options.actions = "parameters";
  const auto walking = episode(options, 0, &fallen);
  EXPECT_FALSE(fallen);
  EXPECT_GT(walking[0] / 12.5, 0.08);  // m/s
  EXPECT_LT(walking[1], 0);
}

TEST(Walk, EndsWhenTheRobotFalls) {
  Options options = optionsOf("Walk");
  options.seconds = 8;
  const auto all = made(options);
  Random random{1};
  constexpr int draws = 40;
  bool fell = false;
  for (int draw = 0; draw < draws && !fell; ++draw) {  // one of many walks throws it over
    ASSERT_TRUE(all->reset(0, 1));
    std::vector<float> actions(12);
    for (float& action : actions) action = static_cast<float>(random.symmetric());
    for (int i = 0; i < 1000 && !all->terminated()[0]; ++i) ASSERT_TRUE(all->step(actions, false));
    fell = all->terminated()[0];
  }
  ASSERT_TRUE(fell);
  EXPECT_EQ(all->terms()[2], 0);
}

TEST(GetUp, CostsUntilTheRobotStands) {
  Options options = optionsOf("GetUp");
  options.seconds = 1;
  bool done = true;
  const auto lying = episode(options, 0, &done);
  EXPECT_FALSE(done);
  EXPECT_LT(lying[0], -50);  // about half of each of 125 steps
  EXPECT_LT(lying[1], -10);
}

TEST(GetUp, EndsOnceTheRobotStands) {
  Options options = optionsOf("GetUp");
  options.seconds = 5;
  const auto all = made(options);
  ASSERT_TRUE(all->reset(0, 18));
  // Drawn by chance until the robot got up: two postures, then as it stands.
  const std::vector<std::vector<float>> postures{
      {0.5F, 0.7F, -0.7F, 0.4F, 0.6F, 1, 0.7F, -0.2F, 1, 0.9F, 0, 0.5F, 0.8F, 0, 0.7F},
      {-0.5F, 0.5F, 0.5F, 0.7F, -0.7F, 0.5F, -0.1F, -0.3F, 0.5F, 0.7F, -0.4F, -0.7F, 1, 0.8F,
       -0.4F},
      std::vector<float>(15, 0)};
  int steps = 0;
  for (; steps < 500 && !all->terminated()[0]; ++steps)
    ASSERT_TRUE(all->step(postures[std::min<std::size_t>(steps / 80, 2)], false));
  EXPECT_TRUE(all->terminated()[0]);
  EXPECT_GT(steps, 160 + 62);
  EXPECT_GT(all->terms()[0], -0.05);
}

TEST(Kick, RewardsTheWayOfTheBall) {
  Options options = optionsOf("Kick");
  options.seconds = 2;
  const auto standing = episode(options, 0);
  EXPECT_NEAR(standing[0], 0, 0.02);
  const auto all = made(options);
  // Drawn by chance: one of many by which a leg or the head hits the ball.
  const std::vector<float> actions{0,     0.5F, 0.7F,  -0.1F, -0.5F, -0.8F, -1,   -0.6F,
                                   -0.4F, 0,    -0.9F, 0.7F,  0.5F,  0.6F,  -0.3F};
  double ahead = 0, astray = 0;
  for (int i = 0; i < 250 && !all->terminated()[0]; ++i) {
    ASSERT_TRUE(all->step(actions, false));
    ahead += all->terms()[0];
    astray += all->terms()[1];
  }
  EXPECT_LT(astray, 0);
  EXPECT_GT(ahead, 0.3);
}

}  // namespace
}  // namespace gt
