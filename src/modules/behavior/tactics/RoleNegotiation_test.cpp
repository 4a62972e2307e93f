#include "modules/behavior/tactics/RoleNegotiation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numeric>

#include "base/Random.h"

namespace gt {
namespace {

/// Three field players, 2 to 4, that hear each other with a delay, if the network is not down.
class Team {
 public:
  /// Cycles of 40 ms, with the players' times to the ball in ms.
  void run(int ms, std::array<double, 3> times) {
    for (const int end = now_ + ms; now_ < end; now_ += 40) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (off_[i]) continue;
        const auto number = static_cast<int>(i) + 2;
        players_[i].update({number, times[i], x_[i]}, heard_[i], {now_});
        TeamMessage message;
        message.playerNumber = number;
        message.robotPose.translation.x() = x_[i];
        message.behavior = players_[i].message();
        if (!down_) underway_.push_back({now_ + 120, message});
      }
      for (; !underway_.empty() && underway_.front().due <= now_; underway_.pop_front())
        for (std::size_t i = 0; i < 3; ++i) {
          const TeamMessage& message = underway_.front().message;
          if (message.playerNumber == static_cast<int>(i) + 2) continue;
          heard_[i].byPlayer[static_cast<std::size_t>(message.playerNumber - 1)] = {message,
                                                                                    {now_}};
        }
      ms_[std::min<std::size_t>(strikers(), 2)] += 40;
    }
  }

  /// The same while the network is down.
  void runApart(int ms, std::array<double, 3> times) {
    breakDown(true);
    run(ms, times);
    breakDown(false);
  }

  std::size_t strikers() const {
    return static_cast<std::size_t>(std::ranges::count_if(players_, [this](const auto& player) {
      return !off_[static_cast<std::size_t>(&player - players_.data())] &&
             player.role() == DynamicRole::striker;
    }));
  }
  DynamicRole role(int number) const {
    return players_[static_cast<std::size_t>(number - 2)].role();
  }
  /// For how long there have been none, one, or more strikers, in ms.
  const std::array<int, 3>& times() const { return ms_; }
  void breakDown(bool down) { down_ = down; }
  void switchOff(int number) { off_[static_cast<std::size_t>(number - 2)] = true; }
  void place(std::array<double, 3> x) { x_ = x; }

 private:
  struct Underway {
    int due;
    TeamMessage message;
  };
  RoleNegotiation::Parameters parameters_;
  std::array<RoleNegotiation, 3> players_{
      RoleNegotiation{parameters_}, RoleNegotiation{parameters_}, RoleNegotiation{parameters_}};
  std::array<TeamMessages, 3> heard_;
  std::array<bool, 3> off_{};
  std::array<double, 3> x_{-1000, 0, 500};
  std::deque<Underway> underway_;
  bool down_ = false;
  int now_ = 1000;
  std::array<int, 3> ms_{};
};

/// Player 3, the soonest, has been the striker for a while.
class SettledTeam : public Team {
 public:
  SettledTeam() { run(3000, {6000, 2000, 5000}); }
};

TEST(RoleNegotiation, TheSoonestBecomesStrikerAndTheMostForwardSupportsOffensively) {
  SettledTeam team;
  EXPECT_EQ(team.role(2), DynamicRole::defensiveSupporter);
  EXPECT_EQ(team.role(3), DynamicRole::striker);
  EXPECT_EQ(team.role(4), DynamicRole::offensiveSupporter);
  team.place({1000, 0, 500});
  team.run(2000, {6000, 2000, 5000});
  EXPECT_EQ(team.role(2), DynamicRole::offensiveSupporter);
  EXPECT_EQ(team.role(4), DynamicRole::defensiveSupporter);
}

TEST(RoleNegotiation, TheStrikerStaysUntilATeammateIsClearlySoonerForAWhile) {
  SettledTeam team;
  team.run(5000, {6000, 2000, 1000});
  EXPECT_EQ(team.role(3), DynamicRole::striker) << "hardly sooner";
  team.run(800, {6000, 5000, 1000});
  EXPECT_EQ(team.role(3), DynamicRole::striker) << "only just now";
  team.run(1000, {6000, 5000, 1000});
  EXPECT_EQ(team.role(4), DynamicRole::striker);
}

TEST(RoleNegotiation, TheStrikerActsUntilItHearsThatTheNewOneDoes) {
  SettledTeam team;
  const auto before = team.times();
  team.run(3000, {6000, 5000, 1000});
  EXPECT_EQ(team.role(4), DynamicRole::striker);
  EXPECT_EQ(team.role(3), DynamicRole::offensiveSupporter);
  EXPECT_EQ(team.times()[0], before[0]) << "never nobody";
  EXPECT_LE(team.times()[2] - before[2], 200) << "two for as long as a message takes";
}

TEST(RoleNegotiation, TheStrikerActsOnIfItsMessageIsLost) {
  SettledTeam team;
  team.run(1120, {6000, 5000, 1000});
  team.runApart(8000, {6000, 5000, 1000});
  EXPECT_EQ(team.strikers(), 1U);
  team.run(500, {6000, 5000, 1000});
  EXPECT_EQ(team.role(4), DynamicRole::striker);
  EXPECT_EQ(team.strikers(), 1U);
}

TEST(RoleNegotiation, WhoDoesNotPlayLeavesTheBallAtOnce) {
  SettledTeam team;
  team.run(200, {6000, RoleNegotiation::notAvailable, 5000});
  EXPECT_EQ(team.role(4), DynamicRole::striker);
  EXPECT_EQ(team.strikers(), 1U);
}

TEST(RoleNegotiation, WhoIsNotHeardAnyMoreIsReplaced) {
  SettledTeam team;
  team.switchOff(3);
  team.run(2500, {6000, 2000, 5000});
  EXPECT_EQ(team.strikers(), 0U);
  team.run(3000, {6000, 2000, 5000});
  EXPECT_EQ(team.role(4), DynamicRole::striker);
}

TEST(RoleNegotiation, ABreakOfTheNetworkMakesNoSecondStriker) {
  SettledTeam team;
  team.runApart(15000, {1000, 9000, 5000});
  EXPECT_EQ(team.strikers(), 1U);
  team.run(2000, {1000, 9000, 5000});
  EXPECT_EQ(team.role(2), DynamicRole::striker);
  EXPECT_EQ(team.strikers(), 1U);
}

TEST(RoleNegotiation, InAnHourWithBreaksThereIsOneStriker) {
  Team team;
  Random random{3};
  std::array<double, 3> times{3000, 4000, 5000};
  team.run(2000, times);
  const auto begin = team.times();
  bool down = false;
  for (int i = 0; i < 9000; ++i) {
    for (double& time : times) time = std::clamp(time + 2000 * random.symmetric(), 500., 9000.);
    if (random.chance(down ? 0.1 : 0.03)) team.breakDown(down = !down);  // down for 4 s in the mean
    team.run(400, times);
  }
  std::array<int, 3> ms = team.times();
  for (std::size_t i = 0; i < 3; ++i) ms[i] -= begin[i];
  const double all = std::accumulate(ms.begin(), ms.end(), 0.);
  RecordProperty("none", std::to_string(100 * ms[0] / all));
  RecordProperty("two", std::to_string(100 * ms[2] / all));
  EXPECT_LT(ms[2] / all, 0.005);
  EXPECT_LT(ms[0] / all, 0.01);
}

}  // namespace
}  // namespace gt
