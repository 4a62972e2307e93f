#include "simulation/Radio.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

std::vector<Player> twoTeams() {
  std::vector<Player> players;
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const PlayerRole role :
         {PlayerRole::goalie, PlayerRole::defender, PlayerRole::striker1, PlayerRole::striker2})
      players.push_back({team, role});
  return players;
}

TEST(Radio, OnlyTeamMatesHear) {
  Radio radio{{40, 120, 0}, twoTeams(), Random{1}};
  TeamMessage message;
  message.playerNumber = 77;  // the network knows better
  message.timeSent = {1000};
  radio.send(2, message, {1000});
  for (std::size_t i = 0; i < 8; ++i) {
    TeamMessages messages;
    radio.receive(i, {1039}, messages);
    EXPECT_EQ(messages.byPlayer[2].message.playerNumber, 0);
    radio.receive(i, {1121}, messages);
    const bool hears = i < 4 && i != 2;
    EXPECT_EQ(messages.byPlayer[2].message.playerNumber, hears ? 3 : 0) << i;
    EXPECT_EQ(messages.byPlayer[2].timeReceived, hears ? Time{1121} : never());
  }
}

TEST(Radio, DelayAndLossAreAsTheSceneSays) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Radio radio{{40, 120, 0.05}, twoTeams(), Random{seed}};
    int heard = 0;
    double sum = 0;
    std::int64_t least = 1000, most = 0;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i) {
      const Time sent{1000 * i};
      TeamMessage message;
      message.timeSent = sent;
      radio.send(0, message, sent);
      TeamMessages messages, others;
      for (std::int64_t t = 0; t < 200; ++t) radio.receive(1, sent + t, messages);
      for (const std::size_t mate : {2, 3}) radio.receive(mate, sent + 200, others);
      if (messages.byPlayer[0].timeReceived == never()) continue;
      ++heard;
      const std::int64_t delay = messages.byPlayer[0].timeReceived - sent;
      sum += static_cast<double>(delay);
      least = std::min(least, delay);
      most = std::max(most, delay);
    }
    EXPECT_NEAR(static_cast<double>(heard) / n, 0.95, 0.015);
    EXPECT_NEAR(sum / heard, 80, 2);
    EXPECT_GE(least, 40);
    EXPECT_LE(least, 42);
    EXPECT_LE(most, 120);
    EXPECT_GE(most, 118);
    // Three teammates, each of which loses its own 5 %.
    EXPECT_NEAR(static_cast<double>(radio.lost()) / (3 * n), 0.05, 0.01);
  }
}

TEST(Radio, AnOvertakenMessageIsDropped) {
  Radio radio{{0, 200, 0}, twoTeams(), Random{4}};
  TeamMessages messages;
  Time newest = never();
  for (std::int64_t t = 0; t < 4000; ++t) {
    TeamMessage message;
    message.timeSent = {t};
    if (t % 8 == 0) radio.send(3, message, {t});
    radio.receive(0, {t}, messages);
    ASSERT_GE(messages.byPlayer[3].message.timeSent, newest);
    newest = messages.byPlayer[3].message.timeSent;
  }
  EXPECT_GT(newest, Time{3800});
}

TEST(Radio, RobotsAreCutOffAndTheNetworkFails) {
  Radio radio{{0, 0, 0}, twoTeams(), Random{5}};
  const auto heard = [&](std::size_t sender, std::size_t receiver, std::int64_t ms) {
    TeamMessage message;
    message.timeSent = {ms};
    radio.send(sender, message, {ms});
    TeamMessages messages;
    radio.receive(receiver, {ms}, messages);
    return messages.byPlayer[sender].message.timeSent == Time{ms};
  };
  EXPECT_TRUE(heard(0, 1, 1));
  radio.cut(1, true);
  EXPECT_FALSE(heard(0, 1, 2));
  EXPECT_FALSE(heard(1, 0, 3));
  EXPECT_TRUE(heard(0, 2, 4));
  radio.cut(1, false);
  EXPECT_TRUE(heard(0, 1, 5));
  RadioParameters parameters = radio.parameters();
  parameters.out = true;
  radio.change(parameters);
  EXPECT_FALSE(heard(0, 2, 6));
}

TEST(Radio, BreaksDownInBursts) {
  RadioParameters parameters;
  parameters.delayMin = parameters.delayMax = parameters.loss = 0;
  parameters.bursts = 12;
  parameters.burstTime = 1.5;
  parameters.burstLoss = 0.9;
  const std::vector<Player> players = twoTeams();
  Radio radio{parameters, players, Random{6}};
  TeamMessages messages;
  constexpr int period = 100, minutes = 300;  // ms
  int lostInDown = 0, down = 0, breakdowns = 0;
  int quietSince = 1000;
  for (int ms = 0; ms < minutes * 60'000; ms += period) {
    TeamMessage message;
    message.timeSent = Time{ms};
    const std::size_t before = radio.lost();
    radio.send(0, message, Time{ms});
    const auto lost = static_cast<int>(radio.lost() - before);  // of three receivers
    if (lost > 0) {
      breakdowns += quietSince > 5;
      quietSince = 0;
      lostInDown += lost;
      ++down;
    } else {
      ++quietSince;
    }
    if (ms % 2000 == 0)
      for (std::size_t i = 0; i < players.size(); ++i) radio.receive(i, Time{ms}, messages);
  }
  // It works 5 s and is down 1.5 s on average.
  EXPECT_NEAR(down * period / (minutes * 60'000.0), 1.5 / 6.5, 0.04);
  EXPECT_NEAR(breakdowns / static_cast<double>(minutes), 60 / 6.5, 2);
  EXPECT_NEAR(lostInDown / (3.0 * down), 0.9, 0.02);
}

}  // namespace
}  // namespace gt
